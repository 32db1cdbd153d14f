#pragma once

#include <optional>
#include <utility>
#include <vector>

namespace swathplan {

/// The height of still water at a time.
struct TideHeight {
  double time_s = 0.0;    ///< since 1970-01-01 00:00 UTC
  double height_m = 0.0;  ///< above the level that depths count from
};

/// A span of time, seconds since 1970-01-01 00:00 UTC.
struct TimeSpan {
  double from_s = 0.0, to_s = 0.0;
};

/// The tide between the rows of a table. Rows farther apart than kHighAndLowWaters are taken for
/// high and low waters, with a half cosine between them; others are joined by straights.
class Tide {
 public:
  /// `rows`: at least two, their times ascending; else it is a bug of the caller.
  explicit Tide(std::vector<TideHeight> rows);

  [[nodiscard]] const std::vector<TideHeight>& rows() const { return rows_; }
  [[nodiscard]] bool by_cosines() const { return cosines_; }
  /// Empty before the first row and behind the last.
  [[nodiscard]] std::optional<double> height_m(double time_s) const;
  /// When the water stands at `least_m` or higher, to kTideStepS.
  [[nodiscard]] std::vector<TimeSpan> spans_above(double least_m) const;

  static constexpr double kHighAndLowWaters = 3.0 * 3600.0;
  static constexpr double kTideStepS = 60.0;

 private:
  std::vector<TideHeight> rows_;
  bool cosines_ = false;
};

}  // namespace swathplan
