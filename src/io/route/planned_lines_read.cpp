#include "io/route/planned_lines_read.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/files/text.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

[[noreturn]] void fail_in_row(const std::string& file, std::size_t row, const std::string& what) {
  throw InvalidInput(fmt::format("'{}', line {}: {}", file, row, what));
}

bool is_quoted_name(std::string_view line) {
  return line.size() >= 2 && line.front() == '"' && line.back() == '"' &&
         std::count(line.begin(), line.end(), '"') == 2;
}

/// The number of a line from its name: 3 of '3', '3_2' and 'Line_3'.
std::optional<int> number_in(std::string_view name) {
  if (lower(name).starts_with("line_")) name.remove_prefix(5);
  return whole_number(name.substr(0, name.find('_')));
}

/// The separator of a row of numbers; a comma is never a decimal one.
char separator_of(std::string_view line) {
  for (const char c : {',', ';', '\t'}) {
    if (line.find(c) != std::string_view::npos) return c;
  }
  return ' ';
}

/// Lines of a text as they stand there, without their ends.
std::vector<std::string_view> raw_lines(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    lines.push_back(trim(text.substr(0, end)));
    if (end == std::string_view::npos) break;
    text.remove_prefix(end + 1);
  }
  return lines;
}

}  // namespace

bool is_rln(std::string_view text) {
  for (const std::string_view line : raw_lines(text.substr(0, 4000))) {
    if (line.empty() || line.starts_with('#')) continue;
    return is_quoted_name(line);
  }
  return false;
}

ForeignRoute parse_route_rln(std::string_view text, const std::string& file) {
  ForeignRoute route{.in_degrees = false, .parts = {}, .notes = {}};
  const auto lines = raw_lines(text);
  std::optional<int> number;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].empty() || lines[i].starts_with('#')) continue;
    if (is_quoted_name(lines[i])) {
      number = number_in(lines[i].substr(1, lines[i].size() - 2));
      route.parts.emplace_back();
      continue;
    }
    if (route.parts.empty()) fail_in_row(file, i + 1, "a name in quotation marks must stand first");
    const auto fields = split(lines[i], separator_of(lines[i]));
    const auto x = fields.size() < 2 ? std::nullopt : to_finite_number(fields[0]);
    const auto y = fields.size() < 2 ? std::nullopt : to_finite_number(fields[1]);
    if (!x || !y) fail_in_row(file, i + 1, "must hold easting, northing and kilometres");
    route.parts.back().push_back(
        {.place = Vec2(*x, *y), .line = number, .speed_mps = std::nullopt});
  }
  route.notes.emplace_back(
      "runlines name no coordinate reference system: that of the seafloor's file was taken");
  return route;
}

bool is_asciiplan(std::string_view text) {
  const auto lines = raw_lines(text.substr(0, 4000));
  if (lines.empty() || lines[0].find_first_of(" ,;\t") != std::string_view::npos) return false;
  return std::any_of(lines.begin(), lines.end(),
                     [](std::string_view line) { return line.starts_with("_LINE "); });
}

ForeignRoute parse_route_asciiplan(std::string_view text, const std::string& file) {
  constexpr std::size_t kPlaces = 5;  // behind _LINE, name, number, time, 0
  ForeignRoute route;
  const auto lines = raw_lines(text);
  if (lower(lines.front()) != "deg") {
    fail_in_row(file, 1,
                fmt::format("'{}' is no unit of places that can be read; save the lines "
                            "in degrees (DEG)",
                            quotable(lines.front())));
  }
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (!lines[i].starts_with("_LINE ")) continue;
    auto fields = split(lines[i], ' ');
    if (!fields.empty() && fields.back() == "\"") fields.pop_back();
    if (fields.size() < kPlaces + 4 || (fields.size() - kPlaces) % 2 != 0) {
      fail_in_row(file, i + 1,
                  "must hold a name, a number, a time, 0 and at least two pairs of latitude and "
                  "longitude");
    }
    route.parts.emplace_back();
    for (std::size_t k = kPlaces; k < fields.size(); k += 2) {
      const auto lat = to_finite_number(fields[k]);
      const auto lon = to_finite_number(fields[k + 1]);
      if (!lat || !lon) {
        fail_in_row(file, i + 1,
                    fmt::format("'{} {}' is no latitude and longitude", quotable(fields[k]),
                                quotable(fields[k + 1])));
      }
      route.parts.back().push_back(
          {.place = Vec2(*lon, *lat), .line = number_in(fields[1]), .speed_mps = std::nullopt});
    }
  }
  return route;
}

}  // namespace swathplan
