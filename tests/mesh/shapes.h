#pragma once

#include <cmath>
#include <numbers>
#include <random>

#include "mesh/plane/polygons.h"

namespace swathplan::test {

inline Ring box(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

inline Area box_area(double x0, double y0, double x1, double y1) {
  return from_rings({box(x0, y0, x1, y1)}, true);
}

/// A star-shaped area with a wavy outline, seeded.
inline Area blob(double x, double y, double radius, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1.0p-53; };
  const double a = 0.25 * unit();
  const double b = 0.2 * unit();
  const double phase = 6.0 * unit();
  Ring ring;
  constexpr int kCorners = 70;
  for (int i = 0; i < kCorners; ++i) {
    const double t = 2.0 * std::numbers::pi * i / kCorners;
    const double r = radius * (1.0 + a * std::sin(3.0 * t + phase) + b * std::cos(5.0 * t - phase));
    ring.emplace_back(x + r * std::cos(t), y + r * std::sin(t));
  }
  return from_rings({ring}, true);
}

}  // namespace swathplan::test
