#include "planners/rows/route_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "planners/rows/route_stretches.h"
#include "planners/steering/even_bends.h"
#include "planners/steering/line_poses.h"
#include "planners/steering/steer.h"
#include "planners/wording.h"

namespace swathplan {
namespace {

/// A line keeps at least this share of its length, whatever its run-in and run-out take.
constexpr double kMostShortened = 0.45;
/// Run-ins that do not fit are shortened in this many steps.
constexpr int kRunSteps = 16;
/// Notes name this many joins without a forward path. Joins across land are all named.
constexpr std::size_t kJoinsSaid = 5;

/// Cuts `off` metres off the end of a line, which then ends at a waypoint of its own.
void cut_end(std::vector<Waypoint>& line, double off) {
  const LinePoses poses(positions(line));
  if (poses.is_point() || off <= 0.0) return;
  const auto end = poses.at(poses.length_m() - off);
  Waypoint last = line[end.source];
  last.position = end.pose.position;
  line.resize(end.source + 1);
  if ((line.back().position - last.position).norm() > LinePoses::kCoincidentM) line.push_back(last);
}

/// Straight stretches of a join are sailed at the speed of lines from this share of those on that
/// are worth speeding up for.
constexpr double kAsOnLines = 0.5;

/// Makes the long straight stretches of a join transits, and the rest turns. `join`: its waypoints,
/// and as the last one the place where it ends.
void speed_up(std::vector<Waypoint>& join, const Vehicle& vehicle) {
  // Chords of a curve turn by more than this from one to the next.
  constexpr double kStraight = 1e-3;
  const auto course = [&](std::size_t i) -> Vec2 {
    return (join[i + 1].position - join[i].position).normalized();
  };
  for (std::size_t first = 0, next = 0; first + 1 < join.size(); first = next) {
    double metres = 0.0;
    next = first;
    do {
      metres += (join[next + 1].position - join[next].position).norm();
      ++next;
    } while (next + 1 < join.size() && (course(next) - course(first)).norm() < kStraight);
    const double worth_m = kStraightRadii * vehicle.turn_radius_m;
    const bool straight = metres >= worth_m;
    const double on_the_way = metres >= kAsOnLines * worth_m
                                  ? std::max(vehicle.turn_speed_mps,
                                             std::min(vehicle.speed_mps, vehicle.transit_speed_mps))
                                  : vehicle.turn_speed_mps;
    for (std::size_t i = first; i < next; ++i) {
      join[i].kind = straight ? LegKind::transit : LegKind::turn;
      join[i].speed_mps = straight ? vehicle.transit_speed_mps : on_the_way;
    }
  }
}

/// Cuts `off` metres off the beginning.
void cut_begin(std::vector<Waypoint>& line, double off) {
  const LinePoses poses(positions(line));
  if (poses.is_point() || off <= 0.0) return;
  // Measured from the end, as the connector does: places move to the points of curves.
  std::vector<Vec2> back = positions(line);
  std::reverse(back.begin(), back.end());
  const auto begin = LinePoses(back).at(poses.length_m() - off);
  const double along = poses.length_m() - begin.along_m;
  std::size_t next = 0;
  while (next + 1 < line.size() && poses.source()[0] == 0) {
    const auto after = std::upper_bound(poses.along().begin(), poses.along().end(),
                                        along + LinePoses::kCoincidentM);
    next = after == poses.along().end()
               ? line.size() - 1
               : poses.source()[static_cast<std::size_t>(after - poses.along().begin())];
    break;
  }
  Waypoint first = line[next > 0 ? next - 1 : 0];
  first.position = begin.pose.position;
  line.erase(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(next));
  line.insert(line.begin(), first);
}

}  // namespace

std::vector<Waypoint> line_waypoints(const SurveyLine& line, int number, const FanAngles& fan,
                                     const PlanOptions& options) {
  Waypoint point;
  point.line = number;
  point.fan = fan;
  point.speed_mps = options.vehicle.speed_mps;
  std::vector<Waypoint> points(2, point);
  points[0].position = line.from;
  points[1].position = line.to;
  return points;
}

Connector connector_for(const Ground& ground, const PlanOptions& options) {
  return {ground.water,
          {.radius_m = options.vehicle.turn_radius_m,
           .frame = ground.seafloor ? ground.seafloor->frame : Frame{}}};
}

double turn_reach_m(const PlanOptions& options) { return 2.0 * lane_m(options); }

RouteBuilder::RouteBuilder(const Ground& ground, const PlanOptions& options,
                           const Connector& connector)
    : connector_(connector),
      watch_(options.watch),
      vehicle_(options.vehicle),
      run_in_(options.run_in_m),
      run_out_(options.run_out_m),
      turn_reach_(turn_reach_m(options)),
      speeds_up_(options.counted == Counted::logged) {
  if (options.smooth) smoother_.emplace(ground.water, connector_, vehicle_.turn_radius_m);
}

std::optional<Vec2> RouteBuilder::at() const {
  if (route_.waypoints.empty()) return std::nullopt;
  return route_.waypoints.back().position;
}

std::vector<Waypoint> RouteBuilder::steered_line(const std::vector<Waypoint>& points) {
  const Steering steering = steered(positions(points), vehicle_.turn_radius_m, connector_);
  if (steering.mended == 0 && steering.left == 0) return points;
  loops_ += steering.loops;
  loop_m_ += steering.added_m;
  left_tight_ += steering.left;
  std::vector<Waypoint> line;
  line.reserve(steering.points.size());
  for (const SteeredPoint& p : steering.points) {
    line.push_back(points[p.source]);
    line.back().position = p.position;
    if (p.tight) line.back().feasible = false;
  }
  return line;
}

/// Lengthens a line by a run on its course that is not logged; the run is shorter where the water
/// ends. A negative run shortens the line.
void RouteBuilder::add_run(std::vector<Waypoint>& line, double metres, bool in) {
  const LinePoses poses(positions(line));
  if (metres == 0.0 || poses.is_point()) return;
  if (metres < 0.0) {
    const double off = std::min(-metres, kMostShortened * poses.length_m());
    in ? cut_begin(line, off) : cut_end(line, off);
    return;
  }
  const auto end = poses.at(in ? 0.0 : poses.length_m());
  const Vec2 out = in ? Vec2(-end.pose.course) : end.pose.course;
  for (int k = kRunSteps; k > 0; --k) {
    const double length = metres * k / kRunSteps;
    const Vec2 far = end.pose.position + length * out;
    if (!connector_.in_water({end.pose.position, far})) continue;
    if (k < kRunSteps) ++short_runs_;
    Waypoint w = in ? line.front() : line.back();
    w.kind = in ? LegKind::run_in : LegKind::run_out;
    w.log = false;
    if (!in) {
      line.back() = w;
    }
    w.position = far;
    line.insert(in ? line.begin() : line.end(), w);
    return;
  }
  ++short_runs_;
}

/// Joins the end of the route to a line. The line may lose a part of its beginning, and the line
/// before it a part of its end.
void RouteBuilder::join_to(std::vector<Waypoint>& line) {
  std::vector<Waypoint> before(route_.waypoints.begin() + static_cast<std::ptrdiff_t>(line_begin_),
                               route_.waypoints.end());
  const bool smooths = smoother_ && !watch_.ended();
  if (smoother_ && !smooths) ++plain_joins_;
  const Connection way = smooths ? smoother_->join(positions(before), positions(line))
                                 : connector_.join(positions(before), positions(line));
  cut_end(before, way.off_before_m);
  cut_begin(line, way.off_after_m);
  const bool feasible = way.kind != JoinKind::infeasible;
  const double apart = (line.front().position - before.back().position).norm();
  // What a waypoint says holds from there on. So the last waypoint of a line begins the join.
  Waypoint join = before.back();
  join.kind = feasible && apart <= turn_reach_ ? LegKind::turn : LegKind::transit;
  join.speed_mps =
      join.kind == LegKind::turn ? vehicle_.turn_speed_mps : vehicle_.transit_speed_mps;
  join.line.reset();
  join.region.reset();
  join.log = false;
  join.feasible = feasible;
  const bool overland = !feasible && !connector_.in_water(way.points);
  if (overland || (!feasible && ++tight_joins_ <= kJoinsSaid)) notes_.push_back(way.reason);
  if (overland) join.fan.reset();
  before.back() = join;
  const std::size_t first = before.size() - 1;
  for (std::size_t i = 1; i + 1 < way.points.size(); ++i) {
    join.position = way.points[i];
    before.push_back(join);
  }
  if (speeds_up_ && feasible) {
    std::vector<Waypoint> joining(before.begin() + static_cast<std::ptrdiff_t>(first),
                                  before.end());
    joining.push_back(line.front());
    speed_up(joining, vehicle_);
    std::copy(joining.begin(), joining.end() - 1,
              before.begin() + static_cast<std::ptrdiff_t>(first));
  }
  route_.waypoints.resize(line_begin_);
  route_.waypoints.insert(route_.waypoints.end(), before.begin(), before.end());
}

void RouteBuilder::add_line(const std::vector<Waypoint>& points) {
  if (points.empty()) return;
  std::vector<Waypoint> line = steered_line(points);
  add_run(line, run_in_, true);
  add_run(line, run_out_, false);
  append(std::move(line));
}

void RouteBuilder::append(std::vector<Waypoint> line) {
  if (!route_.waypoints.empty()) join_to(line);
  line_begin_ = route_.waypoints.size();
  route_.waypoints.insert(route_.waypoints.end(), line.begin(), line.end());
}

void RouteBuilder::append(const std::vector<Waypoint>& join, const std::vector<Waypoint>& line) {
  auto& w = route_.waypoints;
  if (!w.empty()) w.pop_back();
  w.insert(w.end(), join.begin(), join.end());
  line_begin_ = w.size();
  w.insert(w.end(), line.begin(), line.end());
}

std::vector<std::string> RouteBuilder::notes() const {
  std::vector<std::string> all = notes_;
  if (tight_joins_ > kJoinsSaid) {
    all.push_back(fmt::format("the same holds for {}; plan.json and the report list them all",
                              counted(tight_joins_ - kJoinsSaid, "more join")));
  }
  if (smoother_ && smoother_->tally().joins > 0) all.push_back(note(smoother_->tally()));
  if (plain_joins_ > 0) {
    all.push_back(fmt::format("search ended early: {} plain arcs",
                              counted(plain_joins_, "join keeps its", "joins keep their")));
  }
  if (loops_ > 0) {
    all.push_back(fmt::format(
        "{} of lines {} tighter than {:g} m, so the boat sails a loop there; all replaced turns "
        "together change the length by {:+.0f} m",
        counted(loops_, "turn"), loops_ == 1 ? "is" : "are", vehicle_.turn_radius_m, loop_m_));
  }
  if (left_tight_ > 0) {
    all.push_back(fmt::format(
        "{} of lines {} tighter than {:g} m: no wider turn and no loop stays in safe water",
        counted(left_tight_, "turn"), left_tight_ == 1 ? "stays" : "stay", vehicle_.turn_radius_m));
  }
  if (short_runs_ > 0) {
    all.push_back(
        fmt::format("{} shorter than asked for: safe water ends",
                    counted(short_runs_, "run-in or run-out is", "run-ins or run-outs are")));
  }
  return all;
}

Route RouteBuilder::finish() {
  if (!route_.waypoints.empty()) {
    Waypoint& last = route_.waypoints.back();
    last.kind = LegKind::end;
    last.log = false;
    last.line.reset();
  }
  left_tight_ += even_bends(route_, vehicle_.turn_radius_m, connector_);
  return std::move(route_);
}

BuiltRoute RouteBuilder::built() {
  Route route = finish();
  return {std::move(route), notes()};
}

BuiltRoute rejoined(const Route& route, const Ground& ground, const PlanOptions& options,
                    const Connector& connector) {
  RouteBuilder builder(ground, options, connector);
  std::vector<Waypoint> line, kept;
  const auto put = [&] {
    if (!line.empty()) kept.empty() ? builder.append(line) : builder.append(kept, line);
    line.clear();
    kept.clear();
  };
  for (const RouteStretch& s : stretches(route)) {
    if (!s.join) {
      if (!line.empty()) line.pop_back();
      line.insert(line.end(), s.points.begin(), s.points.end());
      continue;
    }
    put();
    const bool feasible =
        std::all_of(s.points.begin(), s.points.end(), [](const Waypoint& w) { return w.feasible; });
    if (!feasible) kept = s.points;
  }
  put();
  return builder.built();
}

}  // namespace swathplan
