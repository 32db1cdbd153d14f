#include "planners/steering/connect.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>

#include "planners/steering/line_poses.h"
#include "planners/steering/pose_search.h"
#include "planners/steering/safe_water.h"
#include "planners/steering/taut_way_internal.h"
#include "planners/steering/water_distances.h"
#include "planners/steering/water_path.h"

namespace swathplan {
namespace {

/// Lines are shortened in these steps, in radii. Steps are fine up to a little over one radius: a
/// quarter turn at the water's edge needs that much. Coarser steps go up to kMostCut.
constexpr double kFineStep = 1.0 / 16.0;
constexpr double kFineCut = 1.25;
constexpr double kCutStep = 0.25;
constexpr double kMostCut = 4.0;
/// The last search may take this many times the usual number of poses.
constexpr int kMorePoses = 4;
/// The search for a wider join takes the usual number of poses divided by this.
constexpr int kFewerPoses = 4;
/// Number of places to leave a line, and to begin the next, that searches try.
constexpr std::size_t kTries = 3;
/// An estimate that is this many times too short misleads a search. The search fills the water
/// before a wall with poses until it may take no more. Only a search in stages finds the way
/// around.
constexpr double kMisled = 5.0;
/// A wall thinner than a turning circle misleads it likewise: places behind the wall lie near the
/// way on this side. There distances through the water lead, if the way around is this many times
/// as long as the straight one.
constexpr double kDetour = 1.5;

Pose turned_back(const Pose& pose) { return {pose.position, -pose.course}; }

struct Cut {
  double off;
  Pose pose;
};

/// The poses at which a line may be left, the one with the smallest cut first. For a line turned
/// round these are the poses at which it may begin.
std::vector<Cut> cuts(const LinePoses& line, const ConnectOptions& options,
                      const SafeWater& water) {
  const double most = std::min(options.longest_cut * line.length_m(), kMostCut * options.radius_m);
  std::vector<Cut> result;
  const double r = options.radius_m;
  for (double off = 0.0; off <= most; off += (off < kFineCut * r ? kFineStep : kCutStep) * r) {
    const auto place = line.at(line.length_m() - off);
    const double cut = line.length_m() - place.along_m;
    if (!result.empty() && cut - result.back().off < LinePoses::kCoincidentM) continue;
    if (water.contains(place.pose.position)) result.push_back({cut, place.pose});
  }
  return result;
}

/// Courses for a line that is a point.
std::vector<Cut> any_course(const Vec2& at) {
  constexpr int kCourses = 16;
  std::vector<Cut> result;
  for (int k = 0; k < kCourses; ++k) {
    const Angle a = Angle::radians(2.0 * std::numbers::pi * k / kCourses);
    result.push_back({0.0, {at, {cos(a), sin(a)}}});
  }
  return result;
}

std::string at_text(const Vec2& local, const Frame& frame) {
  const Vec2 p = frame.to_file(local);
  return fmt::format("({:.1f}, {:.1f})", p.x(), p.y());
}

}  // namespace

struct Connector::Impl {
  /// How a search over poses estimates the metres to go, and whether to search only where this
  /// estimate leads, or only where it misleads.
  struct Estimate {
    bool in_sight = false;
    bool misled = false;
  };

  SafeWater water;
  WaterPath ways;
  ConnectOptions options;
  PoseSearchOptions search;
  std::optional<WaterDistances> distances;  // built when first needed
  std::map<std::vector<double>, Connection> joins;
  Effort effort;

  Impl(const Area& area, const ConnectOptions& o) : water(area), ways(area), options(o) {
    search.radius_m = o.radius_m * (1.0 + kRadiusReserve);
    search.most_poses = kMostPoses;
    search.place_in_water = [this](const Vec2& p) { return water.contains(p); };
    search.in_water = [this](const std::vector<Vec2>& points) { return water.holds(points); };
    search.searched = [this](int poses) {
      ++effort.searches;
      effort.poses += static_cast<std::size_t>(poses);
    };
    search.clear_around = [this](const Vec2& p) { return water.clear_around(p); };
  }

  [[nodiscard]] std::vector<Cut> sides(const std::vector<Vec2>& line, bool after,
                                       const ConnectOptions& how) const {
    std::vector<Vec2> there = line;
    if (after) std::reverse(there.begin(), there.end());
    const LinePoses poses(there);
    if (poses.is_point()) return any_course(there.back());
    std::vector<Cut> result = cuts(poses, how, water);
    if (after) {
      for (Cut& cut : result) cut.pose = turned_back(cut.pose);
    }
    return result;
  }

