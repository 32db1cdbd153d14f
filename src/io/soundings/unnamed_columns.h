#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "io/soundings/sounding_columns.h"

namespace swathplan {

/// Judges rows of more than three columns without names: are the first three x, y and z?
class UnnamedColumns {
 public:
  void add(const std::vector<std::string_view>& fields, const RowStyle& style);

  /// True if the rows look like a matrix of depths without places.
  [[nodiscard]] bool is_matrix() const;
  /// How many columns each of two angles takes at the beginning of the rows: 3 for degrees, minutes
  /// and seconds, 2 for degrees and minutes, 0 if there are no such angles.
  [[nodiscard]] std::size_t angle_parts() const;
  /// How many columns a date, or a date and a time of day, takes before the only three others; 0 if
  /// there is none.
  [[nodiscard]] std::size_t date_columns() const;
  /// Why the first three columns may not be x, y and z ('column 1 holds ...'); empty if nothing
  /// speaks against it.
  [[nodiscard]] std::string doubt() const;

 private:
  static constexpr std::size_t kMost = 12;
  struct Column {
    bool numbers = true, integers = true, rising = true;
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    double last = -std::numeric_limits<double>::infinity();
    [[nodiscard]] bool whole_from_to(double from, double to) const {
      return numbers && integers && low >= from && high <= to;
    }
    [[nodiscard]] bool from_to(double from, double to) const {
      return numbers && low >= from && high <= to;
    }
  };

  [[nodiscard]] bool is_date_first() const;
  [[nodiscard]] bool is_counter_first() const;

  std::array<Column, kMost> columns_{};
  std::size_t rows_ = 0, fewest_ = kMost, most_ = 0, alike_ = 0;
  std::vector<double> first_;  ///< column 1 while it holds whole numbers
};

}  // namespace swathplan
