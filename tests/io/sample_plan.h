#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "coverage/score.h"
#include "io/files/crs.h"
#include "io/results/provenance.h"
#include "mesh/survey_area.h"

namespace swathplan::test {

/// A route of parallel lines over a box, joined at their ends; fans of equal half-angles.
inline Route parallel_lines(const Box2& box, double spacing_m, double half_angle_deg = 40.0) {
  const FanAngles fan{.port = Angle::degrees(half_angle_deg),
                      .starboard = Angle::degrees(half_angle_deg)};
  Route route;
  int line = 0;
  for (double x = box.min.x() + spacing_m / 2; x < box.max.x(); x += spacing_m, ++line) {
    const bool up = line % 2 == 0;
    for (const double y : {up ? box.min.y() : box.max.y(), up ? box.max.y() : box.min.y()}) {
      const bool begins = y == (up ? box.min.y() : box.max.y());
      route.waypoints.push_back({.position = Vec2(x, y),
                                 .kind = begins ? LegKind::line : LegKind::turn,
                                 .log = begins,
                                 .line = begins ? std::optional<int>(line) : std::nullopt,
                                 .fan = fan,
                                 .speed_mps = 2.0,
                                 .region = 0});
    }
  }
  route.waypoints.back().kind = LegKind::end;
  return route;
}

/// A grid whose cells have soundings where they lie within `reach_m` of a line of `route` that
/// runs north, more of them the nearer.
inline CoverageGrid swept(const Area& area, double resolution_m, const Route& route,
                          double reach_m) {
  CoverageGrid grid(area, resolution_m);
  for (std::uint32_t r = 0; r < grid.rows(); ++r) {
    for (std::uint32_t c = 0; c < grid.columns(); ++c) {
      const std::size_t i = std::size_t{r} * grid.columns() + c;
      double nearest = 1e9;
      for (const Waypoint& w : route.waypoints) {
        nearest = std::min(nearest, std::abs(w.position.x() - grid.centre(c, r).x()));
      }
      if (grid.counts(i) && nearest < reach_m) {
        grid.words()[i] |= static_cast<std::uint32_t>(1.0 + 5.0 * (1.0 - nearest / reach_m));
      }
    }
  }
  return grid;
}

/// Figures that fit such a grid, with two gaps listed.
inline Score plain_score(const CoverageGrid& grid, const Route& route, double area) {
  Score score;
  std::uint64_t hit = 0;
  for (std::size_t i = 0; i < grid.words().size(); ++i) {
    score.cells += grid.counts(i) ? 1U : 0U;
    hit += grid.counts(i) && grid.soundings(i) > 0 ? 1U : 0U;
  }
  score.all.hit_pct = 100.0 * static_cast<double>(hit) / static_cast<double>(score.cells);
  score.all.footprint_pct = std::min(100.0, score.all.hit_pct + 1.0);
  score.logged.hit_pct = 0.98 * score.all.hit_pct;
  score.survey_area_m2 = area;
  score.footprint_width_m = 25.6;
  score.route.length_m = length_m(route);
  score.route.length_by_kind_m = {{"line", 0.9 * length_m(route)}, {"turn", 0.1 * length_m(route)}};
  score.route.length_ratio = score.route.length_m / (area / 25.6);
  score.route.duration_s = score.route.length_m / 2.0;
  score.route.turns = route.waypoints.size() - 2;
  score.route.min_turn_radius_m = HUGE_VAL;
  score.holidays.count = 2;
  score.holidays.largest_m2 = 12.5;
  score.holidays.total_m2 = 13.0;
  Box2 box;
  box.extend(grid.centre(10, 10));
  box.extend(grid.centre(20, 40));
  score.holidays.list = {{.cells = 1250,
                          .area_m2 = 12.5,
                          .position = grid.centre(15, 25),
                          .box = box,
                          .cause = HolidayCause::between_lines},
                         {.cells = 50,
                          .area_m2 = 0.5,
                          .position = grid.centre(12, 12),
                          .box = box,
                          .cause = HolidayCause::edge}};
  return score;
}

inline Provenance provenance() {
  return {.version = "0.1.0",
          .command = "compare",
          .input_file = "/somewhere/else/harbour.ply",
          .input_hash = "sha1:0123456789abcdef0123456789abcdef01234567",
          .seed = 7,
          .options = {{"resolution_m", 0.1},
                      {"beams", 256},
                      {"sonar", std::string("norbit-iwbms")},
                      {"depth_band_limits_m", std::vector<double>{8.0, 15.5}},
                      {"footprint", true}},
          .derived = {}};
}

/// UTM zone 33N, near Roenne.
inline Frame utm_frame() {
  return {.origin = Vec2(485000.0, 6105000.0),
          .metres_per_unit = 1.0,
          .crs_wkt = parse_crs("EPSG:32633")};
}

}  // namespace swathplan::test
