#pragma once

#include <cmath>

namespace swathplan {

/// The longest of 1, 2, 5 times a power of ten that is no more than `metres` (> 0).
[[nodiscard]] inline double round_length(double metres) {
  const double power = std::pow(10.0, std::floor(std::log10(metres)));
  const double lead = metres / power;
  return (lead >= 5.0 ? 5.0 : lead >= 2.0 ? 2.0 : 1.0) * power;
}

}  // namespace swathplan
