#include "planners/fronts/line_angles.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstdint>

#include "mesh/base/parallel.h"

namespace swathplan {
namespace {

/// Sides are searched in steps of this share of a cell.
constexpr double kStepOfCell = 0.5;
/// Cells are claimed from points this close along a line.
constexpr double kClaimStepOfCell = 0.7;
/// A point is hidden if its tangent is less than this share of the largest tangent before it. The
/// share is below 1, since depths on a raster are rough.
constexpr double kHidden = 0.97;
/// A step opens as wide as the widest of so many steps before and after it, since boundaries on a
/// raster are jagged.
constexpr std::ptrdiff_t kStepsAround = 2;
constexpr double kJump = 1.25;
/// Less water than this below the sonar counts as this, metres.
constexpr double kLeastBelow = 0.05;
/// A side may end this far past the edge, metres, so that cells at the edge keep their beam.
constexpr double kPastEdge = 0.02;

/// Tells for each cell which line sees it from the fewest of its swaths away. Distance and line
/// share one word. The smallest word wins, so the order of the threads does not matter.
class Owners {
 public:
  explicit Owners(std::size_t cells) : words_(cells) {
    for (auto& word : words_) word.store(kNobody, std::memory_order_relaxed);
  }
  void offer(std::size_t cell, float swaths, std::uint32_t line) {
    // The bits of floats of 0 or more sort like the floats.
    const std::uint64_t word =
        (static_cast<std::uint64_t>(std::bit_cast<std::uint32_t>(swaths)) << 32U) | line;
    std::uint64_t now = words_[cell].load(std::memory_order_relaxed);
    while (word < now &&
           !words_[cell].compare_exchange_weak(now, word, std::memory_order_relaxed)) {
    }
  }
  [[nodiscard]] bool owns(std::size_t cell, std::uint32_t line) const {
    return static_cast<std::uint32_t>(words_[cell].load(std::memory_order_relaxed)) == line;
  }

 private:
  static constexpr std::uint64_t kNobody = ~std::uint64_t{0};
  std::vector<std::atomic<std::uint64_t>> words_;
};

/// Middle and starboard of each step of a line.
struct Step {
  Vec2 middle, starboard;
};

std::vector<Step> steps_of(const std::vector<Vec2>& points) {
  std::vector<Step> steps;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Vec2 course = (points[i + 1] - points[i]).normalized();
    steps.push_back({0.5 * (points[i] + points[i + 1]), {course.y(), -course.x()}});
  }
  return steps;
}

class SideReach {
 public:
  SideReach(const WaterRaster& raster, const std::vector<float>& width, const AreaQuery& area,
            const PlanOptions& options, const LineAnglesOptions& how)
      : raster_(raster), width_(width), area_(area), options_(options), how_(how) {}

  /// Calls f(cell, y, swaths) for every point of the side that the line sees, y metres off.
  template <class F>
  void see(const Vec2& p, const Vec2& side, double edge, const F& f) const {
    const double step = kStepOfCell * raster_.cell_m();
    const double w = how_.by_distance ? 1.0 : width_at(p);
    double tangent = 0.0;
    for (double y = 0.0; y < edge; y += step) {
      const auto i = raster_.cell_at(p + y * side);
      if (!i || !raster_.in_area(*i)) continue;
      const double here = y / std::max(raster_.depth(*i) - options_.vehicle.draft_m, kLeastBelow);
      // Nearer ground hides the point, so it belongs to another line.
      if (here < kHidden * tangent) continue;
      tangent = std::max(tangent, here);
      f(*i, y, y / w);
    }
  }

  /// Tangent of the half-angle that sees all points up to the farthest one of this line, and the
  /// overlap at that point's depth. What rises behind that point belongs to another line.
  [[nodiscard]] double tangent(const Step& s, bool port, std::uint32_t line,
                               const Owners& owners) const {
    const Vec2 side = port ? Vec2(-s.starboard) : s.starboard;
    const double edge = edge_distance(s.middle, side);
    double steepest = 0.0;
    double own = 0.0;
    double own_below = below(s.middle);
    double result = 0.0;
    see(s.middle, side, edge, [&](std::size_t cell, double y, double) {
      const double down = std::max(raster_.depth(cell) - options_.vehicle.draft_m, kLeastBelow);
      steepest = std::max(steepest, y / down);
      if (!owners.owns(cell, line)) return;
      own = y;
      own_below = down;
      result = steepest;
    });
    const double past = how_.overlap_m + how_.overlap_share * width_at(s.middle);
    const double reach = std::min(own + past + kStepOfCell * raster_.cell_m(), edge);
    return std::max(result, reach / own_below);
  }

