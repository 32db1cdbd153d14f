#include "planners/nuc/skeleton_smoothing.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>

#include "mesh/plane/area_query.h"
#include "mesh/plane/segments.h"

namespace swathplan {
namespace {

/// Distances from short segments to the blocked segments and to the water's edge.
class Clearance {
 public:
  Clearance(const std::vector<std::pair<Vec2, Vec2>>& blocked, const Area& water, double reach)
      : blocked_(blocked), water_(water), cell_(4.0 * reach) {
    for (std::size_t i = 0; i < blocked.size(); ++i) {
      const auto& [a, b] = blocked[i];
      const Vec2 low = a.cwiseMin(b) - Vec2::Constant(2.0 * reach);
      const Vec2 high = a.cwiseMax(b) + Vec2::Constant(2.0 * reach);
      for (auto x = index(low.x()); x <= index(high.x()); ++x) {
        for (auto y = index(low.y()); y <= index(high.y()); ++y) cells_[key(x, y)].push_back(i);
      }
    }
  }

  /// A lower bound of the distance. Three points are measured; every point of the segment lies
  /// within a quarter of its length of one of them.
  double operator()(const Vec2& a, const Vec2& b) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Vec2& p : {a, Vec2(0.5 * (a + b)), b}) {
      if (!water_.contains(p)) return 0.0;
      least = std::min(least, water_.distance(p));
      const auto near = cells_.find(key(index(p.x()), index(p.y())));
      if (near == cells_.end()) continue;
      for (const std::size_t i : near->second) {
        least = std::min(least, distance_to_segment(blocked_[i].first, blocked_[i].second, p));
      }
    }
    return std::max(0.0, least - 0.25 * (b - a).norm());
  }

 private:
  [[nodiscard]] std::int64_t index(double x) const {
    return static_cast<std::int64_t>(std::floor(x / cell_));
  }
  static std::int64_t key(std::int64_t x, std::int64_t y) { return (x << 32) ^ (y & 0xFFFFFFFF); }

  const std::vector<std::pair<Vec2, Vec2>>& blocked_;
  AreaQuery water_;
  double cell_;
  std::unordered_map<std::int64_t, std::vector<std::size_t>> cells_;
};

/// Reserve of the radius: arcs between steps of unequal length turn a little tighter than the bound
/// on their chords.
constexpr double kSmoothReserve = 1.05;
/// A point moves by this many metres for each square metre that one metre of it would fill ...
constexpr double kPullStep = 1.0;
/// ... but by no more than this at once. With more, passes would swing past each other.
constexpr double kLongestPullM = 1.0;

std::vector<Vec2> pulled(std::vector<Vec2> points, const ThinCover::Pull& pull) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 way = kPullStep * pull.down[i];
    points[i] += std::min(1.0, kLongestPullM / std::max(way.norm(), 1e-12)) * way;
  }
  return points;
}

}  // namespace

SmoothOptions smoothing_for(const PlanOptions& options) {
  SmoothOptions smooth;
  smooth.radius_m = kSmoothReserve * options.vehicle.turn_radius_m;
  const double width = lane_m(options);
  smooth.step_m = width / 16.0;
  smooth.deviation_m = kSmoothReach * width;
  smooth.curvature_weight = 3.0;
  smooth.deviation_weight = 0.2;
  return smooth;
}

std::vector<SkeletonPoint> smoothed(const SkeletonCycle& cycle,
                                    const std::vector<std::pair<Vec2, Vec2>>& blocked,
                                    const Area& water, const SmoothOptions& options,
                                    SmoothResult& verdict, const FannedCover* cover) {
  std::vector<Vec2> line;
  std::vector<double> along;
  for (const SkeletonPoint& p : cycle) {
    along.push_back(line.empty() ? 0.0 : along.back() + (p.position - line.back()).norm());
    line.push_back(p.position);
  }
  SmoothOptions bounded = options;
  const Clearance clearance(blocked, water, options.deviation_m + options.step_m);
  bounded.room = [&](const Vec2& a, const Vec2& b) { return clearance(a, b); };
  const auto source = [&](double at) {
    const auto next = std::upper_bound(along.begin() + 1, along.end(), at);
    return static_cast<std::size_t>(next - along.begin()) - 1;
  };
  if (cover != nullptr) {
    bounded.pull = [&](const std::vector<Vec2>& points, const std::vector<double>& at) {
      std::vector<FanAngles> fans;
      fans.reserve(at.size());
      for (const double a : at) fans.push_back(cover->fan_of(cycle[source(a)].face));
      return pulled(points, cover->cover.pull(points, fans));
    };
  }
  SmoothResult found = smooth_path(line, bounded);
  const ArcPath path = with_arcs(found.points);
  std::vector<SkeletonPoint> result;
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    SkeletonPoint point = cycle[source(found.along[path.source[i]])];
    point.position = path.points[i];
    result.push_back(point);
  }
  verdict.windows += found.windows;
  verdict.failed_windows += found.failed_windows;
  verdict.failed_m += found.failed_m;
  for (const auto& [status, count] : found.status) verdict.status[status] += count;
  return result;
}

}  // namespace swathplan
