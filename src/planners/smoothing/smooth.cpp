#include "planners/smoothing/smooth.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/base/error.h"
#include "mesh/plane/segments.h"
#include "planners/smoothing/path_relaxation_internal.h"
#include "planners/smoothing/path_solver_internal.h"
#include "planners/smoothing/smooth_samples_internal.h"
#include "planners/steering/line_poses.h"

namespace swathplan {
namespace {

/// Steps may shrink and grow by this share. The curvature bound is that of the shortest step.
constexpr double kShortest = 0.93;
constexpr double kLongest = 1.12;
/// A step that is shorter at the start may shrink to this share of itself.
constexpr double kStartShare = 0.98;
/// Reserve of the radius: the second difference bounds the turn of chords, not that of arcs.
constexpr double kRadiusShare = 0.97;
/// Number of points at either end of a window that stay where the neighbouring window put them.
constexpr std::size_t kHeldPoints = 2;
constexpr int kMostSmoothIterations = 80;

/// The problem of the points [from, to). All other points stay.
class Window {
 public:
  Window(const Samples& s, const std::vector<Vec2>& wanted, const std::vector<Vec2>& now,
         const std::vector<double>& room, const SmoothOptions& o, std::size_t from, std::size_t to)
      : s_(s), wanted_(wanted), now_(now), room_(room), o_(o), from_(from), to_(to) {
    const std::size_t n = to - from;
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t i = from + k;
      const bool held = (k < kHeldPoints && from > 0) || k == 0 || k + 1 == n ||
                        (k + kHeldPoints >= n && to < s.points.size());
      held_.push_back(held ? 1 : 0);
      const double r = held ? 0.0 : room[i];
      const Vec2& middle = held ? now[i] : s.points[i];
      problem_.start.push_back(now[i]);
      problem_.low.push_back(middle - Vec2::Constant(r));
      problem_.high.push_back(middle + Vec2::Constant(r));
    }
    add_shape();
  }

  [[nodiscard]] const PathProblem& problem() const { return problem_; }

 private:
  void add_shape() {
    const auto n = static_cast<int>(to_ - from_);
    const double scale = 1.0 / s_.step;
    for (int k = 0; k < n; ++k) {
      for (const int axis : {0, 1}) {
        if (k + 3 < n) {
          problem_.terms.push_back({{{2 * k + axis, -scale},
                                     {2 * k + 2 + axis, 3.0 * scale},
                                     {2 * k + 4 + axis, -3.0 * scale},
                                     {2 * k + 6 + axis, scale}},
                                    0.0,
                                    o_.curvature_weight});
        }
        problem_.terms.push_back({{{2 * k + axis, scale}},
                                  scale * wanted_[from_ + static_cast<std::size_t>(k)][axis],
                                  o_.deviation_weight});
      }
    }
    for (int k = 0; k + 1 < n; ++k) add_step(k);
    for (int k = 1; k + 1 < n; ++k) add_bend(k);
  }

  /// Keeps steps even. Steps that cut off a corner of the skeleton are shorter from the start and
  /// may stay so.
  void add_step(int k) {
    const auto c = static_cast<std::size_t>(k);
    if (held_[c] && held_[c + 1]) return;
    const double step = s_.step;
    const double chord = std::min((s_.points[from_ + c + 1] - s_.points[from_ + c]).norm(),
                                  (now_[from_ + c + 1] - now_[from_ + c]).norm());
    const double low = std::min(kShortest * step, kStartShare * chord);
    problem_.norms.push_back(
        {{{k, -1.0}, {k + 1, 1.0}}, low * low, kLongest * kLongest * step * step});
  }

  /// Bounds the bend between two steps by that of the radius. A corner of the skeleton with too
  /// little room for that keeps its bend. It is replaced, or counted, afterwards.
  void add_bend(int k) {
    const auto c = static_cast<std::size_t>(k);
    if (held_[c - 1] && held_[c] && held_[c + 1]) return;
    const bool any_held = held_[c - 1] || held_[c] || held_[c + 1];
    const std::size_t i = from_ + c;
    const auto& p = any_held ? now_ : s_.points;
    const double bound = kRadiusShare * kShortest * kShortest * s_.step * s_.step / o_.radius_m;
    const double bend = (p[i - 1] - 2.0 * p[i] + p[i + 1]).norm();
    const double room = any_held ? 0.0 : std::min({room_[i - 1], room_[i], room_[i + 1]});
    const double most = bend - 2.0 * room > bound ? kLongest * bend : bound;
    problem_.norms.push_back({{{k - 1, 1.0}, {k, -2.0}, {k + 1, 1.0}}, 0.0, most * most});
  }

