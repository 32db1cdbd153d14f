#pragma once

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <string>
#include <thread>

#include "mesh/base/watch.h"

namespace swathplan {

/// What of a run a terminal shows: one line on stderr with the phase, what was tried, the best so
/// far, the time gone and about what is left. Silent where stderr is no terminal.
struct Showing {
  std::string phase;  ///< empty: nothing to show
  double share = 0.0;
  std::size_t tried = 0, of = 0;
  std::string best;
  std::chrono::duration<double> gone{0.0}, of_phase{0.0};
};
/// The line, without line end, cut to `columns` bytes: between two of its parts, if it can be.
[[nodiscard]] std::string line_of(const Showing& showing, std::size_t columns);

/// Shows how a command gets on, and decides what Ctrl-C does. The program stops at once, with exit
/// code 130 and without half outputs, at the first Ctrl-C; once search() was called, at the second:
/// the first one ends the search. A Ctrl-C that the caller of the program ignores stays ignored.
/// One at a time; it begins before the work of a command and must outlive it.
class TerminalWatch final : public Watcher {
 public:
  /// `quiet`: shows nothing. `folder`: where outputs go; what is unfinished there is removed when
  /// the program stops.
  explicit TerminalWatch(bool quiet, std::filesystem::path folder = {});
  ~TerminalWatch() override;

  void phase(const std::string& what) override;
  void share(double done) override;
  void tried(std::size_t count, std::size_t of, const std::string& best) override;
  [[nodiscard]] bool ended() const override;

  /// From now on there is something to keep.
  void search();
  /// Phases are shown under this title from now on; empty: under none.
  void under(const std::string& title);
  /// Takes the line off the terminal until the next phase, so that others can print.
  void rest();
  /// As long as it lives the program does not stop: outputs are written whole.
  [[nodiscard]] std::unique_lock<std::mutex> writing();

 private:
  void watch();
  void draw();
  void clear();
  [[noreturn]] void stop();

  const bool shows_;
  const std::filesystem::path folder_;
  const std::chrono::steady_clock::time_point start_;
  std::mutex state_, writing_;
  std::condition_variable wake_;
  Showing showing_;
  std::string title_;
  std::chrono::steady_clock::time_point phase_start_;
  bool searches_ = false, over_ = false, drawn_ = false, said_ = false;
  std::thread thread_;
};

}  // namespace swathplan
