#include "io/water/tide_import.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "io/files/text.h"
#include "io/water/times.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

struct TideRow {
  std::size_t line = 0;
  TideHeight at;
};

[[noreturn]] void fail_in_tide(const std::filesystem::path& path, std::size_t line,
                               const std::string& what) {
  throw InvalidInput(fmt::format("'{}', line {}: {}", path.string(), line, what));
}

char separator_in(std::string_view line) {
  for (const char c : {'\t', ';', ','}) {
    if (line.find(c) != std::string_view::npos) return c;
  }
  return ' ';
}

bool names(std::string_view field, const std::vector<const char*>& words) {
  const std::string low = lower(field);
  return std::any_of(words.begin(), words.end(),
                     [&](const char* word) { return low.find(word) != std::string::npos; });
}

/// Which columns hold time and height.
struct TideColumns {
  std::size_t time = 0, height = 1;
};

TideColumns columns_of(const std::vector<std::string_view>& header) {
  TideColumns columns;
  for (std::size_t i = header.size(); i-- > 0;) {
    if (names(header[i], {"time", "date"})) columns.time = i;
    if (names(header[i], {"height", "level", "water", "tide"})) columns.height = i;
  }
  return columns;
}

/// '1.25' or '1,25'.
std::optional<double> height_of(std::string_view field) {
  std::string text(field);
  std::replace(text.begin(), text.end(), ',', '.');
  return to_finite_number(text);
}

std::vector<TideRow> rows_of(const std::string& text, const std::filesystem::path& path) {
  std::vector<TideRow> rows;
  TideColumns columns;
  std::size_t line = 0;
  bool first = true;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view row = trim(std::string_view(text).substr(at, end - at));
    at = end + 1;
    ++line;
    if (row.empty() || row.starts_with('#')) continue;
    std::vector<std::string_view> fields = split(row, separator_in(row));
    const bool header = first && !time_of(fields.front()) && names(row, {"time", "date"});
    first = false;
    if (header) {
      columns = columns_of(fields);
      continue;
    }
    if (fields.size() <= std::max(columns.time, columns.height)) {
      fail_in_tide(path, line, "must hold a time and a height, with a comma between them");
    }
    const auto time = time_of(fields[columns.time]);
    if (!time) {
      fail_in_tide(path, line,
                   fmt::format("'{}' is no time; write it as 2026-05-01T06:30 (UTC)",
                               quotable(fields[columns.time])));
    }
    const auto height = height_of(fields[columns.height]);
    if (!height) {
      fail_in_tide(path, line,
                   fmt::format("'{}' is no height in metres", quotable(fields[columns.height])));
    }
    rows.push_back({line, {*time, *height}});
  }
  return rows;
}

void check_order(const std::vector<TideRow>& rows, const std::filesystem::path& path) {
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i].at.time_s > rows[i - 1].at.time_s) continue;
    fail_in_tide(path, rows[i].line,
                 fmt::format("{} does not come after {} of the row before: sort the table by time "
                             "and take out what is there twice",
                             time_text(rows[i].at.time_s), time_text(rows[i - 1].at.time_s)));
  }
}

/// Most rows are as far apart as the middle one of all spaces.
void check_gaps(const std::vector<TideRow>& rows, const std::filesystem::path& path) {
  std::vector<double> spaces;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    spaces.push_back(rows[i].at.time_s - rows[i - 1].at.time_s);
  }
  std::vector<double> sorted = spaces;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  for (std::size_t i = 0; i < spaces.size(); ++i) {
    if (spaces[i] <= kWidestGap * *middle) continue;
    fail_in_tide(
        path, rows[i + 1].line,
        fmt::format("a gap of {:.1f} h before {}, where rows are {:.1f} h apart: fill it "
                    "in, or give the part of the table that the survey needs",
                    spaces[i] / 3600.0, time_text(rows[i + 1].at.time_s), *middle / 3600.0));
  }
}

/// High and low waters take turns: two of a kind in a row mean that one between them is missing.
void check_turns(const std::vector<TideRow>& rows, const std::filesystem::path& path) {
  for (std::size_t i = 2; i < rows.size(); ++i) {
    const double before = rows[i - 1].at.height_m - rows[i - 2].at.height_m;
    const double now = rows[i].at.height_m - rows[i - 1].at.height_m;
    if (before * now < 0.0) continue;
    fail_in_tide(
        path, rows[i].line,
        fmt::format("rows so far apart are high and low waters in turn, but {:.2f}, {:.2f} "
                    "and {:.2f} m are not: fill in the water that is missing, or give "
                    "heights each hour or oftener",
                    rows[i - 2].at.height_m, rows[i - 1].at.height_m, rows[i].at.height_m));
  }
}

void check_heights(const std::vector<TideRow>& rows, const std::filesystem::path& path) {
  constexpr double kLargest = 25.0;  // the largest tides of all rise 17 m
  for (const TideRow& row : rows) {
    if (std::abs(row.at.height_m) <= kLargest) continue;
    fail_in_tide(path, row.line,
                 fmt::format("no tide stands at {:g} m: give heights in metres above chart datum",
                             row.at.height_m));
  }
}

}  // namespace

ImportedTide import_tide(const std::filesystem::path& path) {
  const std::vector<TideRow> rows = rows_of(read_text(path), path);
  if (rows.size() < 2) {
    throw InvalidInput(
        fmt::format("'{}' holds {} of a tide; a table needs at least two, as 2026-05-01T06:30,1.25",
                    path.string(), rows.empty() ? "no row" : "one row"));
  }
  check_order(rows, path);
  check_gaps(rows, path);
  check_heights(rows, path);
  std::vector<TideHeight> heights;
  for (const TideRow& row : rows) heights.push_back(row.at);
  const auto [low, high] = std::minmax_element(
      heights.begin(), heights.end(),
      [](const TideHeight& a, const TideHeight& b) { return a.height_m < b.height_m; });
  ImportedTide read{Tide(heights), {}};
  if (read.tide.by_cosines()) check_turns(rows, path);
  read.notes.push_back(fmt::format("tide of '{}': {} rows from {} to {}, {:.2f} to {:.2f} m{}",
                                   path.filename().string(), rows.size(),
                                   time_text(heights.front().time_s),
                                   time_text(heights.back().time_s), low->height_m, high->height_m,
                                   read.tide.by_cosines() ? ", taken as high and low waters" : ""));
  return read;
}

}  // namespace swathplan
