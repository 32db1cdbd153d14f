#include "planners/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mesh/base/error.h"
#include "mesh/planar/quad_mesh.h"

namespace swathplan {

double counted_share(const PlanOptions& options) { return 1.0 - options.lines_margin; }

double footprint_width_m(const PlanOptions& options) {
  return footprint_width_m(options.sonar, options.resolution_m);
}

double lane_m(const PlanOptions& options) {
  return options.lane_width_m.value_or(footprint_width_m(options));
}

Area reachable_area(const Ground& ground) {
  Area area = intersect(ground.survey_area, ground.water);
  if (area.empty()) {
    throw InvalidInput(
        "no safe water in the survey area: depth, margin, no-go areas and clearance leave nothing; "
        "lower <margin> or <clearance>");
  }
  return area;
}

void check(const PlanOptions& options) {
  if (!(options.resolution_m > 0.0) || !std::isfinite(options.resolution_m)) {
    throw UsageError("resolution", fmt::format("{}", options.resolution_m),
                     "must be above 0 metres");
  }
  if (options.sonar.beams < 2) {
    throw UsageError("beams", fmt::format("{}", options.sonar.beams), "must be at least 2");
  }
  const double opening = options.sonar.max_opening.deg();
  if (!(opening > 0.0 && opening < 180.0)) {
    throw UsageError("max opening", fmt::format("{:g}", opening), "must lie in (0, 180) degrees");
  }
  if (options.opening_angle) {
    const double fan = options.opening_angle->deg();
    if (!(fan > 0.0 && fan <= opening + 1e-9)) {
      throw UsageError(
          "opening angle", fmt::format("{:g}", fan),
          fmt::format("must be above 0 and no more than <max opening>, {:g} degrees", opening));
    }
  }
  const RowSpacing& rows = options.rows;
  if (rows.spacing_m && !(*rows.spacing_m > 0.0 && std::isfinite(*rows.spacing_m))) {
    throw UsageError("spacing", fmt::format("{:g}", *rows.spacing_m), "must be above 0 metres");
  }
  if (!(rows.overlap >= 0.0 && rows.overlap < 1.0)) {
    throw UsageError("overlap", fmt::format("{:g}", 100.0 * rows.overlap),
                     "must be at least 0 and under 100 per cent: lines that overlap wholly never "
                     "come to an end of the area");
  }
  if (options.face_size && !(*options.face_size > 0.0 && std::isfinite(*options.face_size))) {
    throw UsageError("face size", fmt::format("{}", *options.face_size), "must be above 0");
  }
  if (options.smallest_region_m2 && !(*options.smallest_region_m2 >= 0.0)) {
    throw UsageError("smallest region", fmt::format("{}", *options.smallest_region_m2),
                     "must be 0 or more square metres");
  }
}

double face_size_m(const PlanOptions& options) {
  const double usual = options.faces == FaceShape::quad ? kQuadSize : kFaceSize;
  return options.face_size.value_or(usual) * lane_m(options);
}

double smallest_region_m2(const PlanOptions& options) {
  const double face = face_size_m(options);
  return options.smallest_region_m2.value_or(0.3 * face * face);
}

PlanarMesh mesh_of(const Area& area, const PlanOptions& options, double size_m, Angle turn) {
  if (options.faces == FaceShape::quad) return quad_mesh(area, {.side_m = size_m, .turn = turn});
  return planar_mesh(area, {.hypotenuse_m = size_m, .turn = turn});
}

PlanarMesh planning_mesh(const Ground& ground, const PlanOptions& options) {
  check(options);
  return mesh_of(reachable_area(ground), options, face_size_m(options));
}

DepthRegions planning_regions(const PlanarMesh& mesh, const std::vector<SharedEdge>& edges,
                              const Ground& ground, const PlanOptions& options) {
  return depth_regions(mesh, edges, *ground.depths,
                       {.bands = options.bands, .smallest_region_m2 = smallest_region_m2(options)});
}

double mean_depth_m(const DepthRegions& regions) {
  double volume = 0.0;
  double area = 0.0;
  for (const DepthRegion& region : regions.regions) {
    volume += region.area_m2 * region.mean_depth_m;
    area += region.area_m2;
  }
  return volume / std::max(area, 1e-12);
}

FanAngles fan_for_depth(const PlanOptions& options, double depth_m) {
  if (options.opening_angle) return {*options.opening_angle / 2.0, *options.opening_angle / 2.0};
  const double below_sonar = depth_m - options.vehicle.draft_m;
  const Angle half = half_angle(options.sonar, lane_m(options), below_sonar);
  return {half, half};
}

double practical_least_line_m(const Vehicle& vehicle) {
  return std::max(20.0, 4.0 * vehicle.turn_radius_m);
}

double ping_spacing_m(const PlanOptions& options, double depth_m) {
  const double below_sonar = depth_m - options.vehicle.draft_m;
  return ping_spacing_m(options.sonar, options.pings, below_sonar,
                        fan_for_depth(options, depth_m).port, options.vehicle.speed_mps);
}

Route opened_per_ping(const Route& route, const Ground& ground, const PlanOptions& options,
                      const std::vector<double>& lanes_m, double step_m) {
  Route result;
  PlanOptions how = options;
  if (!lanes_m.empty()) how.lane_width_m = lanes_m.front();
  const auto& w = route.waypoints;
  for (std::size_t i = 0; i < w.size(); ++i) {
    if (i + 1 == w.size() || !w[i].fan) {
      result.waypoints.push_back(w[i]);
      continue;
    }
    if (!lanes_m.empty() && w[i].region) {
      how.lane_width_m = lanes_m[static_cast<std::size_t>(*w[i].region)];
    }
    const Vec2 along = w[i + 1].position - w[i].position;
    const auto parts = std::max(1, static_cast<int>(std::ceil(along.norm() / step_m)));
    for (int k = 0; k < parts; ++k) {
      Waypoint point = w[i];
      point.position += along * (static_cast<double>(k) / parts);
      const Vec2 middle = w[i].position + along * ((k + 0.5) / parts);
      const auto depth = ground.depths->depth(middle);
      point.fan = fan_for_depth(how, depth ? *depth : ground.depths->nearest_depth(middle));
      result.waypoints.push_back(point);
    }
  }
  return result;
}

}  // namespace swathplan
