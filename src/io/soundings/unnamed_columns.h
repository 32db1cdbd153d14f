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
  /// True if degrees, minutes and seconds stand in columns of their own.
  [[nodiscard]] bool is_angle_in_parts() const;
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
  std::size_t rows_ = 0, fewest_ = kMost, alike_ = 0;
  std::vector<double> first_;  ///< column 1 while it holds whole numbers
};

}  // namespace swathplan
