#include <algorithm>

#include "planners/steering/taut_way_internal.h"

namespace swathplan {
namespace {

/// A straight of a way has stages if it is at least this long, radii.
constexpr double kStage = 4.0;
/// Stages lie at most this far from the ends of their straight, radii.
constexpr double kNearCorner = 5.0;

}  // namespace

void add_stages(const std::vector<Vec2>& way, double radius, std::vector<Pose>& stages) {
  for (std::size_t i = 1; i < way.size(); ++i) {
    const Vec2 straight = way[i] - way[i - 1];
    const double length = straight.norm();
    if (length < kStage * radius) continue;
    const Vec2 course = straight / length;
    const double off = std::min(kNearCorner * radius, 0.5 * length);
    stages.push_back({way[i - 1] + off * course, course});
    if (off < 0.5 * length) stages.push_back({way[i] - off * course, course});
  }
}

}  // namespace swathplan
