#include "planners/job/beside_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "coverage/route/route_figures.h"
#include "mesh/base/require.h"
#include "mesh/plane/area_query.h"
#include "mesh/plane/segments.h"
#include "planners/rows/line_order.h"
#include "planners/rows/route_builder.h"

namespace swathplan {
namespace {

using Path = std::vector<Vec2>;

/// Chords of a circle of room around a corner lie within this of it, metres.
constexpr double kChordOff = 0.02;
/// Fans reach this much farther than the lines beside them.
constexpr double kOverreach = 1.15;

Ring circle(const Vec2& middle, double radius) {
  const double half = std::acos(1.0 - std::min(0.5, kChordOff / radius));
  const int corners = std::max(16, static_cast<int>(std::ceil(std::numbers::pi / half)));
  Ring ring;
  for (int k = 0; k < corners; ++k) {
    const double turn = 2.0 * std::numbers::pi * k / corners;
    ring.push_back(middle + radius * Vec2(std::cos(turn), std::sin(turn)));
  }
  return ring;
}

/// All that lies within `reach` of the path.
Area within(const Path& path, double reach) {
  std::vector<Ring> rings;
  for (const Vec2& p : path) rings.push_back(circle(p, reach));
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Vec2 way = path[i + 1] - path[i];
    if (!(way.norm() > kCoincident)) continue;
    const Vec2 aside = reach * Vec2(way.y(), -way.x()).normalized();
    rings.push_back({path[i] + aside, path[i + 1] + aside, path[i + 1] - aside, path[i] - aside});
  }
  return from_rings(rings, true);
}

/// Where a place lies beside a path.
struct Beside {
  double along_m = 0.0;
  int side = 0;  ///< 1 starboard, -1 port, 0 before its beginning or behind its end
};

Beside beside(const Path& path, const Vec2& p) {
  double best = std::numeric_limits<double>::infinity();
  double walked = 0.0;
  Beside found;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Vec2 way = path[i + 1] - path[i];
    const double length = way.norm();
    if (!(length > kCoincident)) continue;
    const SegmentPlace near = nearest_on_segment(path[i], path[i + 1], p);
    const double distance = (p - near.point).norm();
    if (distance < best - 1e-9) {
      best = distance;
      constexpr double kSlack = 1e-3;
      const double ahead = (p - path[i]).dot(way) / length;
      const bool before = i == 0 && ahead < -kSlack;
      const bool behind = i + 2 == path.size() && ahead > length + kSlack;
      found.along_m = walked + near.share * length;
      found.side = before || behind ? 0 : cross(way, p - path[i]) < 0.0 ? 1 : -1;
    }
    walked += length;
  }
  return found;
}

/// Where a chord of a round end cuts the band's side, a step of no length is left at right angles
/// to it.
void without_chord_ends(Path& run) {
  const auto is_step = [](const Vec2& a, const Vec2& b) {
    return (a - b).norm() < 2.0 * kChordOff;
  };
  while (run.size() > 2 && is_step(run[0], run[1])) run.erase(run.begin());
  while (run.size() > 2 && is_step(run[run.size() - 1], run[run.size() - 2])) run.pop_back();
}

/// The two sides of a band around the path, without the round ends.
std::vector<Path> sides_of(const Path& path, double reach) {
  std::vector<Path> sides;
  for (const Polygon& polygon : within(path, reach)) {
    std::vector<Ring> rings = polygon.holes;
    rings.push_back(polygon.outer);
    for (const Ring& ring : rings) {
      // Begin behind a change of side, so that no run goes over the ring's seam.
      std::vector<Beside> at;
      for (const Vec2& p : ring) at.push_back(beside(path, p));
      std::size_t begin = 0;
      for (std::size_t i = 0; i < ring.size(); ++i) {
        if (at[i].side != at[(i + ring.size() - 1) % ring.size()].side) begin = i;
      }
      Path run;
      const auto put = [&](int side, double first, double last) {
        without_chord_ends(run);
        if (side != 0 && run.size() > 1) {
          if (last < first) std::reverse(run.begin(), run.end());
          sides.push_back(run);
        }
        run.clear();
      };
      double first = 0.0, last = 0.0;
      int side = 0;
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const std::size_t i = (begin + k) % ring.size();
        if (at[i].side != side) {
          put(side, first, last);
          side = at[i].side;
          first = at[i].along_m;
        }
        last = at[i].along_m;
        run.push_back(ring[i]);
      }
      put(side, first, last);
    }
  }
  return sides;
}

Path closed(const Ring& ring) {
  Path path = ring;
  path.push_back(ring.front());
  return path;
}

