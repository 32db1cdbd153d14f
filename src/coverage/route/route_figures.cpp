#include "coverage/route/route_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "coverage/route/bends.h"
#include "coverage/route/over_land.h"
#include "mesh/plane/area_query.h"
#include "mesh/plane/path_meetings.h"
#include "mesh/plane/segments.h"

namespace swathplan {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<Vec2> distinct_points(const Route& route) {
  std::vector<Vec2> points;
  for (const Waypoint& w : route.waypoints) {
    if (points.empty() || (w.position - points.back()).norm() > kCoincident) {
      points.push_back(w.position);
    }
  }
  return points;
}

// Whether the way on from each distinct point joins lines; the rest is survey line.
std::vector<char> joining(const Route& route) {
  std::vector<char> joins;
  Vec2 last = Vec2::Zero();
  for (const Waypoint& w : route.waypoints) {
    const bool on_line = is_survey(w.kind);
    if (joins.empty() || (w.position - last).norm() > kCoincident) {
      joins.push_back(0);
      last = w.position;
    }
    joins.back() = on_line ? 0 : 1;
  }
  return joins;
}

void add_lengths(const Route& route, RouteFigures& figures) {
  for (std::size_t i = 0; i + 1 < route.waypoints.size(); ++i) {
    const Waypoint& w = route.waypoints[i];
    const double length = (route.waypoints[i + 1].position - w.position).norm();
    figures.length_m += length;
    figures.length_by_kind_m[std::string(name(w.kind))] += length;
    if (w.log) figures.logged_length_m += length;
    const double seconds = length / w.speed_mps;
    figures.duration_s += seconds;
    figures.duration_by_kind_s[std::string(name(w.kind))] += seconds;
    if (w.line) figures.duration_by_line_s[*w.line] += seconds;
    if (!w.feasible) figures.infeasible_m += length;
  }
}

// Counts manoeuvres: runs of bends with short ways between, on lines to the same side.
class TurnCounter {
 public:
  TurnCounter(RouteFigures& figures, double turn_radius_m)
      : figures_(figures), gap_m_(std::max(kCurveGapM, 2.0 * turn_radius_m)) {}

  /// `joins`: the bend lies between lines, where a turn may swing out to one side first.
  void add(double angle, double way_before, bool joins) {
    const bool other_side = angle * last_ < 0.0;
    if (way_before > gap_m_ || (other_side && !(joins && in_join_))) end_curve();
    curve_ += angle;
    largest_ = std::max(largest_, std::abs(curve_));
    last_ = angle;
    in_join_ = joins;
  }
  void end_curve() {
    // Many small bends that make a right angle must count as one in spite of rounding.
    constexpr double kDust = 1e-6;
    const double degrees = largest_ * 180.0 / std::numbers::pi + kDust;
    figures_.turns += degrees >= kTurnDeg;
    figures_.sharp_turns += degrees >= kSharpTurnDeg;
    curve_ = largest_ = last_ = 0.0;
  }

 private:
  RouteFigures& figures_;
  double gap_m_;
  double curve_ = 0.0, largest_ = 0.0, last_ = 0.0;
  bool in_join_ = false;
};

void add_turns(const std::vector<Vec2>& points, const std::vector<char>& joins,
               double smallest_radius_m, RouteFigures& figures) {
  TurnCounter turns(figures, smallest_radius_m);
  figures.min_turn_radius_m = kInfinity;
  double way = 0.0;  // since the last bend
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const CourseChange change = course_change(points[i - 1], points[i], points[i + 1]);
    const double angle = change.angle_rad;
    way += change.before_m;
    figures.total_turning_deg += std::abs(angle) * 180.0 / std::numbers::pi;
    const double radius = bend_radius_m(change, smallest_radius_m);
    if (radius < kStraightRadiusM) {
      figures.min_turn_radius_m = std::min(figures.min_turn_radius_m, radius);
    }
    if (radius < (1.0 - kTightShare) * smallest_radius_m) {
      figures.tight_turn_m += turn_path_m(change, smallest_radius_m);
    }
    figures.sharp_corners += is_corner(change, smallest_radius_m);
    // Smaller bends come from rounding along a straight line.
    constexpr double kStraight = 1e-6;
    if (std::abs(angle) < kStraight) continue;
    turns.add(angle, way, joins[i - 1] != 0 || joins[i] != 0);
    way = 0.0;
  }
  turns.end_curve();
}

double outside_m(const std::vector<Vec2>& points, const Area& water) {
  const AreaQuery query(water);
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double length = (points[i + 1] - points[i]).norm();
    const double outside = length - query.inside_length(points[i], points[i + 1]);
    if (outside > kLengthDust) sum += outside;
  }
  return sum;
}

