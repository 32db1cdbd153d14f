#include "planners/line_angles.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstdint>

namespace swathplan {
namespace {

/// Reaches are looked for in steps of this share of a cell.
constexpr double kStepOfCell = 0.5;
/// Cells are claimed from points this close along a line.
constexpr double kClaimStepOfCell = 0.7;
/// A point counts as hidden where it stands under this share of the steepest tangent before it:
/// less than 1, since depths on a raster are rough.
constexpr double kHidden = 0.97;
/// Reaches of so many points before and after are joined: boundaries on a raster are jagged.
constexpr std::ptrdiff_t kJoin = 2;
/// A side may end so far past the edge, metres: cells at the edge keep their beam.
constexpr double kPastEdge = 0.02;

/// Which line sees a cell from the fewest of its swaths away. Cost and line share a word, so that
/// the least of both wins in whatever order threads come by.
class Owners {
 public:
  explicit Owners(std::size_t cells) : words_(cells) {
    for (auto& word : words_) word.store(kNobody, std::memory_order_relaxed);
  }
  void offer(std::size_t cell, float swaths, std::uint32_t line) {
    // The bits of floats that are not negative sort like the floats.
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
            const PlanningGround& ground, const PlanOptions& options, const LineAnglesOptions& how)
      : raster_(raster),
        width_(width),
        area_(area),
        ground_(ground),
        options_(options),
        how_(how) {}

  /// Calls f(cell, y, swaths) for every point of the side that the line sees, y metres off.
  template <class F>
  void see(const Vec2& p, const Vec2& side, double edge, const F& f) const {
    const double step = kStepOfCell * raster_.cell_m();
    const double w = width_at(p);
    double tangent = 0.0;
    for (double y = 0.0; y < edge; y += step) {
      const auto i = raster_.cell_at(p + y * side);
      if (!i || !raster_.in_area(*i)) continue;
      const double here = y / std::max(raster_.depth(*i) - options_.vehicle.draft_m, 0.05);
      // What the ground nearer by hides is some other line's.
      if (here < kHidden * tangent) continue;
      tangent = std::max(tangent, here);
      f(*i, y, y / w);
    }
  }

  /// How far the farthest point lies that no other line sees from nearer, metres.
  [[nodiscard]] double reach(const Step& s, bool port, std::uint32_t line,
                             const Owners& owners) const {
    const Vec2 side = port ? Vec2(-s.starboard) : s.starboard;
    const double edge = edge_distance(s.middle, side);
    double own = 0.0;
    see(s.middle, side, edge, [&](std::size_t cell, double y, double) {
      if (owners.owns(cell, line)) own = y;
    });
    return std::min(own + how_.overlap_m + kStepOfCell * raster_.cell_m(), edge);
  }

  void claim(const Step& s, std::uint32_t line, Owners& owners) const {
    for (const Vec2& side : {s.starboard, Vec2(-s.starboard)}) {
      see(s.middle, side, edge_distance(s.middle, side),
          [&](std::size_t cell, double, double swaths) {
            owners.offer(cell, static_cast<float>(swaths), line);
          });
    }
  }

  /// The half-angle that sees every point up to `reach`.
  [[nodiscard]] Angle angle(const Vec2& p, const Vec2& side, double reach) const {
    const double step = std::max(0.25, kStepOfCell * raster_.cell_m());
    double tangent = 0.0;
    double below = depth(p, 1.0);
    const auto look = [&](double y) {
      below = depth(p + y * side, below);
      tangent = std::max(tangent, y / std::max(below - options_.vehicle.draft_m, 0.05));
    };
    for (double y = step; y < reach; y += step) look(y);
    look(reach);
    const double half = std::clamp(std::atan(tangent), Angle::degrees(kLeastSideDeg).rad(),
                                   0.5 * options_.sonar.max_opening.rad());
    return Angle::radians(half);
  }

 private:
  [[nodiscard]] double depth(const Vec2& p, double otherwise) const {
    return ground_.depths->depth(p).value_or(otherwise);
  }
  [[nodiscard]] double width_at(const Vec2& p) const {
    const auto here = raster_.cell_at(p);
    return here && width_[*here] > 0.0F
               ? static_cast<double>(width_[*here])
               : gap_free_width_m(options_, depth(p, 1.0), options_.resolution_m);
  }
  [[nodiscard]] double edge_distance(const Vec2& p, const Vec2& side) const {
    const double most = how_.widest_share * width_at(p);
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
  const PlanningGround& ground_;
  const PlanOptions& options_;
  const LineAnglesOptions& how_;
};

std::vector<double> joined(const std::vector<double>& reach) {
  std::vector<double> result(reach.size());
  const auto n = static_cast<std::ptrdiff_t>(reach.size());
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    double most = 0.0;
    for (std::ptrdiff_t k = std::max<std::ptrdiff_t>(0, i - kJoin); k <= std::min(n - 1, i + kJoin);
         ++k) {
      most = std::max(most, reach[static_cast<std::size_t>(k)]);
    }
    result[static_cast<std::size_t>(i)] = most;
  }
  return result;
}

}  // namespace

std::vector<std::vector<Waypoint>> opened_lines(
    const std::vector<SurveyCurve>& lines, const WaterRaster& raster,
    const std::vector<float>& width, const AreaQuery& survey_area, const PlanningGround& ground,
    const PlanOptions& options, const LineAnglesOptions& how, int first_number) {
  const SideReach sides(raster, width, survey_area, ground, options, how);
  Owners owners(raster.size());
  tbb::parallel_for(std::size_t{0}, lines.size(), [&](std::size_t k) {
    // Closer steps than the fans', so that no cell between two of them is passed over.
    const auto dense = resampled(lines[k], kClaimStepOfCell * raster.cell_m());
    for (const Step& s : steps_of(dense.points)) {
      sides.claim(s, static_cast<std::uint32_t>(k), owners);
    }
  });
  std::vector<std::vector<Waypoint>> result(lines.size());
  tbb::parallel_for(std::size_t{0}, lines.size(), [&](std::size_t k) {
    const auto& points = lines[k].points;
    if (points.size() < 2) return;
    const std::vector<Step> steps = steps_of(points);
    const std::size_t n = steps.size();
    std::vector<double> right(n), left(n);
    for (std::size_t i = 0; i < n; ++i) {
      right[i] = sides.reach(steps[i], false, static_cast<std::uint32_t>(k), owners);
      left[i] = sides.reach(steps[i], true, static_cast<std::uint32_t>(k), owners);
    }
    right = joined(right);
    left = joined(left);
    Waypoint point;
    point.line = first_number + static_cast<int>(k);
    point.speed_mps = options.vehicle.speed_mps;
    for (std::size_t i = 0; i < n; ++i) {
      point.position = points[i];
      point.fan = FanAngles{sides.angle(steps[i].middle, -steps[i].starboard, left[i]),
                            sides.angle(steps[i].middle, steps[i].starboard, right[i])};
      result[k].push_back(point);
    }
    point.position = points.back();
    result[k].push_back(point);
  });
  return result;
}

}  // namespace swathplan
