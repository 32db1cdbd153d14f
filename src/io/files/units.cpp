#include "io/files/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "io/files/text.h"

namespace swathplan {

std::optional<double> metres_in(std::string_view unit) {
  constexpr double kUsFoot = 1200.0 / 3937.0;
  static constexpr std::array<std::pair<std::string_view, double>, 42> kUnits{{
      {"m", 1.0},
      {"metre", 1.0},
      {"metres", 1.0},
      {"meter", 1.0},
      {"meters", 1.0},
      {"ft", 0.3048},
      {"foot", 0.3048},
      {"feet", 0.3048},
      {"international foot", 0.3048},
      {"international feet", 0.3048},
      {"us survey foot", kUsFoot},
      {"us survey feet", kUsFoot},
      {"us foot", kUsFoot},
      {"us feet", kUsFoot},
      {"us ft", kUsFoot},
      {"ftus", kUsFoot},
      {"foot us", kUsFoot},
      {"usft", kUsFoot},
      {"survey foot", kUsFoot},
      {"fathom", 1.8288},
      {"fathoms", 1.8288},
      {"fm", 1.8288},
      {"cm", 0.01},
      {"centimetre", 0.01},
      {"centimetres", 0.01},
      {"centimeter", 0.01},
      {"centimeters", 0.01},
      {"dm", 0.1},
      {"decimetre", 0.1},
      {"decimeter", 0.1},
      {"mm", 0.001},
      {"millimetre", 0.001},
      {"millimeter", 0.001},
      {"km", 1000.0},
      {"kilometre", 1000.0},
      {"kilometer", 1000.0},
      {"yard", 0.9144},
      {"yd", 0.9144},
      {"mile", 1609.344},
      {"miles", 1609.344},
      {"nautical mile", 1852.0},
      {"nautical miles", 1852.0},
  }};
  std::string name = lower(trim(unit));
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '_' || c == '-' || c == '.'; }, ' ');
  const auto* const found =
      std::find_if(kUnits.begin(), kUnits.end(), [&](const auto& u) { return u.first == name; });
  if (found == kUnits.end()) return {};
  return found->second;
}

namespace {

constexpr std::pair<std::string_view, double> kMarks[] = {
    {"m", 1.0}, {"ft", 0.3048}, {"us_ft", 1200.0 / 3937.0}};
/// Files write a foot to eight digits or more; the two feet differ in the sixth.
constexpr double kSameUnit = 5e-8;

}  // namespace

std::string_view unit_mark(double metres_per_unit) {
  for (const auto& [mark, metres] : kMarks) {
    if (std::abs(metres_per_unit - metres) < kSameUnit) return mark;
  }
  return "crs";
}

std::optional<double> metres_of_mark(std::string_view mark) {
  for (const auto& [known, metres] : kMarks) {
    if (mark == known) return metres;
  }
  return {};
}

}  // namespace swathplan
