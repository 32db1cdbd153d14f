#include "planners/fronts/headland.h"

#include <cmath>

#include "planners/fronts/field_lines.h"
#include "planners/fronts/level_lines.h"

namespace swathplan {
namespace {

/// From the line to the inner edge of its swath.
constexpr double kHalf = 0.5;
/// The level needs cells on its far side.
constexpr double kBeyondEdge = 0.1;

void add_walls(const Ring& ring, const AreaQuery& water, double room_m, double step_m,
               std::vector<SurveyCurve>& walls) {
  SurveyCurve wall;
  const auto end_wall = [&] {
    if (wall.points.size() > 1) walls.push_back(wall);
    wall.points.clear();
  };
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2& a = ring[i];
    const Vec2 way = ring[(i + 1) % ring.size()] - a;
    const double length = way.norm();
    if (!(length > 0.0)) continue;
    const Vec2 aside = Vec2(-way.y(), way.x()) / length * room_m;
    const double parts = std::ceil(length / step_m);
    for (double k = 0.0; k < parts; ++k) {
      const Vec2 p = a + (k + 0.5) / parts * way;
      // One side is the area itself; a wall has no room on the other.
      const bool room = water.contains(p + aside) && water.contains(p - aside);
      if (room) {
        end_wall();
        continue;
      }
      if (wall.points.empty()) wall.points.push_back(a + k / parts * way);
      wall.points.push_back(a + (k + 1.0) / parts * way);
    }
  }
  end_wall();
}

}  // namespace

std::vector<SurveyCurve> walls_without_room(const Area& survey_area, const AreaQuery& water,
                                            double room_m, double step_m) {
  std::vector<SurveyCurve> walls;
  for (const Polygon& polygon : survey_area) {
    add_walls(polygon.outer, water, room_m, step_m, walls);
    for (const Ring& hole : polygon.holes) add_walls(hole, water, room_m, step_m, walls);
  }
  return walls;
}

Headland headland_along(const std::vector<SurveyCurve>& walls, const WaterRaster& raster,
                        const std::vector<float>& width, const HeadlandOptions& options) {
  const double inner_edge = options.from_wall + kHalf;
  Headland headland;
  headland.inner.resize(raster.size(), 0);
  const Front front =
      march(raster, width, front_along(raster, width, walls), inner_edge + kBeyondEdge);
  for (std::size_t i = 0; i < raster.size(); ++i) {
    headland.inner[i] =
        raster.in_area(i) && !(static_cast<double>(front.u[i]) <= inner_edge) ? 1 : 0;
  }
  for (const SurveyCurve& line : level_lines(raster, front.u, options.from_wall)) {
    headland.lines.push_back(smoothed(resampled(line, options.step_m), options.smooth_passes));
  }
  return headland;
}

}  // namespace swathplan