  [[nodiscard]] std::optional<Connection> by_curve(const std::vector<Cut>& from,
                                                   const std::vector<Cut>& to,
                                                   const PoseSearchOptions& how) const;
  [[nodiscard]] std::optional<Connection> by_way(const std::vector<Cut>& from,
                                                 const std::vector<Cut>& to, Estimate estimate,
                                                 PoseSearchOptions how) const;
  [[nodiscard]] bool behind_thin_wall(const Vec2& a, const Vec2& b) const;
  [[nodiscard]] std::optional<Connection> around_wall(const std::vector<Cut>& from,
                                                      const std::vector<Cut>& to);
  [[nodiscard]] std::optional<Connection> by_search(const std::vector<Cut>& from,
                                                    const std::vector<Cut>& to);
  [[nodiscard]] Connection infeasible(const Vec2& a, const Vec2& b) const;
  [[nodiscard]] std::optional<Connection> by_stages(const std::vector<Cut>& from,
                                                    const std::vector<Cut>& to,
                                                    const PoseSearchOptions& how) const;
  [[nodiscard]] std::optional<std::vector<Pose>> staged(const std::vector<Pose>& stages,
                                                        const std::vector<Vec2>& way,
                                                        const PoseSearchOptions& how) const;
  [[nodiscard]] std::vector<Cut> ones_with_room(const std::vector<Cut>& all, bool leaving,
                                                const PoseSearchOptions& how) const;
  [[nodiscard]] std::vector<Vec2> written(const std::vector<Pose>& poses,
                                          const PoseSearchOptions& how) const;
};

/// The Dubins path with the lowest cost, cuts of the lines included.
std::optional<Connection> Connector::Impl::by_curve(const std::vector<Cut>& from,
                                                    const std::vector<Cut>& to,
                                                    const PoseSearchOptions& how) const {
  struct Candidate {
    double cost;
    std::size_t a, b;
    DubinsPath path;
  };
  std::vector<Candidate> all;
  for (std::size_t a = 0; a < from.size(); ++a) {
    for (std::size_t b = 0; b < to.size(); ++b) {
      for (const DubinsPath& path : dubins_paths(from[a].pose, to[b].pose, how.radius_m)) {
        all.push_back(
            {path.length_m() + (kLineWorth - 1.0) * (from[a].off + to[b].off), a, b, path});
      }
    }
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Candidate& x, const Candidate& y) { return x.cost < y.cost; });
  for (const Candidate& c : all) {
    if (!stays_in_water(c.path, how)) continue;
    return Connection{
        JoinKind::curve, c.path.points(curve_step_m(how.radius_m)), from[c.a].off, to[c.b].off, {}};
  }
  return std::nullopt;
}

/// The poses from which a quarter turn, or the same length straight on, stays in the water.
std::vector<Cut> Connector::Impl::ones_with_room(const std::vector<Cut>& all, bool leaving,
                                                 const PoseSearchOptions& how) const {
  std::vector<Cut> result;
  const double quarter = 0.5 * std::numbers::pi * how.radius_m;
  for (const Cut& cut : all) {
    const Pose pose = leaving ? cut.pose : turned_back(cut.pose);
    for (const int turn : {0, 1, -1}) {
      const DubinsPath out(pose, how.radius_m, {turn, 0, 0}, {quarter, 0, 0});
      if (!stays_in_water(out, how)) continue;
      result.push_back(cut);
      break;
    }
  }
  return result;
}

std::vector<Vec2> Connector::Impl::written(const std::vector<Pose>& poses,
                                           const PoseSearchOptions& how) const {
  std::vector<Vec2> points{poses.front().position};
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const auto path = dubins_in_water(poses[i - 1], poses[i], how);
    if (!path) return {};
    const auto piece = path->points(curve_step_m(how.radius_m));
    points.insert(points.end(), piece.begin() + 1, piece.end());
  }
  return points;
}

