#include "planners/steering/line_poses.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "coverage/route/bends.h"

namespace swathplan {

LinePoses::LinePoses(const std::vector<Vec2>& line) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    const double step = points_.empty() ? 0.0 : (line[i] - points_.back()).norm();
    if (!points_.empty() && step < kCoincidentM) continue;
    along_.push_back(points_.empty() ? 0.0 : along_.back() + step);
    points_.push_back(line[i]);
    source_.push_back(i);
  }
  if (points_.empty()) along_.push_back(0.0);
}

Vec2 LinePoses::course_at(std::size_t i) const {
  Vec2 sum = Vec2::Zero();
  if (i > 0) sum += (points_[i] - points_[i - 1]).normalized();
  if (i + 1 < points_.size()) sum += (points_[i + 1] - points_[i]).normalized();
  if (sum.norm() < kCoincidentM) sum = points_[i] - points_[i - 1];  // turns straight back
  return sum.normalized();
}

LinePoses::Place LinePoses::at(double along_m) const {
  if (is_point()) return {0.0, {points_.front(), Vec2::UnitY()}, 0U, 0};
  const auto after = std::upper_bound(along_.begin() + 1, along_.end() - 1, along_m);
  const auto j = static_cast<std::size_t>(after - along_.begin());
  const double length = along_[j] - along_[j - 1];
  const double share = std::clamp((along_m - along_[j - 1]) / length, 0.0, 1.0);
  const double margin = 0.5 * kChordM / length;
  if (length < kChordM || share < margin || share > 1.0 - margin) {
    const std::size_t i = share < 0.5 ? j - 1 : j;
    return {along_[i], {points_[i], course_at(i)}, i, source_[i]};
  }
  const Vec2 way = points_[j] - points_[j - 1];
  return {along_m, {points_[j - 1] + share * way, way / length}, std::nullopt, source_[j - 1]};
}

double LinePoses::radius_at(std::size_t i, double turn_radius_m) const {
  if (i == 0 || i + 1 >= points_.size()) return std::numeric_limits<double>::infinity();
  return bend_radius_m(course_change(points_[i - 1], points_[i], points_[i + 1]), turn_radius_m);
}

}  // namespace swathplan
