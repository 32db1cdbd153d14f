#include "planners/steering/pose_search.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <queue>
#include <unordered_map>

#include "planners/steering/connect.h"

namespace swathplan {
namespace {

constexpr int kCourses = 24;
/// Arcs of the lattice turn by this much: every second course.
constexpr double kArc = 2.0 * (2.0 * std::numbers::pi / kCourses);
/// Straights of the lattice, in lengths of an arc.
constexpr double kStraights[] = {1.0, 4.0};
/// A Dubins path to the goal is tried from every pose nearer than this (radii), and from each
/// kTryEvery-th of the others.
constexpr double kNearGoal = 8.0;
constexpr int kTryEvery = 8;

struct Node {
  Pose pose;
  double cost;
  int before;
};

class Search {
 public:
  Search(const Pose& from, const Pose& to, const std::function<double(const Vec2&)>& to_go,
         const PoseSearchOptions& options)
      : goal_(to), to_go_(to_go), options_(options), cell_(0.5 * kArc * options.radius_m) {
    nodes_.push_back({from, 0.0, -1});
    best_[key(from)] = 0.0;
    open_.emplace(to_go_(from.position), 0);
  }

  std::optional<std::vector<Pose>> run() {
    auto way = found();
    if (options_.searched) options_.searched(taken_);
    return way;
  }

 private:
  std::optional<std::vector<Pose>> found() {
    while (!open_.empty() && taken_ < options_.most_poses) {
      const int i = open_.top().second;
      open_.pop();
      const Node node = nodes_[static_cast<std::size_t>(i)];
      if (node.cost > best_.at(key(node.pose)) + 1e-9) continue;
      const double away = (node.pose.position - goal_.position).norm();
      if ((taken_++ % kTryEvery == 0 || away < kNearGoal * options_.radius_m) &&
          dubins_in_water(node.pose, goal_, options_)) {
        return way_to(i);
      }
      expand(i);
    }
    return std::nullopt;
  }

  [[nodiscard]] std::int64_t key(const Pose& pose) const {
    const auto x = static_cast<std::int64_t>(std::floor(pose.position.x() / cell_)) & 0xFFFFFF;
    const auto y = static_cast<std::int64_t>(std::floor(pose.position.y() / cell_)) & 0xFFFFFF;
    const double turn = std::atan2(pose.course.y(), pose.course.x()) / (2.0 * std::numbers::pi);
    const auto c = static_cast<std::int64_t>(std::lround(turn * kCourses) + kCourses) % kCourses;
    return (x << 32) | (y << 8) | c;
  }

  void expand(int i) {
    const Node node = nodes_[static_cast<std::size_t>(i)];
    const double arc = kArc * options_.radius_m;
    for (const int turn : {1, -1})
      step(i, {node.pose, options_.radius_m, {turn, 0, 0}, {arc, 0, 0}});
    for (const double length : kStraights) {
      step(i, {node.pose, options_.radius_m, {0, 0, 0}, {length * arc, 0, 0}});
    }
  }

  void step(int i, const DubinsPath& path) {
    const Pose pose = path.at(path.length_m());
    const double cost = nodes_[static_cast<std::size_t>(i)].cost + path.length_m();
    const auto [found, fresh] = best_.try_emplace(key(pose), cost);
    if (!fresh && found->second <= cost) return;
    if (!stays_in_water(path, options_)) {
      if (fresh) best_.erase(found);
      return;
    }
    found->second = cost;
    nodes_.push_back({pose, cost, i});
    open_.emplace(cost + to_go_(pose.position), static_cast<int>(nodes_.size()) - 1);
  }

  [[nodiscard]] std::vector<Pose> way_to(int i) const {
    std::vector<Pose> way{goal_};
    for (; i >= 0; i = nodes_[static_cast<std::size_t>(i)].before) {
      way.push_back(nodes_[static_cast<std::size_t>(i)].pose);
    }
    std::reverse(way.begin(), way.end());
    return way;
  }