struct DepthsBelow {
  double least_m = kInfinity;
  double unknown_m = 0.0;  // path outside the water and the land, and without a depth
};

DepthsBelow depths_below(const std::vector<Vec2>& points, const Area& water,
                         const DepthQuery& depths, const Area& land) {
  const AreaQuery query(water);
  const AreaQuery ashore(land);
  DepthsBelow below;
  // Beyond data and water there is nothing to look at, however long a leg runs there.
  Box2 known = depths.extent();
  for (const Area* area : {&water, &land}) {
    if (area->empty()) continue;
    known.extend(extent(*area).min);
    known.extend(extent(*area).max);
  }
  // Each look-up stands for `length` metres of path.
  const auto look = [&](const Vec2& p, double length) {
    if (const auto depth = depths.depth(p)) {
      below.least_m = std::min(below.least_m, *depth);
    } else if (!query.contains(p) && !ashore.contains(p)) {
      below.unknown_m += length;
    }
  };
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Vec2 way = points[i + 1] - points[i];
    const double steps = std::ceil(way.norm() / kDepthStepM);
    const auto part = clipped(points[i], points[i + 1], known);
    // Two looks more than needed on either side, against rounding.
    const double first = part ? std::max(0.0, std::floor(part->first * steps) - 2.0) : steps;
    const double last = part ? std::min(steps, std::ceil(part->second * steps) + 2.0) : steps;
    for (double k = first; k < last; ++k) look(points[i] + k / steps * way, way.norm() / steps);
    const double apart = first + (steps - last);
    if (apart > 0.0) below.unknown_m += apart * way.norm() / steps;
  }
  if (!points.empty()) look(points.back(), 0.0);
  return below;
}

}  // namespace

RouteFigures route_figures(const Route& route, const Vehicle& vehicle, const Area& water,
                           const DepthQuery& depths, double survey_area_m2,
                           double footprint_width_m, const Area& land) {
  RouteFigures figures;
  add_lengths(route, figures);
  for (const Leg& leg : legs(route))
    figures.infeasible_legs += !route.waypoints[leg.first].feasible;
  if (vehicle.power_w) figures.energy_wh = *vehicle.power_w * figures.duration_s / 3600.0;
  figures.contingency_s = vehicle.contingency * figures.duration_s;
  figures.beyond_endurance =
      figures.duration_s + figures.contingency_s > 3600.0 * vehicle.endurance_h;
  if (survey_area_m2 > 0 && footprint_width_m > 0) {
    figures.length_ratio = figures.length_m / (survey_area_m2 / footprint_width_m);
  }
  const std::vector<Vec2> points = distinct_points(route);
  figures.cross = cross_figures(route);
  add_turns(points, joining(route), vehicle.turn_radius_m, figures);
  const PathMeetings meetings = path_meetings(points);
  figures.self_crossings = meetings.crossings;
  figures.shared_stretches = meetings.shared_stretches;
  figures.shared_m = meetings.shared_m;
  figures.outside_water_m = outside_m(points, water);
  // Land lies outside the water: of a route that keeps to the water nothing leads over it.
  const Area ashore = figures.outside_water_m > 0.0 ? land : Area{};
  figures.over_land_m = std::min(over_land_m(points, AreaQuery(ashore)), figures.outside_water_m);
  const DepthsBelow below = depths_below(points, water, depths, ashore);
  figures.over_unknown_m = std::min(below.unknown_m, figures.outside_water_m - figures.over_land_m);
  const bool known = figures.over_land_m + figures.over_unknown_m == 0.0;
  figures.min_under_keel_m = known ? below.least_m - vehicle.draft_m : kInfinity;
  return figures;
}

std::string endurance_note(const RouteFigures& figures, const Vehicle& vehicle) {
  if (!figures.beyond_endurance) return {};
  const double hours = (figures.duration_s + figures.contingency_s) / 3600.0;
  return fmt::format(
      "the mission takes {:.2f} h with a contingency of {:g} %, {:.2f} h more than the vehicle's "
      "endurance of {:g} h: it must be split",
      hours, 100.0 * vehicle.contingency, hours - vehicle.endurance_h, vehicle.endurance_h);
}

std::string corners_note(const RouteFigures& figures, const Vehicle& vehicle) {
  if (figures.sharp_corners == 0) return {};
  const bool one = figures.sharp_corners == 1;
  return fmt::format(
      "{} that cannot be sailed as drawn: the course changes by more than {:g} degrees at one "
      "waypoint, where the vehicle needs a turn of {:g} m",
      one ? "1 corner" : fmt::format("{} corners", figures.sharp_corners), kCornerDeg,
      vehicle.turn_radius_m);
}

}  // namespace swathplan
