#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <vector>

#include "coverage/score.h"
#include "mesh/survey_area.h"

namespace swathplan::testing {

/// Axis-aligned rectangle.
inline Area rectangle(double x0, double y0, double x1, double y1) {
  return {{{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {}}};
}

/// A flat plate with lower-left corner (x0, y0), two triangles.
inline void add_plate(Seafloor& s, double x0, double y0, double x1, double y1, double depth) {
  const auto base = static_cast<std::uint32_t>(s.vertices.size());
  s.vertices.insert(s.vertices.end(),
                    {{x0, y0, -depth}, {x1, y0, -depth}, {x1, y1, -depth}, {x0, y1, -depth}});
  s.faces.push_back({base, base + 1, base + 2});
  s.faces.push_back({base, base + 2, base + 3});
}

/// n x n nodes one metre apart at random depths between 5 and 12 m; `holes` of the quads left out.
inline Seafloor rough_floor(std::uint32_t n, double holes, unsigned seed, const Vec2& at) {
  std::mt19937 random(seed);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  Seafloor s;
  for (std::uint32_t r = 0; r < n; ++r) {
    for (std::uint32_t c = 0; c < n; ++c) {
      s.vertices.emplace_back(at.x() + c, at.y() + r, -5.0 - 7.0 * uniform());
    }
  }
  for (std::uint32_t r = 0; r + 1 < n; ++r) {
    for (std::uint32_t c = 0; c + 1 < n; ++c) {
      if (uniform() < holes) continue;
      const std::uint32_t a = r * n + c;
      s.faces.push_back({a, a + 1, a + n + 1});
      s.faces.push_back({a, a + n + 1, a + n});
    }
  }
  return s;
}

/// A route through points with one fan, all lines, logged.
inline Route route_through(const std::vector<Vec2>& points, const FanAngles& fan) {
  Route route;
  for (const Vec2& p : points) {
    Waypoint w;
    w.position = p;
    w.fan = fan;
    route.waypoints.push_back(w);
  }
  route.waypoints.back().kind = LegKind::end;
  return route;
}

/// A seafloor with all that scoring needs, kept alive together.
struct TestGround {
  TestGround(Seafloor s, Nodata nodata, Area area)
      : seafloor(std::move(s)), depths(seafloor), scene(seafloor, nodata) {
    ground = {&seafloor, &depths, area, area, &scene};
  }
  TestGround(const TestGround&) = delete;
  TestGround& operator=(const TestGround&) = delete;

  Seafloor seafloor;
  DepthQuery depths;
  RayScene scene;
  swathplan::Ground ground;
};

inline Eigen::Vector3f direction(double azimuth_deg, double from_nadir_deg) {
  const double a = Angle::degrees(azimuth_deg).rad();
  const double t = Angle::degrees(from_nadir_deg).rad();
  return Eigen::Vector3d(std::sin(t) * std::sin(a), std::sin(t) * std::cos(a), -std::cos(t))
      .cast<float>();
}

inline RayHit trace_one(const RayScene& scene, const Vec3& origin, const Eigen::Vector3f& d) {
  RayHit hit;
  scene.trace(origin, {&d, 1}, {&hit, 1});
  return hit;
}

}  // namespace swathplan::testing
