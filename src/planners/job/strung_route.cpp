#include "planners/job/strung_route.h"

#include "coverage/route/route_figures.h"

namespace swathplan {
namespace {

std::vector<Waypoint> moored(const Vec2& berth, const Vehicle& vehicle) {
  Waypoint w;
  w.position = berth;
  w.kind = LegKind::transit;
  w.log = false;
  w.speed_mps = vehicle.transit_speed_mps;
  return {w};
}

bool is_join(const Waypoint& w) { return w.kind == LegKind::turn || w.kind == LegKind::transit; }

/// The way out and the way home are transits, and nothing is to be sounded there.
void quieten_ends(Route& route, const Vehicle& vehicle) {
  auto& w = route.waypoints;
  const auto quiet = [&](Waypoint& point) {
    point.kind = LegKind::transit;
    point.speed_mps = vehicle.transit_speed_mps;
    point.fan.reset();
  };
  for (std::size_t i = 0; i < w.size() && is_join(w[i]); ++i) quiet(w[i]);
  for (std::size_t i = w.size() - 1; i-- > 0 && is_join(w[i]);) quiet(w[i]);
}

/// Lines that meet on one course, as pieces of a line do, put together again.
std::vector<JobLine> continued(const std::vector<JobLine>& lines) {
  constexpr double kOneCourse = 0.999;
  std::vector<JobLine> result;
  for (const JobLine& line : lines) {
    const LineEnds ends = ends_of_line(line);
    const bool on = !result.empty() && line.join_before.empty() &&
                    (ends_of_line(result.back()).to - ends.from).norm() < kCoincident &&
                    ends_of_line(result.back()).course_to.dot(ends.course_from) > kOneCourse;
    if (!on) {
      result.push_back(line);
      continue;
    }
    std::vector<Waypoint>& points = result.back().points;
    points.pop_back();
    points.insert(points.end(), line.points.begin(), line.points.end());
  }
  return result;
}

/// Metres of a course that stand for a boat that lies at its berth: a chord as turns have them, too
/// short for the join to cut any of it off.
constexpr double kMooredM = 0.3;

BuiltRoute strung_from(const std::vector<JobLine>& lines, const std::optional<Berth>& berth,
                       const Ground& ground, const PlanOptions& options,
                       const Connector& connector) {
  RouteBuilder builder(ground, options, connector);
  if (berth) {
    std::vector<Waypoint> lying = moored(berth->place, options.vehicle);
    if (berth->course) {
      lying.insert(lying.begin(), lying.front());
      lying.front().position -= kMooredM * *berth->course;
    }
    builder.append(std::move(lying));
  }
  bool first = true;
  for (const JobLine& line : lines) {
    // A join holds only behind the line that it was made for, which then ends where it begins.
    const bool kept = !first && !line.join_before.empty() &&
                      (*builder.at() - line.join_before.front().position).norm() < kCoincident;
    kept ? builder.append(line.join_before, line.points) : builder.append(line.points);
    first = false;
  }
  if (berth) builder.append(moored(berth->place, options.vehicle));
  BuiltRoute built = builder.built();
  if (!berth) return built;
  auto& w = built.route.waypoints;
  if (berth->course) {
    w.erase(w.begin());
    w.front().position = berth->place;
  }
  quieten_ends(built.route, options.vehicle);
  return built;
}

}  // namespace

BuiltRoute strung(const std::vector<JobLine>& lines, const std::optional<Berth>& berth,
                  const Ground& ground, const PlanOptions& options, const Connector& connector) {
  if (lines.empty()) return {};
  const std::vector<JobLine> whole = continued(lines);
  BuiltRoute built = strung_from(whole, berth, ground, options, connector);
  if (!berth || !berth->course || built.route.waypoints.front().feasible) return built;
  return strung_from(whole, Berth{berth->place}, ground, options, connector);
}

Berth end_of(const Route& route) {
  const auto& w = route.waypoints;
  Berth berth{w.back().position};
  for (std::size_t i = w.size() - 1; i-- > 0 && !berth.course;) {
    const Vec2 way = berth.place - w[i].position;
    if (way.norm() > kCoincident) berth.course = way.normalized();
  }
  return berth;
}

Route one_after_the_other(const std::vector<const Route*>& routes) {
  Route all;
  for (const Route* route : routes) {
    if (route->waypoints.empty()) continue;
    if (!all.waypoints.empty()) all.waypoints.pop_back();
    all.waypoints.insert(all.waypoints.end(), route->waypoints.begin(), route->waypoints.end());
  }
  return all;
}

double infeasible_m(const Route& route) {
  double sum = 0.0;
  const auto& w = route.waypoints;
  for (std::size_t i = 0; i + 1 < w.size(); ++i) {
    if (!w[i].feasible) sum += (w[i + 1].position - w[i].position).norm();
  }
  return sum;
}

}  // namespace swathplan
