#include "planners/smoothing/join_smoothing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "mesh/plane/segments.h"
#include "planners/smoothing/join_problem_internal.h"
#include "planners/steering/line_poses.h"
#include "planners/steering/pose_search.h"

namespace swathplan {
namespace {

/// A bend may use this much of the straights before and behind it, radii.
constexpr double kRun = 3.0;
/// A bend needs this many steps: those that are held, and some to move.
constexpr double kFewestSteps = 8.0;
/// Bends of less than this are straight, radians.
constexpr double kStraight = 1e-4;
/// The bounds of a bend are steady from this round on. A bend that then fails a check is solved
/// again, up to kMostRounds rounds.
constexpr int kSettled = 2;
constexpr int kMostRounds = 5;
/// A curve at the smallest radius has no room for a gradual beginning. So wider curves are tried
/// first, radii ...
constexpr double kWider[] = {1.3, 1.15};
/// ... but a wider curve must cost no more than this, in radii and as a share of the way.
constexpr double kDearest = 3.0;
constexpr double kDearestShare = 0.05;

double turn_at(const std::vector<Vec2>& p, std::size_t i) {
  const Vec2 in = p[i] - p[i - 1];
  const Vec2 out = p[i + 1] - p[i];
  return turn_angle(in, out);
}

/// The part of a line between two places, metres along it.
std::vector<Vec2> part_of(const LinePoses& line, double from, double to) {
  const auto& along = line.along();
  const auto& points = line.points();
  const auto at = [&](double metres) -> Vec2 {
    const auto next = std::upper_bound(along.begin() + 1, along.end() - 1, metres);
    const auto i = static_cast<std::size_t>(next - along.begin());
    const double share = (metres - along[i - 1]) / (along[i] - along[i - 1]);
    return points[i - 1] + std::clamp(share, 0.0, 1.0) * (points[i] - points[i - 1]);
  };
  std::vector<Vec2> part{at(from)};
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (along[i] > from + LinePoses::kCoincidentM && along[i] < to - LinePoses::kCoincidentM) {
      part.push_back(points[i]);
    }
  }
  part.push_back(at(to));
  return part;
}

struct Stretch {
  double from, to;  // metres along the curve
};

/// The bends of a curve, each with its share of the straights beside it. They do not overlap.
std::vector<Stretch> bends_of(const LinePoses& line, double straight_m) {
  std::vector<Stretch> bends;
  const auto& along = line.along();
  for (std::size_t i = 1; i + 1 < line.points().size(); ++i) {
    if (std::abs(turn_at(line.points(), i)) < kStraight) continue;
    const Stretch here{std::max(0.0, along[i - 1] - straight_m),
                       std::min(line.length_m(), along[i + 1] + straight_m)};
    if (!bends.empty() && here.from <= bends.back().to) {
      bends.back().to = here.to;
    } else {
      bends.push_back(here);
    }
  }
  return bends;
}

Pose first_pose(const std::vector<Vec2>& points) {
  return {points[0], (points[1] - points[0]).normalized()};
}

Pose last_pose(const std::vector<Vec2>& points) {
  const auto n = points.size();
  return {points[n - 1], (points[n - 1] - points[n - 2]).normalized()};
}

void append(std::vector<Vec2>& path, const std::vector<Vec2>& piece) {
  path.insert(path.end(), piece.begin() + 1, piece.end());
}

/// The poses at which a join leaves one line and enters the next.
std::pair<Pose, Pose> ends_of(const Connection& way, const std::vector<Vec2>& before,
                              const std::vector<Vec2>& after) {
  std::pair<Pose, Pose> ends{first_pose(way.points), last_pose(way.points)};
  const LinePoses left(before);
  if (!left.is_point()) ends.first = left.at(left.length_m() - way.off_before_m).pose;
  const LinePoses entered({after.rbegin(), after.rend()});
  if (!entered.is_point()) {
    ends.second = entered.at(entered.length_m() - way.off_after_m).pose;
    ends.second.course = -ends.second.course;
  }
  return ends;
}

double off_m(const Connection& way) { return way.off_before_m + way.off_after_m; }
/// The cost of a join: metres of way, and metres cut off lines.
double cost_m(const Connection& way) { return LinePoses(way.points).length_m() + off_m(way); }

/// The share of a curve's bends that were smoothed.
double smoothed_share(const SmoothedCurve& curve) {
  const auto bends = static_cast<double>(std::max<std::size_t>(curve.bends, 1));
  return static_cast<double>(curve.smoothed) / bends;
}

}  // namespace

double sharpest_change(const std::vector<Vec2>& path, double step_m) {
  const LinePoses line(path);
  if (line.is_point()) return 0.0;
  const Samples s = sampled(line, step_m);
  double before = 0.0, most = 0.0;
  for (std::size_t i = 1; i + 1 < s.points.size(); ++i) {
    const double curvature = turn_at(s.points, i) / s.step;
    if (i > 1) most = std::max(most, std::abs(curvature - before) / s.step);
    before = curvature;
  }
  return most;
}

JoinSmoother::JoinSmoother(const Area& safe_water, const Connector& connector, double radius_m)
    : water_(safe_water), connector_(connector), radius_(radius_m) {}

/// Adds a straight of one radius before and behind the curve, since curvature jumps there too.
double JoinSmoother::change(const Bend& bend) const {
  std::vector<Vec2> path{bend.from.position - radius_ * bend.from.course};
  path.insert(path.end(), bend.points.begin(), bend.points.end());
  path.push_back(bend.to.position + radius_ * bend.to.course);
  return sharpest_change(path, kJoinStep * radius_);
}

