#include "planners/wording.h"

#include <fmt/format.h>

#include <cmath>

namespace swathplan {

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  if (count == 1) return fmt::format("1 {}", one);
  return many.empty() ? fmt::format("{} {}s", count, one) : fmt::format("{} {}", count, many);
}

int axis_degrees(double azimuth_deg) {
  const int whole = static_cast<int>(std::lround(std::fmod(azimuth_deg, 180.0)));
  return (whole + 180) % 180;
}

std::string azimuth_text(double grid_azimuth_deg, double grid_north_deg) {
  constexpr double kUnsteered = 0.05;  // degrees that nobody steers by
  const auto axis = [](double deg) {
    const double tenths = std::round(10.0 * (std::fmod(deg, 180.0) + 180.0)) / 10.0;
    return std::fmod(tenths, 180.0);
  };
  if (std::abs(grid_north_deg) < kUnsteered) {
    return fmt::format("{} degrees", axis_degrees(grid_azimuth_deg));
  }
  return fmt::format("{:g} degrees true ({:g} of the grid)",
                     axis(grid_azimuth_deg + grid_north_deg), axis(grid_azimuth_deg));
}

std::string ended_early_note(std::size_t tried, std::string_view one, std::string_view many) {
  return fmt::format("search ended early: the best of the {} tried by then was kept",
                     counted(tried, one, many));
}

}  // namespace swathplan
