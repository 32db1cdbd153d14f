#include "io/soundings/unnamed_columns.h"

#include <algorithm>
#include <cmath>

namespace swathplan {
namespace {

/// No seafloor is as deep: metres, feet or decimetres.
constexpr double kLargestDepth = 120'000.0;
/// A row of a matrix holds values that differ by less than this share of their middle one.
constexpr double kAlike = 0.5;
constexpr double kAlikeRows = 0.9;

/// True if neighbours in a field of depths could be as the row is.
bool is_row_of_depths(std::vector<double> values) {
  if (values.size() < 4) return false;
  std::sort(values.begin(), values.end());
  const double middle = values[values.size() / 2];
  const double most = kAlike * std::abs(middle);
  return middle != 0.0 && middle - values.front() <= most && values.back() - middle <= most;
}

}  // namespace

void UnnamedColumns::add(const std::vector<std::string_view>& fields, const RowStyle& style) {
  ++rows_;
  std::size_t n = fields.size();
  while (n > 0 && fields[n - 1].empty()) --n;  // a separator at the end of the row
  fewest_ = std::min(fewest_, n);
  most_ = std::max(most_, n);
  std::vector<double> values;
  for (std::size_t i = 0; i < std::min(n, kMost); ++i) {
    Column& column = columns_.at(i);
    const std::optional<double> value = number_of(fields[i], style);
    if (!value || !std::isfinite(*value)) {
      column.numbers = column.numbers && value.has_value();
      column.integers = column.rising = false;
      continue;
    }
    values.push_back(*value);
    column.integers = column.integers && std::floor(*value) == *value;
    column.rising = column.rising && *value > column.last;
    column.last = *value;
    column.low = std::min(column.low, *value);
    column.high = std::max(column.high, *value);
  }
  if (columns_[0].integers) first_.push_back(columns_[0].last);
  if (values.size() == n && is_row_of_depths(values)) ++alike_;
}

bool UnnamedColumns::is_matrix() const {
  return fewest_ >= 4 && static_cast<double>(alike_) >= kAlikeRows * static_cast<double>(rows_);
}

bool UnnamedColumns::is_date_first() const {
  const auto& c = columns_;
  if (fewest_ < 6) return false;
  const bool year_first =
      c[0].whole_from_to(1900, 2100) && c[1].whole_from_to(1, 12) && c[2].whole_from_to(1, 31);
  const bool year_last =
      c[2].whole_from_to(1900, 2100) && c[1].whole_from_to(1, 31) && c[0].whole_from_to(1, 31);
  return year_first || year_last;
}

std::size_t UnnamedColumns::date_columns() const {
  constexpr std::size_t kDate = 3, kDateAndTime = 6, kPlace = 3;
  const auto& c = columns_;
  if (!is_date_first() || most_ != fewest_) return 0;
  for (std::size_t i = fewest_ - kPlace; i < std::min(fewest_, kMost); ++i) {
    if (!c.at(i).numbers) return 0;
  }
  if (fewest_ == kDate + kPlace) return kDate;
  const bool time = c[3].whole_from_to(0, 23) && c[4].whole_from_to(0, 59) && c[5].from_to(0, 61);
  return fewest_ == kDateAndTime + kPlace && time ? kDateAndTime : 0;
}

std::size_t UnnamedColumns::angle_parts() const {
  const auto& c = columns_;
  const auto degrees = [&](std::size_t i) { return c.at(i).whole_from_to(-180, 360); };
  const auto sixty = [&](std::size_t i) { return c.at(i).from_to(0, 59.9999999); };
  const bool seconds = most_ >= 7 && degrees(0) && c[1].integers && sixty(1) && sixty(2) &&
                       degrees(3) && c[4].integers && sixty(4) && sixty(5);
  const bool minutes = fewest_ >= 5 && degrees(0) && sixty(1) && !c[1].integers && degrees(2) &&
                       c[2].low >= 0 && sixty(3) && !c[3].integers;
  return seconds ? 3 : minutes ? 2 : 0;
}

bool UnnamedColumns::is_counter_first() const {
  if (fewest_ < 4 || rows_ < 3 || !columns_[0].numbers || !columns_[0].integers) return false;
  if (!columns_[3].numbers) return false;  // then only columns 1 to 3 can hold x, y and z
  if (columns_[0].rising) return true;
  if (columns_[1].integers && columns_[2].integers) return false;
  std::vector<double> sorted = first_;
  std::sort(sorted.begin(), sorted.end());
  return std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
}

std::string UnnamedColumns::doubt() const {
  const auto& c = columns_;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!c.at(i).numbers) return "column " + std::to_string(i + 1) + " does not hold numbers";
  }
  if (is_date_first()) return "columns 1 to 3 look like a date";
  if (is_counter_first()) return "column 1 looks like the numbers of points";
  if (std::min(std::abs(c[2].low), std::abs(c[2].high)) > kLargestDepth) {
    return "column 3 holds numbers that are too large for a depth";
  }
  if (fewest_ >= 4 && rows_ >= 3 && c[2].low == c[2].high) {
    const bool other =
        std::any_of(c.begin() + 3, c.begin() + static_cast<std::ptrdiff_t>(fewest_),
                    [](const Column& x) { return x.numbers && x.low < x.high && !x.integers; });
    if (other) return "column 3 holds one and the same number in all rows";
  }
  if (fewest_ >= kMost) return "there are many columns";
  return {};
}

}  // namespace swathplan
