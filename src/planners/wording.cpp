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

}  // namespace swathplan
