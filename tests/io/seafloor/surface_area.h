#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "io/grids/surface_data.h"

namespace swathplan::test {

/// Twice the area of a face seen from above; negative if the face looks down.
inline double twice_plan_area(const SurfaceData& data, const std::array<std::uint32_t, 3>& face) {
  const Vec2 ab = (data.vertices[face[1]] - data.vertices[face[0]]).head<2>();
  const Vec2 ac = (data.vertices[face[2]] - data.vertices[face[0]]).head<2>();
  return ab.x() * ac.y() - ab.y() * ac.x();
}

inline double plan_area(const SurfaceData& data) {
  double twice = 0.0;
  for (const auto& face : data.faces) twice += twice_plan_area(data, face);
  return 0.5 * twice;
}

[[nodiscard]] inline bool all_faces_look_up(const SurfaceData& data) {
  return std::all_of(data.faces.begin(), data.faces.end(),
                     [&](const auto& face) { return twice_plan_area(data, face) > 0.0; });
}

}  // namespace swathplan::test
