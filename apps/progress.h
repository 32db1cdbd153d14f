#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace swathplan {

/// A progress bar on stderr with the rate and the time left. Silent if stderr is no terminal.
class ProgressBar {
 public:
  ProgressBar(std::string label, bool quiet);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// `share` done in [0, 1], `rays` traced so far.
  void show(double share, std::uint64_t rays);

 private:
  std::string label_;
  bool active_;
  std::chrono::steady_clock::time_point start_, shown_;
};

}  // namespace swathplan
