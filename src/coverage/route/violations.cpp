#include "coverage/route/violations.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "coverage/route/bends.h"
#include "coverage/route/over_land.h"
#include "coverage/route/route_figures.h"
#include "mesh/plane/area_query.h"

namespace swathplan {
namespace {

double length_of(const Route& route, std::size_t first, std::size_t last) {
  double sum = 0.0;
  for (std::size_t i = first; i < last; ++i) {
    sum += (route.waypoints[i + 1].position - route.waypoints[i].position).norm();
  }
  return sum;
}

Vec2 halfway(const Route& route, std::size_t first, std::size_t last) {
  double left = 0.5 * length_of(route, first, last);
  for (std::size_t i = first; i < last; ++i) {
    const Vec2& from = route.waypoints[i].position;
    const Vec2 way = route.waypoints[i + 1].position - from;
    if (left <= way.norm()) return way.norm() > 0.0 ? Vec2(from + left / way.norm() * way) : from;
    left -= way.norm();
  }
  return route.waypoints[last].position;
}

void add_infeasible(const Route& route, const Area& land, std::vector<Violation>& list) {
  const AreaQuery query(land);
  const std::vector<Vec2> points = positions(route.waypoints);
  for (const Leg& leg : legs(route)) {
    if (route.waypoints[leg.first].feasible) continue;
    const auto begin = points.begin();
    const double over_land = over_land_m({begin + static_cast<std::ptrdiff_t>(leg.first),
                                          begin + static_cast<std::ptrdiff_t>(leg.last) + 1},
                                         query);
    list.push_back({.kind = ViolationKind::infeasible,
                    .first = leg.first,
                    .last = leg.last,
                    .length_m = length_of(route, leg.first, leg.last),
                    .over_land_m = over_land > kTouchM ? over_land : 0.0});
  }
}

void add_outside(const Route& route, const Area& water, std::vector<Violation>& list) {
  const AreaQuery query(water);
  bool goes_on = false;
  for (std::size_t i = 0; i + 1 < route.waypoints.size(); ++i) {
    const Vec2& a = route.waypoints[i].position;
    const Vec2& b = route.waypoints[i + 1].position;
    const double length = (b - a).norm();
    if (length <= kCoincident) continue;
    const double outside = length - query.inside_length(a, b);
    const bool out = outside > kLengthDust;
    if (out && !goes_on) {
      list.push_back({.kind = ViolationKind::outside_water, .first = i, .last = i + 1});
    }
    if (out) {
      list.back().last = i + 1;
      list.back().length_m += outside;
    }
    goes_on = out;
  }
}

void add_tight(const Route& route, double smallest_m, std::vector<Violation>& list) {
  std::vector<std::size_t> at;  // waypoints that lie apart
  for (std::size_t i = 0; i < route.waypoints.size(); ++i) {
    const auto& p = route.waypoints[i].position;
    if (at.empty() || (p - route.waypoints[at.back()].position).norm() > kCoincident) {
      at.push_back(i);
    }
  }
  double since = 0.0;  // metres since the last tight bend
  bool open = false;
  for (std::size_t k = 1; k + 1 < at.size(); ++k) {
    const Vec2& b = route.waypoints[at[k]].position;
    since += (b - route.waypoints[at[k - 1]].position).norm();
    const bool marked = !route.waypoints[at[k]].feasible || !route.waypoints[at[k - 1]].feasible;
    const CourseChange change =
        course_change(route.waypoints[at[k - 1]].position, b, route.waypoints[at[k + 1]].position);
    const double radius = bend_radius_m(change, smallest_m);
    if (marked || radius >= (1.0 - kTightShare) * smallest_m) continue;
    if (!open || since > kCurveGapM) {
      list.push_back({.kind = ViolationKind::tight_turn, .first = at[k - 1], .radius_m = radius});
    }
    open = true;
    since = 0.0;
    Violation& turn = list.back();
    turn.last = at[k + 1];
    turn.length_m += turn_path_m(change, smallest_m);
    turn.radius_m = std::min(turn.radius_m, radius);
  }
}

}  // namespace

std::string_view name(ViolationKind kind) {
  switch (kind) {
    case ViolationKind::infeasible:
      return "infeasible";
    case ViolationKind::outside_water:
      return "outside water";
    case ViolationKind::tight_turn:
      return "tight turn";
  }
  return {};
}

std::vector<Violation> violations(const Route& route, const Vehicle& vehicle, const Area& water,
                                  const Area& land) {
  std::vector<Violation> list;
  add_infeasible(route, land, list);
  add_outside(route, water, list);
  add_tight(route, vehicle.turn_radius_m, list);
  for (Violation& v : list) v.position = halfway(route, v.first, v.last);
  return list;
}

std::string reason(const Violation& v, const Route& route, const Vehicle& vehicle) {
  switch (v.kind) {
    case ViolationKind::infeasible: {
      if (v.over_land_m > 0.0) {
        return fmt::format("leads over land or through a no-go area for {:.1f} m", v.over_land_m);
      }
      const LegKind leg = route.waypoints[v.first].kind;
      if (leg == LegKind::turn || leg == LegKind::transit) {
        return fmt::format("no forward way with turns of {:g} m stays in safe water",
                           vehicle.turn_radius_m);
      }
      return fmt::format(
          "bends tighter than {:g} m, and no forward way around it stays in safe water",
          vehicle.turn_radius_m);
    }
    case ViolationKind::outside_water:
      return "too shoal, on land, too close to a wall, or inside no-go";
    case ViolationKind::tight_turn:
      if (v.radius_m <= 0.0) {
        return fmt::format("a corner at one waypoint, where the vehicle needs a turn of {:g} m",
                           vehicle.turn_radius_m);
      }
      return fmt::format("a radius of {:.2f} m, where the vehicle needs {:g} m", v.radius_m,
                         vehicle.turn_radius_m);
  }
  return {};
}

}  // namespace swathplan