  Pose goal_;
  const std::function<double(const Vec2&)>& to_go_;
  const PoseSearchOptions& options_;
  double cell_;
  int taken_ = 0;
  std::vector<Node> nodes_;
  std::unordered_map<std::int64_t, double> best_;
  using Item = std::pair<double, int>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> open_;
};

/// Drops poses where a direct Dubins path between their neighbours is no longer.
std::vector<Pose> taut(const std::vector<Pose>& way, const PoseSearchOptions& options) {
  std::vector<double> along{0.0};
  for (std::size_t i = 1; i < way.size(); ++i) {
    along.push_back(along.back() + dubins_length_m(way[i - 1], way[i], options.radius_m));
  }
  std::vector<Pose> result{way.front()};
  for (std::size_t i = 0; i + 1 < way.size();) {
    std::size_t next = i + 1;
    constexpr std::size_t kLookAhead = 60;
    for (std::size_t j = std::min(way.size() - 1, i + kLookAhead); j > i + 1; --j) {
      const auto path = dubins_in_water(way[i], way[j], options);
      if (path && path->length_m() <= along[j] - along[i] + 1e-9) {
        next = j;
        break;
      }
    }
    result.push_back(way[next]);
    i = next;
  }
  return result;
}

}  // namespace

double curve_step_m(double radius_m) {
  return std::min(kCurveStepM, Angle::degrees(kCurveStepDeg).rad() * radius_m);
}

namespace {

/// Goes along the chords that the path would be written in, and ends at the first that leaves the
/// water. Chords in a clear circle need no test.
bool chords_stay(const DubinsPath& path, const PoseSearchOptions& options) {
  constexpr double kInCircle = 0.999;  // off the rounding of its border
  const double length = path.length_m();
  const int parts =
      static_cast<int>(std::max(1.0, std::ceil(length / curve_step_m(options.radius_m))));
  const auto corner = [&](int k) { return path.at(length * k / parts).position; };
  std::vector<Vec2> chord{corner(0), corner(0)};
  for (int k = 0; k < parts;) {
    // A chord is no longer than its curve.
    const double clear = kInCircle * options.clear_around(chord[0]) * parts;
    const int in_circle =
        clear >= length * (parts - k) ? parts - k : static_cast<int>(clear / length);
    if (in_circle > 0) {
      k += in_circle;
      chord[0] = corner(k);
      continue;
    }
    chord[1] = corner(++k);
    if (!options.in_water(chord)) return false;
    chord[0] = chord[1];
  }
  return true;
}

}  // namespace

bool stays_in_water(const DubinsPath& path, const PoseSearchOptions& options) {
  // A few places are tested first: nearly all paths that leave the water fail there. To write the
  // thousands of points of each path would cost a hundred times as much.
  constexpr int kPlaces = 24;
  const double length = path.length_m();
  const int places = length > kPlaces * curve_step_m(options.radius_m) ? kPlaces : 2;
  for (int k = 0; k <= places; ++k) {
    if (!options.place_in_water(path.at(length * k / places).position)) return false;
  }
  if (options.clear_around) return chords_stay(path, options);
  return options.in_water(path.points(curve_step_m(options.radius_m)));
}

std::optional<DubinsPath> dubins_in_water(const Pose& from, const Pose& to,
                                          const PoseSearchOptions& options) {
  for (const DubinsPath& path : dubins_paths(from, to, options.radius_m)) {
    if (stays_in_water(path, options)) return path;
  }
  return std::nullopt;
}

std::optional<std::vector<Pose>> search_poses(const Pose& from, const Pose& to,
                                              const std::function<double(const Vec2&)>& to_go,
                                              const PoseSearchOptions& options) {
  auto way = Search(from, to, to_go, options).run();
  if (way) way = taut(*way, options);
  return way;
}

}  // namespace swathplan