/// The pieces of a path that lie in the area and are at least `least_m` long.
std::vector<Path> pieces_in(const Path& path, const AreaQuery& area, double least_m) {
  std::vector<Path> pieces;
  Path piece;
  const auto put = [&] {
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < piece.size(); ++i) length += (piece[i + 1] - piece[i]).norm();
    if (length >= least_m && piece.size() > 1) pieces.push_back(piece);
    piece.clear();
  };
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Vec2 way = path[i + 1] - path[i];
    for (const auto& [from, to] : area.clip(path[i], path[i + 1])) {
      const Vec2 a = path[i] + from * way;
      const Vec2 b = path[i] + to * way;
      if (piece.empty() || (piece.back() - a).norm() > kCoincident) {
        put();
        piece.push_back(a);
      }
      if ((b - piece.back()).norm() > kCoincident) piece.push_back(b);
    }
  }
  put();
  // A closed path that was cut elsewhere goes on over its first point.
  if (pieces.size() > 1 && (path.front() - path.back()).norm() < kCoincident &&
      (pieces.front().front() - pieces.back().back()).norm() < kCoincident) {
    pieces.back().insert(pieces.back().end(), pieces.front().begin() + 1, pieces.front().end());
    pieces.erase(pieces.begin());
  }
  return pieces;
}

double mean_depth_along(const Path& path, const Ground& ground) {
  double sum = 0.0, metres = 0.0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const double length = (path[i + 1] - path[i]).norm();
    const auto depth = ground.depths->depth(0.5 * (path[i] + path[i + 1]));
    if (!depth) continue;
    sum += length * *depth;
    metres += length;
  }
  return metres > 0.0 ? sum / metres : ground.depths->nearest_depth(path.front());
}

std::vector<Waypoint> waypoints_of(const Path& path, int number, double spacing_m,
                                   const Ground& ground, const PlanOptions& options) {
  const double below = std::max(0.5, mean_depth_along(path, ground) - options.vehicle.draft_m);
  const double width = std::max(lane_m(options), 2.0 * kOverreach * spacing_m);
  const Angle half = half_angle(options.sonar, width, below);
  Waypoint w;
  w.line = number;
  w.fan = FanAngles{half, half};
  w.speed_mps = options.vehicle.speed_mps;
  std::vector<Waypoint> points;
  for (const Vec2& p : path) {
    w.position = p;
    points.push_back(w);
  }
  return points;
}

LineEnds ends_of_path(const Path& path) {
  const std::size_t n = path.size();
  return {path.front(), path.back(), (path[1] - path[0]).normalized(),
          (path[n - 1] - path[n - 2]).normalized()};
}

}  // namespace

void check(const BesideOptions& how) {
  require(how.to_each_side >= 1, "beside lines", how.to_each_side, "a whole number of 1 or more");
  require_positive("spacing", how.spacing_m);
}

std::vector<Path> paths_beside(const GivenShapes& shapes, const BesideOptions& how) {
  check(how);
  std::vector<Path> paths;
  for (const Path& line : shapes.lines) paths.push_back(line);
  for (int k = 1; k <= how.to_each_side; ++k) {
    const double off = k * how.spacing_m;
    for (const Path& line : shapes.lines) {
      for (Path& side : sides_of(line, off)) paths.push_back(std::move(side));
    }
    std::vector<Ring> circles;
    for (const Vec2& p : shapes.points) circles.push_back(circle(p, off));
    for (const Area& around : {from_rings(circles, true), offset(shapes.polygons, off)}) {
      for (const Polygon& polygon : around) paths.push_back(closed(polygon.outer));
    }
  }
  return paths;
}

Plan plan_beside(const GivenShapes& shapes, const BesideOptions& how, const Ground& ground,
                 const PlanOptions& options) {
  const AreaQuery area(reachable_area(ground));
  std::vector<Path> paths;
  for (const Path& path : paths_beside(shapes, how)) {
    for (Path& piece : pieces_in(path, area, options.least_line_m)) {
      paths.push_back(std::move(piece));
    }
  }
  Plan plan;
  if (paths.empty()) return plan;
  std::vector<LineEnds> ends;
  for (const Path& path : paths) ends.push_back(ends_of_path(path));
  const JoinCost cost(ground.water, options.vehicle.turn_radius_m);
  const Connector connector = connector_for(ground, options);
  RouteBuilder builder(ground, options, connector);
  int number = 1;
  for (const OrderedLine& next : line_order(ends, cost, options.start)) {
    Path path = paths[next.line];
    if (next.backwards) std::reverse(path.begin(), path.end());
    builder.add_line(waypoints_of(path, number++, how.spacing_m, ground, options));
  }
  BuiltRoute built = builder.built();
  plan.route = std::move(built.route);
  plan.notes = std::move(built.notes);
  return plan;
}

}  // namespace swathplan