std::optional<Connection> Connector::Impl::by_way(const std::vector<Cut>& from,
                                                  const std::vector<Cut>& to, Estimate estimate,
                                                  PoseSearchOptions how) const {
  const auto leave = ones_with_room(from, true, how);
  const auto arrive = ones_with_room(to, false, how);
  if (estimate.in_sight) how.most_poses *= kMorePoses;
  for (std::size_t k = 0; k < (estimate.in_sight ? 1 : kTries); ++k) {
    if (leave.empty() || arrive.empty()) break;
    const Cut& a = leave[std::min(k * leave.size() / kTries, leave.size() - 1)];
    const Cut& b = arrive[std::min(k * arrive.size() / kTries, arrive.size() - 1)];
    const auto way = ways.find(a.pose.position, b.pose.position);
    if (!way) break;
    const TautWay taut(*way);
    const auto to_go = [&](const Vec2& p) {
      return estimate.in_sight ? taut.to_go_in_sight(p, water.outline()) : taut.to_go(p);
    };
    const bool misled = kMisled * to_go(a.pose.position) < taut.length_m();
    if (misled != estimate.misled) continue;
    const auto poses = search_poses(a.pose, b.pose, to_go, how);
    if (!poses) continue;
    std::vector<Vec2> points = written(*poses, how);
    if (points.empty()) continue;
    return Connection{JoinKind::way, std::move(points), a.off, b.off, {}};
  }
  return std::nullopt;
}

/// Goes from stage to stage. A stage that cannot be reached is left out, but never the last one.
std::optional<std::vector<Pose>> Connector::Impl::staged(const std::vector<Pose>& stages,
                                                         const std::vector<Vec2>& way,
                                                         const PoseSearchOptions& how) const {
  const TautWay taut(way);
  std::vector<Pose> poses{stages.front()};
  for (std::size_t k = 1; k < stages.size(); ++k) {
    const Pose& goal = stages[k];
    const double beyond = taut.to_go(goal.position);
    const auto to_go = [&](const Vec2& p) {
      return std::max((p - goal.position).norm(), taut.to_go(p) - beyond);
    };
    const auto piece = search_poses(poses.back(), goal, to_go, how);
    if (piece) poses.insert(poses.end(), piece->begin() + 1, piece->end());
    if (!piece && k + 1 == stages.size()) return std::nullopt;
  }
  return poses;
}

/// Goes a long way in stages along the taut way. A single search over all of it runs out of poses.
std::optional<Connection> Connector::Impl::by_stages(const std::vector<Cut>& from,
                                                     const std::vector<Cut>& to,
                                                     const PoseSearchOptions& how) const {
  const auto leave = ones_with_room(from, true, how);
  const auto arrive = ones_with_room(to, false, how);
  for (std::size_t k = 0; k < kTries && !leave.empty() && !arrive.empty(); ++k) {
    const Cut& a = leave[k * leave.size() / kTries];
    const Cut& b = arrive[k * arrive.size() / kTries];
    const auto way = ways.find(a.pose.position, b.pose.position);
    if (!way) break;
    std::vector<Pose> stages{a.pose};
    add_stages(*way, how.radius_m, stages);
    stages.push_back(b.pose);
    const auto poses = staged(stages, *way, how);
    if (!poses) continue;
    std::vector<Vec2> points = written(*poses, how);
    if (points.empty()) continue;
    return Connection{JoinKind::way, std::move(points), a.off, b.off, {}};
  }
  return std::nullopt;
}

/// Whether the straight way is cut by less than a turning circle, and the way around is long.
bool Connector::Impl::behind_thin_wall(const Vec2& a, const Vec2& b) const {
  const double straight = (b - a).norm();
  if (straight - water.outline().inside_length(a, b) > 2.0 * options.radius_m) return false;
  const auto way = ways.find(a, b);
  return way && TautWay(*way).length_m() > kDetour * straight;
}

/// A search that distances through the water lead.
std::optional<Connection> Connector::Impl::around_wall(const std::vector<Cut>& from,
                                                       const std::vector<Cut>& to) {
  const auto leave = ones_with_room(from, true, search);
  const auto arrive = ones_with_room(to, false, search);
  if (!distances) distances.emplace(water);
  for (std::size_t k = 0; k < kTries && !leave.empty() && !arrive.empty(); ++k) {
    const Cut& a = leave[k * leave.size() / kTries];
    const Cut& b = arrive[k * arrive.size() / kTries];
    const std::vector<float>& metres = distances->to(b.pose.position);
    const double most = distances->from(a.pose.position, metres);
    const auto to_go = [&](const Vec2& p) {
      const double straight = (p - b.pose.position).norm();
      const double left = distances->from(p, metres);
      return std::max(straight, std::isfinite(left) ? left : most + straight);
    };
    const auto poses = search_poses(a.pose, b.pose, to_go, search);
    if (!poses) continue;
    std::vector<Vec2> points = written(*poses, search);
    if (points.empty()) continue;
    return Connection{JoinKind::way, std::move(points), a.off, b.off, {}};
  }
  return std::nullopt;
}