  void claim(const Step& s, std::uint32_t line, Owners& owners) const {
    for (const Vec2& side : {s.starboard, Vec2(-s.starboard)}) {
      see(s.middle, side, edge_distance(s.middle, side),
          [&](std::size_t cell, double, double swaths) {
            owners.offer(cell, static_cast<float>(swaths), line);
          });
    }
  }

 private:
  /// Water below the sonar at p, metres.
  [[nodiscard]] double below(const Vec2& p) const {
    return std::max(raster_.depth_near(p).value_or(1.0) - options_.vehicle.draft_m, kLeastBelow);
  }
  [[nodiscard]] double width_at(const Vec2& p) const {
    const auto here = raster_.cell_at(p);
    return here && width_[*here] > 0.0F
               ? static_cast<double>(width_[*here])
               : gap_free_width_m(options_, below(p), options_.resolution_m);
  }
  [[nodiscard]] double edge_distance(const Vec2& p, const Vec2& side) const {
    const double most = counted_share(options_) * how_.widest_share * width_at(p);
    for (const auto& [t0, t1] : area_.clip(p, p + most * side)) {
      if (t0 * most < kPastEdge + 0.5 * raster_.cell_m()) {
        return std::min(most, t1 * most + kPastEdge);
      }
    }
    return 0.0;
  }

  const WaterRaster& raster_;
  const std::vector<float>& width_;
  const AreaQuery& area_;
  const PlanOptions& options_;
  const LineAnglesOptions& how_;
};

/// The widest of the steps around each step. Steps beyond a jump are left out: the jump is a wall.
std::vector<double> widest_around(const std::vector<double>& tangents) {
  std::vector<double> result(tangents);
  const auto n = static_cast<std::ptrdiff_t>(tangents.size());
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const double own = tangents[static_cast<std::size_t>(i)];
    for (std::ptrdiff_t k = std::max<std::ptrdiff_t>(0, i - kStepsAround);
         k <= std::min(n - 1, i + kStepsAround); ++k) {
      const double other = tangents[static_cast<std::size_t>(k)];
      if (other > kJump * own) continue;
      double& widest = result[static_cast<std::size_t>(i)];
      widest = std::max(widest, other);
    }
  }
  return result;
}

/// The half-angle whose counted share reaches `tangent`.
Angle half_angle(double tangent, const PlanOptions& options) {
  const Sonar& sonar = options.sonar;
  return Angle::radians(std::clamp(std::atan(tangent / counted_share(options)),
                                   Angle::degrees(kLeastSideDeg).rad(),
                                   0.5 * sonar.max_opening.rad()));
}

}  // namespace

std::vector<std::vector<Waypoint>> opened_lines(const std::vector<SurveyCurve>& lines,
                                                const WaterRaster& raster,
                                                const std::vector<float>& width,
                                                const AreaQuery& survey_area,
                                                const PlanOptions& options,
                                                const LineAnglesOptions& how, int first_number) {
  const SideReach sides(raster, width, survey_area, options, how);
  Owners owners(raster.size());
  for_each_index(std::size_t{0}, lines.size(), [&](std::size_t k) {
    // These steps are closer than those of the fans, so that no cell between two fans is missed.
    const auto dense = resampled(lines[k], kClaimStepOfCell * raster.cell_m());
    for (const Step& s : steps_of(dense.points)) {
      sides.claim(s, static_cast<std::uint32_t>(k), owners);
    }
  });
  std::vector<std::vector<Waypoint>> result(lines.size());
  for_each_index(std::size_t{0}, lines.size(), [&](std::size_t k) {
    const auto& points = lines[k].points;
    if (points.size() < 2) return;
    const std::vector<Step> steps = steps_of(points);
    const std::size_t n = steps.size();
    std::vector<double> right(n), left(n);
    for (std::size_t i = 0; i < n; ++i) {
      right[i] = sides.tangent(steps[i], false, static_cast<std::uint32_t>(k), owners);
      left[i] = sides.tangent(steps[i], true, static_cast<std::uint32_t>(k), owners);
    }
    right = widest_around(right);
    left = widest_around(left);
    Waypoint point;
    point.line = first_number + static_cast<int>(k);
    point.speed_mps = options.vehicle.speed_mps;
    for (std::size_t i = 0; i < n; ++i) {
      point.position = points[i];
      point.fan = FanAngles{half_angle(left[i], options), half_angle(right[i], options)};
      result[k].push_back(point);
    }
    point.position = points.back();
    result[k].push_back(point);
  });
  return result;
}

}  // namespace swathplan
