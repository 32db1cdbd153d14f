#include "planners/rows/part_within.h"

#include <algorithm>

namespace swathplan {
namespace {

/// A part fills the goal to this share: rounding must not carry it beyond.
constexpr double kFilled = 1.0 - 1e-9;

class PartFinder {
 public:
  PartFinder(const Route& route, const PlanGoal& goal)
      : w_(route.waypoints), timed_(goal.time_s.has_value()) {
    limit_ = kFilled * (timed_ ? *goal.time_s : goal.length_m.value_or(0.0));
    used_.assign(w_.size(), 0.0);
    logged_.assign(w_.size(), 0.0);
    for (std::size_t i = 0; i + 1 < w_.size(); ++i) {
      const double metres = (w_[i + 1].position - w_[i].position).norm();
      used_[i + 1] = used_[i] + (timed_ ? metres / w_[i].speed_mps : metres);
      logged_[i + 1] = logged_[i] + (w_[i].log ? metres : 0.0);
    }
  }

  std::optional<Route> found(double least_line_m) const {
    const std::vector<Range> lines = whole_lines();
    Range best;
    std::size_t to = 0;
    for (std::size_t from = 0; from < lines.size(); ++from) {
      to = std::max(to, from);
      while (to < lines.size() && used(lines[from].first, lines[to].last) <= limit_) ++to;
      if (to == from) continue;
      const Range part{lines[from].first, lines[to - 1].last};
      if (line_m(part) > line_m(best)) best = part;
    }
    if (best.last > best.first) return cut(best, w_[best.last].position);
    return part_of_longest(lines, least_line_m);
  }

 private:
  /// Indices of waypoints.
  struct Range {
    std::size_t first = 0, last = 0;
  };

  [[nodiscard]] double used(std::size_t from, std::size_t to) const {
    return used_[to] - used_[from];
  }
  [[nodiscard]] double line_m(const Range& r) const { return logged_[r.last] - logged_[r.first]; }

  /// Runs of legs between two joins: a line with its run-in and run-out.
  [[nodiscard]] std::vector<Range> whole_lines() const {
    std::vector<Range> lines;
    bool open = false;
    for (std::size_t i = 0; i + 1 < w_.size(); ++i) {
      const bool join = w_[i].kind == LegKind::turn || w_[i].kind == LegKind::transit;
      if (join || !open) {
        open = !join;
        if (join) continue;
        lines.push_back({i, i + 1});
      } else {
        lines.back().last = i + 1;
      }
    }
    std::erase_if(lines, [&](const Range& r) { return !(line_m(r) > 0.0); });
    return lines;
  }

  [[nodiscard]] std::optional<Route> part_of_longest(const std::vector<Range>& lines,
                                                     double least_line_m) const {
    const auto longest =
        std::max_element(lines.begin(), lines.end(),
                         [&](const Range& a, const Range& b) { return line_m(a) < line_m(b); });
    if (longest == lines.end()) return std::nullopt;
    std::size_t last = longest->first;
    while (last < longest->last && used(longest->first, last + 1) <= limit_) ++last;
    if (last == longest->last) return cut(*longest, w_[last].position);
    const double share = (limit_ - used(longest->first, last)) / used(last, last + 1);
    const Vec2 end = w_[last].position + share * (w_[last + 1].position - w_[last].position);
    const double metres = line_m({longest->first, last}) + (end - w_[last].position).norm();
    if (metres < least_line_m || !(metres > 0.0)) return std::nullopt;
    return cut({longest->first, last + 1}, end);
  }

  [[nodiscard]] Route cut(const Range& part, const Vec2& end) const {
    Route route;
    route.waypoints.assign(w_.begin() + static_cast<std::ptrdiff_t>(part.first),
                           w_.begin() + static_cast<std::ptrdiff_t>(part.last) + 1);
    Waypoint& last = route.waypoints.back();
    last.position = end;
    last.kind = LegKind::end;
    last.log = false;
    last.line.reset();
    std::optional<int> before;
    int number = 0;
    for (Waypoint& point : route.waypoints) {
      if (!point.line) continue;
      if (point.line != before) ++number;
      before = point.line;
      point.line = number;
    }
    return route;
  }

  const std::vector<Waypoint>& w_;
  bool timed_;
  double limit_ = 0.0;
  std::vector<double> used_;    ///< metres or seconds from the start to a waypoint
  std::vector<double> logged_;  ///< metres of it that are logged
};

}  // namespace

std::optional<Route> part_within(const Route& route, const PlanGoal& goal, double least_line_m) {
  if ((!goal.length_m && !goal.time_s) || route.waypoints.size() < 2) return std::nullopt;
  return PartFinder(route, goal).found(least_line_m);
}

}  // namespace swathplan