std::optional<Connection> Connector::Impl::by_search(const std::vector<Cut>& from,
                                                     const std::vector<Cut>& to) {
  if (from.empty() || to.empty()) return std::nullopt;
  if (behind_thin_wall(from.front().pose.position, to.front().pose.position)) {
    if (auto found = around_wall(from, to)) return found;
    return by_stages(from, to, search);
  }
  // The plain estimate is quick and nearly always enough.
  for (const bool in_sight : {false, true}) {
    if (auto found = by_way(from, to, {in_sight, false}, search)) return found;
  }
  if (auto found = by_stages(from, to, search)) return found;
  for (const bool in_sight : {false, true}) {
    if (auto found = by_way(from, to, {in_sight, true}, search)) return found;
  }
  return std::nullopt;
}

Connection Connector::Impl::infeasible(const Vec2& a, const Vec2& b) const {
  Connection none;
  const auto way = ways.find(a, b);
  none.points = way.value_or(std::vector<Vec2>{a, b});
  none.reason =
      way ? fmt::format("no forward way with turns of {:g} m from {} to {} stays in safe water",
                        options.radius_m, at_text(a, options.frame), at_text(b, options.frame))
          : fmt::format(
                "no way through the water from {} to {}: the transit between these separate "
                "waters crosses land and is counted as outside the water",
                at_text(a, options.frame), at_text(b, options.frame));
  return none;
}

Connector::Connector(const Area& safe_water, const ConnectOptions& options)
    : impl_(std::make_unique<Impl>(safe_water, options)) {}
Connector::~Connector() = default;
Connector::Connector(Connector&&) noexcept = default;
Connector& Connector::operator=(Connector&&) noexcept = default;

Connector::Effort Connector::effort() const { return impl_->effort; }

Connection Connector::join(const std::vector<Vec2>& before, const std::vector<Vec2>& after) const {
  std::vector<double> key;
  key.reserve(2 * (before.size() + after.size()) + 1);
  key.push_back(static_cast<double>(before.size()));
  for (const auto* line : {&before, &after}) {
    for (const Vec2& p : *line) key.insert(key.end(), {p.x(), p.y()});
  }
  if (const auto known = impl_->joins.find(key); known != impl_->joins.end()) return known->second;
  const auto from = impl_->sides(before, false, impl_->options);
  const auto to = impl_->sides(after, true, impl_->options);
  if (auto found = impl_->by_curve(from, to, impl_->search)) return *found;
  const auto found = impl_->by_search(from, to);
  Connection join = found ? *found : impl_->infeasible(before.back(), after.front());
  impl_->joins.emplace(std::move(key), join);
  return join;
}

std::optional<Connection> Connector::wider_join(const std::vector<Vec2>& before,
                                                const std::vector<Vec2>& after,
                                                double radius_m) const {
  ConnectOptions lines = impl_->options;
  PoseSearchOptions how = impl_->search;
  lines.radius_m = radius_m;
  how.radius_m = std::max(radius_m, how.radius_m);
  how.most_poses /= kFewerPoses;
  const auto from = impl_->sides(before, false, lines);
  const auto to = impl_->sides(after, true, lines);
  if (auto found = impl_->by_curve(from, to, how)) return found;
  return impl_->by_way(from, to, {}, how);
}

bool Connector::has_room(const std::vector<Vec2>& line) const {
  const auto end = impl_->sides(line, false, impl_->options);
  const auto begin = impl_->sides(line, true, impl_->options);
  return !impl_->ones_with_room(end, true, impl_->search).empty() &&
         !impl_->ones_with_room(begin, false, impl_->search).empty();
}

std::vector<Vec2> Connector::curve(const Pose& from, const Pose& to) const {
  const auto path = dubins_in_water(from, to, impl_->search);
  if (!path) return {};
  // Chords turn by about as much as those of a line's own curves. Where two curves meet, chords of
  // another angle would bend tighter than both.
  const double step = Angle::degrees(kCurveStepDeg).rad() * impl_->search.radius_m;
  const double parts = std::max(1.0, std::round(path->length_m() / step));
  constexpr double kDown = 1.0 + 1e-9;  // else rounding could make one part more
  std::vector<Vec2> even = path->points(kDown * path->length_m() / parts);
  return impl_->water.holds(even) ? even : path->points(curve_step_m(impl_->search.radius_m));
}

bool Connector::in_water(const std::vector<Vec2>& points) const {
  return impl_->water.holds(points);
}

}  // namespace swathplan
