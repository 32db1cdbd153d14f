#pragma once

#include <vector>

namespace swathplan {

/// A closed stretch of the across axis, metres, low <= high.
struct Interval {
  double low = 0.0, high = 0.0;
  bool operator==(const Interval&) const = default;
};

/// A union of stretches, kept sorted and apart from each other. Stretches less than a micrometre
/// apart become one, since their ends are rounded sums of the same few lengths.
class IntervalSet {
 public:
  /// Adds a stretch; an empty or reversed one changes nothing. O(log n + stretches swallowed).
  void add(Interval stretch);
  /// Whether the whole stretch lies in the union. O(log n).
  [[nodiscard]] bool covers(Interval stretch) const;
  /// Metres of `within` that the union covers.
  [[nodiscard]] double covered_m(Interval within) const;
  /// End of the covered run that holds `from`; `from` itself if it is not covered.
  [[nodiscard]] double run_end(double from) const;
  [[nodiscard]] const std::vector<Interval>& stretches() const { return stretches_; }

 private:
  std::vector<Interval> stretches_;
};

}  // namespace swathplan
