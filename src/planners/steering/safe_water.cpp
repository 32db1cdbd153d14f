#include "planners/steering/safe_water.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace swathplan {
namespace {

/// Cells are no smaller than this, metres.
constexpr double kSmallestCell = 0.1;
/// Distances are kept less this, metres: it is far above the rounding of floats and the width of
/// outlines.
constexpr double kSure = 0.01;

}  // namespace

SafeWater::SafeWater(const Area& area) : outline_(area) {
  if (area.empty()) return;
  const Box2 box = extent(area);
  const Vec2 size = box.size();
  origin_ = box.min;
  cell_ = std::max({kSmallestCell, std::sqrt(size.x() * size.y() / kMostCells),
                    std::max(size.x(), size.y()) / kMostCells});
  columns_ = static_cast<std::size_t>(std::ceil(size.x() / cell_));
  rows_ = static_cast<std::size_t>(std::ceil(size.y() / cell_));
  clear_.assign(columns_ * rows_, 0.0F);
  const double half = 0.5 * std::numbers::sqrt2 * cell_ + kSure;
  for (std::size_t i = 0; i < clear_.size(); ++i) {
    const Vec2 middle = centre(i);
    const double metres = outline_.distance(middle) - half;
    if (metres <= 0.0) continue;
    clear_[i] = static_cast<float>(outline_.contains(middle) ? metres : -metres);
  }
}

Vec2 SafeWater::centre(std::size_t cell) const {
  const std::size_t row = cell / columns_;
  const std::size_t column = cell % columns_;
  return origin_ + cell_ * Vec2(static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5);
}

std::size_t SafeWater::cell_of(const Vec2& p) const {
  const Vec2 at = (p - origin_) / cell_;
  if (!(at.x() >= 0.0 && at.y() >= 0.0 && at.x() < static_cast<double>(columns_) &&
        at.y() < static_cast<double>(rows_))) {
    return clear_.size();
  }
  return static_cast<std::size_t>(at.y()) * columns_ + static_cast<std::size_t>(at.x());
}

double SafeWater::clear_around(const Vec2& p) const {
  const std::size_t i = cell_of(p);
  return i < clear_.size() ? std::max(0.0, static_cast<double>(clear_[i])) : 0.0;
}

bool SafeWater::contains(const Vec2& p) const {
  const std::size_t i = cell_of(p);
  if (i == clear_.size() || clear_[i] == 0.0F) return outline_.contains(p);
  return clear_[i] > 0.0F;
}

bool SafeWater::segment_holds(const Vec2& a, const Vec2& b) const {
  const double length = (b - a).norm();
  return outline_.inside_length(a, b) >= length - kDust * std::max(1.0, length);
}

bool SafeWater::holds(const std::vector<Vec2>& path) const {
  // A coarse test first: most paths that leave the water leave it by far.
  constexpr std::size_t kStride = 16;
  for (std::size_t i = 0; i < path.size(); i += kStride) {
    if (!contains(path[i])) return false;
  }
  for (std::size_t i = 1; i < path.size();) {
    // What stays within the clear circle around a point needs no other test.
    const Vec2& middle = path[i - 1];
    const double clear = clear_around(middle);
    const std::size_t first = i;
    while (i < path.size() && (path[i] - middle).squaredNorm() < clear * clear) ++i;
    if (i > first) continue;
    if (!segment_holds(middle, path[i])) return false;
    ++i;
  }
  return true;
}

}  // namespace swathplan