bool JoinSmoother::steerable(const Bend& bend) const {
  std::vector<Vec2> path{bend.from.position - radius_ * bend.from.course};
  path.insert(path.end(), bend.points.begin(), bend.points.end());
  path.push_back(bend.to.position + radius_ * bend.to.course);
  const LinePoses line(path);
  for (std::size_t i = 0; i < line.points().size(); ++i) {
    if (line.radius_at(i, radius_) < radius_) return false;
  }
  return true;
}

/// Smooths a bend. Returns why it failed; the bend then stays. Empty: it was smoothed.
std::string JoinSmoother::smooth(Bend& bend) const {
  const LinePoses line(bend.points);
  const double step = kJoinStep * radius_;
  if (line.length_m() < kFewestSteps * step) return "too short";
  JoinProblem problem(bend.from, bend.to, sampled(line, step), radius_, water_);
  std::string why;
  for (int round = 1; round <= kMostRounds; ++round) {
    const PathSolution found = problem.solve_round();
    if (!found.good) return found.status;
    if (round < kSettled) continue;
    const Bend now{bend.from, bend.to, problem.curve(curve_step_m(radius_))};
    if (!steerable(now)) {
      why = "too tight";
      problem.widen();
    } else if (!connector_.in_water(now.points)) {
      why = "leaves the water";
      problem.keep_off();
    } else if (change(now) >= change(bend)) {
      return "no smoother";
    } else {
      bend = now;
      return {};
    }
  }
  return why;
}

SmoothedCurve JoinSmoother::smoothed(const Pose& from, const Pose& to,
                                     const std::vector<Vec2>& curve) const {
  SmoothedCurve result{{curve.front()}, 0, 0, {}};
  const LinePoses line(curve);
  if (line.is_point()) return {curve, 0, 0, {}};
  double done = 0.0;
  for (const Stretch& stretch : bends_of(line, kRun * radius_)) {
    if (stretch.from > done) append(result.points, part_of(line, done, stretch.from));
    const auto points = part_of(line, stretch.from, stretch.to);
    Bend bend{stretch.from > 0.0 ? first_pose(points) : from,
              stretch.to < line.length_m() ? last_pose(points) : to, points};
    const std::string why = smooth(bend);
    append(result.points, bend.points);
    ++result.bends;
    why.empty() ? ++result.smoothed : ++result.kept[why];
    done = stretch.to;
  }
  if (done < line.length_m()) append(result.points, part_of(line, done, line.length_m()));
  return result;
}

/// The candidates for a join: the widest first, the Connector's own last.
std::vector<Connection> JoinSmoother::candidates(const Connection& plain,
                                                 const std::vector<Vec2>& before,
                                                 const std::vector<Vec2>& after) const {
  std::vector<Connection> all;
  const double dearest = (1.0 + kDearestShare) * cost_m(plain) + kDearest * radius_;
  for (const double wider : kWider) {
    auto wide = connector_.wider_join(before, after, wider * radius_);
    if (wide && cost_m(*wide) < dearest) all.push_back(std::move(*wide));
  }
  all.push_back(plain);
  return all;
}

bool takes_over(const SmoothedCurve& later, const SmoothedCurve& best) {
  if (later.smoothed == 0 && best.smoothed == 0) return true;
  return smoothed_share(later) > smoothed_share(best);
}

Connection JoinSmoother::join(const std::vector<Vec2>& before, const std::vector<Vec2>& after) {
  Connection plain = connector_.join(before, after);
  if (plain.kind == JoinKind::infeasible) return plain;
  if (bends_of(LinePoses(plain.points), 0.0).empty()) return plain;
  Connection best;
  SmoothedCurve found;  // empty, so the first candidate replaces it
  for (const Connection& way : candidates(plain, before, after)) {
    const auto [from, to] = ends_of(way, before, after);
    SmoothedCurve curve = smoothed(from, to, way.points);
    if (!takes_over(curve, found)) continue;
    best = way;
    found = std::move(curve);
    if (found.smoothed == found.bends) break;
  }
  best.points = found.points;
  ++tally_.joins;
  tally_.bends += found.bends;
  tally_.part += found.smoothed > 0 && found.smoothed < found.bends ? 1 : 0;
  for (const auto& [why, count] : found.kept) tally_.kept[why] += count;
  tally_.added_m += cost_m(best) - cost_m(plain) - 2.0 * (off_m(best) - off_m(plain));
  if (found.smoothed == found.bends) {
    ++tally_.whole;
    const auto change_of = [&](const Connection& way) {
      const auto [from, to] = ends_of(way, before, after);
      return change({from, to, way.points});
    };
    tally_.change_before += change_of(plain);
    tally_.change_after += change_of(best);
  }
  return best;
}

std::string note(const JoinTally& t) {
  std::string text = fmt::format("smoothing: {} of {} joins smoothed", t.whole, t.joins);
  if (t.part > 0) text += fmt::format(", {} more in part", t.part);
  if (t.whole > 0) {
    const auto n = static_cast<double>(t.whole);
    text += fmt::format(
        "; their sharpest change of curvature falls from {:.3g} to {:.3g} 1/m per m in the mean; "
        "the route's length changes by {:+.1f} m",
        t.change_before / n, t.change_after / n, t.added_m);
  }
  std::size_t kept = 0;
  for (const auto& [why, count] : t.kept) kept += count;
  if (kept > 0) {
    text += fmt::format("; {} of {} bends keep their arcs", kept, t.bends);
    for (const auto& [why, count] : t.kept) text += fmt::format(", {}: {}", why, count);
  }
  return text;
}

}  // namespace swathplan