  const Samples& s_;
  const std::vector<Vec2>& wanted_;
  const std::vector<Vec2>& now_;
  const std::vector<double>& room_;
  const SmoothOptions& o_;
  std::size_t from_, to_;
  std::vector<char> held_;
  PathProblem problem_;
};

void check(const SmoothOptions& o) {
  const auto require = [](bool good, const char* what, double value) {
    if (!good) throw UsageError(fmt::format("smoothing: {} {:g}; out of range", what, value));
  };
  require(o.radius_m > 0.0, "radius", o.radius_m);
  require(o.step_m > 0.0, "step", o.step_m);
  require(o.deviation_m >= 0.0, "deviation bound", o.deviation_m);
  require(o.window > o.overlap + 2 * kHeldPoints, "window", static_cast<double>(o.window));
}

/// Solves every window once. Each one joins on to what the window before it found.
void solve_windows(const Samples& s, const std::vector<Vec2>& wanted,
                   const std::vector<double>& room, const SmoothOptions& o, SmoothResult& result) {
  const std::size_t n = s.points.size();
  for (std::size_t from = 0; from < n;) {
    const std::size_t to = std::min(n, from + o.window);
    const PathSolution solved =
        o.watch.ended()
            ? PathSolution{"ended early", false, {}}
            : solved_by_ipopt(Window(s, wanted, result.points, room, o, from, to).problem(),
                              kMostSmoothIterations);
    o.watch.share(static_cast<double>(to) / static_cast<double>(n));
    ++result.windows;
    ++result.status[solved.status];
    const std::size_t solved_to = to == n ? n : to - o.overlap;
    if (solved.good) {
      // The next window starts from these points where the two overlap.
      for (std::size_t k = 0; k < solved.points.size(); ++k)
        result.points[from + k] = solved.points[k];
    } else {
      ++result.failed_windows;
      const auto kept = static_cast<std::ptrdiff_t>(from > 0 ? from + kHeldPoints : from);
      std::copy(s.points.begin() + kept, s.points.begin() + static_cast<std::ptrdiff_t>(solved_to),
                result.points.begin() + kept);
      result.failed_m += s.step * static_cast<double>(solved_to - from);
      std::fill(result.smoothed.begin() + static_cast<std::ptrdiff_t>(from),
                result.smoothed.begin() + static_cast<std::ptrdiff_t>(solved_to), char{0});
    }
    if (to == n) break;
    from = solved_to - kHeldPoints;
  }
}

}  // namespace

SmoothResult smooth_path(const std::vector<Vec2>& skeleton, const SmoothOptions& o) {
  check(o);
  SmoothResult result;
  const LinePoses line(skeleton);
  if (line.is_point() || line.length_m() < 4.0 * o.step_m) {
    result.points = line.points();
    result.along = line.along();
    result.smoothed.assign(result.points.size(), 0);
    return result;
  }
  const Samples s = sampled(line, o.step_m);
  const std::size_t n = s.points.size();
  const std::vector<double> room = rooms(s, o);
  result.points = s.points;
  result.along = s.along;
  result.smoothed.assign(n, 1);
  std::vector<Vec2> wanted = s.points;
  if (o.pull && o.pull_rounds > 0) {
    const PathRelaxation relaxation(n, o.curvature_weight, o.deviation_weight);
    for (int round = 0; round + 1 < o.pull_rounds && !o.watch.ended(); ++round) {
      wanted = o.pull(result.points, result.along);
      result.points = relaxation.relaxed(wanted, s.points, room);
    }
    wanted = o.pull(result.points, result.along);
  }
  solve_windows(s, wanted, room, o, result);
  return result;
}

ArcPath with_arcs(const std::vector<Vec2>& path, double step_deg) {
  ArcPath result;
  const auto add = [&](const Vec2& p, std::size_t i) {
    if (!result.points.empty() && (result.points.back() - p).norm() < LinePoses::kCoincidentM)
      return;
    result.points.push_back(p);
    result.source.push_back(i);
  };
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (i == 0 || i + 1 == path.size()) {
      add(path[i], i);
      continue;
    }
    const Vec2 in = path[i] - path[i - 1];
    const Vec2 out = path[i + 1] - path[i];
    const double turn = turn_angle(in, out);
    const double reach = 0.5 * std::min(in.norm(), out.norm());
    const double tangent = std::tan(0.5 * std::abs(turn));
    constexpr double kNoTangent = 1e-9;
    constexpr double kBack = 1e6;
    if (!(tangent > kNoTangent && tangent < kBack)) {
      add(path[i], i);
      continue;
    }
    const Vec2 u = in.normalized();
    const Vec2 begin = path[i] - reach * u;
    const double side = turn > 0.0 ? 1.0 : -1.0;
    const Vec2 arm = -side * (reach / tangent) * Vec2(-u.y(), u.x());
    const auto parts = static_cast<int>(
        std::max(1.0, std::ceil(std::abs(turn) * 180.0 / std::numbers::pi / step_deg)));
    // Between two steps of almost equal length a sliver would be left between their arcs. The arcs
    // meet in the middle of it instead.
    constexpr double kSliverM = 0.02;
    const bool sliver =
        result.points.size() > 1 && (result.points.back() - begin).norm() < kSliverM;
    if (sliver) result.points.back() = 0.5 * (result.points.back() + begin);
    for (int k = sliver ? 1 : 0; k <= parts; ++k) {
      const double c = std::cos(turn * k / parts);
      const double sn = std::sin(turn * k / parts);
      add(begin - arm + Vec2(c * arm.x() - sn * arm.y(), sn * arm.x() + c * arm.y()), i);
    }
  }
  return result;
}

}  // namespace swathplan
