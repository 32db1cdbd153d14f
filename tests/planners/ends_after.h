#pragma once

#include <string>
#include <vector>

#include "mesh/base/watch.h"

namespace swathplan::test {

/// Ends a search after a number of candidates, and keeps what it was told.
class EndsAfter final : public Watcher {
 public:
  explicit EndsAfter(std::size_t candidates) : candidates_(candidates) {}
  void phase(const std::string& what) override { phases.push_back(what); }
  void share(double) override {}
  void tried(std::size_t, std::size_t, const std::string& best) override {
    ++count;
    if (!best.empty()) bests.push_back(best);
  }
  [[nodiscard]] bool ended() const override { return count >= candidates_; }

  std::size_t count = 0;
  std::vector<std::string> phases, bests;

 private:
  std::size_t candidates_;
};

}  // namespace swathplan::test
