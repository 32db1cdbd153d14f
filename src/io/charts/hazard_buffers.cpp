#include "io/charts/hazard_buffers.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/files/text.h"

namespace swathplan {
namespace {

/// The width of a line on paper: what lies closer together cannot be told apart (S-4, B-200).
constexpr double kDrawnM = 0.0003;
/// Without a scale or any other word.
constexpr double kNotSaidM = 50.0;

}  // namespace

const HazardClass* hazard_class(std::string_view layer) {
  const std::string name = lower(layer);
  const auto* found = std::find_if(kHazardClasses.begin(), kHazardClasses.end(),
                                   [&](const HazardClass& c) { return lower(c.layer) == name; });
  return found == kHazardClasses.end() ? nullptr : found;
}

double quapos_m(int quapos) {
  switch (quapos) {
    case 2:  // unsurveyed
    case 3:  // inadequately surveyed
    case 9:  // estimated
      return 100.0;
    case 4:  // approximate: within 30.5 m, as S-57 has it
      return 30.5;
    case 5:  // position doubtful
    case 6:  // unreliable
    case 7:  // reported, not surveyed
    case 8:  // reported, not confirmed
      return 200.0;
    default:  // surveyed, precisely known, calculated
      return 0.0;
  }
}

double catzoc_m(int catzoc) {
  switch (catzoc) {
    case 1:  // A1: 5 m and 5 % of the depth, here for up to 100 m of it
      return 10.0;
    case 2:
      return 20.0;
    case 3:
      return 50.0;
    case 4:
    case 5:  // D: worse than C
      return 500.0;
    default:
      return 0.0;
  }
}

std::string catzoc_name(int catzoc) {
  constexpr std::array kNames{"A1", "A2", "B", "C", "D", "U"};
  return catzoc >= 1 && catzoc <= 6 ? kNames.at(static_cast<std::size_t>(catzoc) - 1)
                                    : fmt::format("{}", catzoc);
}

PositionAccuracy position_accuracy(const StatedPosition& stated, bool is_danger) {
  if (stated.posacc_m) return {*stated.posacc_m, "POSACC"};
  PositionAccuracy worst =
      stated.scale > 0
          ? PositionAccuracy{kDrawnM * stated.scale, fmt::format("scale 1:{}", stated.scale)}
          : PositionAccuracy{kNotSaidM, "nothing"};
  if (stated.quapos && quapos_m(*stated.quapos) > worst.metres) {
    worst = {quapos_m(*stated.quapos), fmt::format("QUAPOS {}", *stated.quapos)};
  }
  if (is_danger && stated.catzoc && catzoc_m(*stated.catzoc) > worst.metres) {
    worst = {catzoc_m(*stated.catzoc), "CATZOC " + catzoc_name(*stated.catzoc)};
  }
  return worst;
}

}  // namespace swathplan
