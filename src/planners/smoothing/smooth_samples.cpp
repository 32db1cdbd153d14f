#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <unordered_map>

#include "planners/smoothing/smooth_samples_internal.h"

namespace swathplan {
namespace {

/// A point keeps this share of its room.
constexpr double kRoomShare = 0.9;

/// Points in square cells, to be found by their neighbourhood.
class PointGrid {
 public:
  PointGrid(const std::vector<Vec2>& points, double cell) : cell_(cell) {
    for (std::size_t i = 0; i < points.size(); ++i) cells_[key(points[i], 0, 0)].push_back(i);
  }

  /// Every point in the cells up to `reach` away from that of `p`.
  template <typename Visit>
  void around(const Vec2& p, int reach, const Visit& visit) const {
    for (int dx = -reach; dx <= reach; ++dx) {
      for (int dy = -reach; dy <= reach; ++dy) {
        const auto there = cells_.find(key(p, dx, dy));
        if (there == cells_.end()) continue;
        for (const std::size_t j : there->second) visit(j);
      }
    }
  }

 private:
  [[nodiscard]] std::int64_t key(const Vec2& p, int dx, int dy) const {
    const auto x = static_cast<std::int64_t>(std::floor(p.x() / cell_)) + dx;
    const auto y = static_cast<std::int64_t>(std::floor(p.y() / cell_)) + dy;
    return (x << 32) ^ (y & 0xFFFFFFFF);
  }

  double cell_;
  std::unordered_map<std::int64_t, std::vector<std::size_t>> cells_;
};

/// The deviation bound, or a share of the distance to the nearest other pass if that is less. Two
/// passes that move no farther do not meet.
std::vector<double> shares_between_passes(const Samples& s, const SmoothOptions& o) {
  constexpr double kPassShare = 0.47;
  constexpr double kOtherPass = 2.5;  // as far along the path, in distances, as no turn is
  std::vector<double> room(s.points.size(), o.deviation_m);
  const double reach = o.deviation_m / kPassShare;
  const PointGrid grid(s.points, std::max(reach, s.step));
  for (std::size_t i = 0; i < s.points.size(); ++i) {
    grid.around(s.points[i], 1, [&](std::size_t j) {
      const double distance = (s.points[j] - s.points[i]).norm();
      if (std::abs(s.along[j] - s.along[i]) < std::max(kOtherPass * distance, 2.0 * s.step)) return;
      room[i] = std::min(room[i], kPassShare * distance);
    });
  }
  return room;
}

}  // namespace

Samples sampled(const LinePoses& line, double step) {
  Samples s;
  const auto parts = static_cast<std::size_t>(std::max(1.0, std::round(line.length_m() / step)));
  s.step = line.length_m() / static_cast<double>(parts);
  std::size_t j = 1;
  for (std::size_t k = 0; k <= parts; ++k) {
    const double at = line.length_m() * static_cast<double>(k) / static_cast<double>(parts);
    while (j + 1 < line.points().size() && line.along()[j] < at) ++j;
    const double length = line.along()[j] - line.along()[j - 1];
    const double share = std::clamp((at - line.along()[j - 1]) / length, 0.0, 1.0);
    s.points.push_back(line.points()[j - 1] + share * (line.points()[j] - line.points()[j - 1]));
    s.along.push_back(at);
  }
  return s;
}

std::vector<double> rooms(const Samples& s, const SmoothOptions& o) {
  std::vector<double> room = shares_between_passes(s, o);
  for (std::size_t i = 0; o.room && i + 1 < s.points.size(); ++i) {
    const double free = std::max(0.0, kRoomShare * o.room(s.points[i], s.points[i + 1]));
    room[i] = std::min(room[i], free);
    room[i + 1] = std::min(room[i + 1], free);
  }
  for (double& r : room) r /= std::numbers::sqrt2;
  return room;
}

}  // namespace swathplan
