#include "planners/fronts/water_raster.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/plane/area_query.h"

namespace swathplan {
namespace {

/// Width of the frame around the area, cells.
constexpr double kFrame = 2.0;
/// A cell of the area is never shoaler than this, metres: zero means 'not in the area'.
constexpr double kLeastDepth = 1e-3;

}  // namespace

WaterRaster::WaterRaster(const Ground& ground, double most_cells, double finest_m) {
  const Box2 box = extent(ground.survey_area);
  const Vec2 size = box.size();
  cell_ = std::max(finest_m, std::sqrt(size.x() * size.y() / most_cells));
  origin_ = box.min - Vec2::Constant(kFrame * cell_);
  columns_ = static_cast<std::size_t>(std::ceil(size.x() / cell_) + 2.0 * kFrame);
  rows_ = static_cast<std::size_t>(std::ceil(size.y() / cell_) + 2.0 * kFrame);
  depth_.assign(columns_ * rows_, 0.0F);
  const AreaQuery area(ground.survey_area);
  const double width = cell_ * static_cast<double>(columns_);
  for (std::size_t r = 0; r < rows_; ++r) {
    const Vec2 from = origin_ + Vec2(0.0, (static_cast<double>(r) + 0.5) * cell_);
    for (const auto& [t0, t1] : area.clip(from, from + Vec2(width, 0.0))) {
      const double first = std::ceil(t0 * width / cell_ - 0.5);
      const double last = std::floor(t1 * width / cell_ - 0.5);
      for (double c = std::max(1.0, first); c <= last; c += 1.0) {
        const Vec2 p = from + Vec2((c + 0.5) * cell_, 0.0);
        const auto depth = ground.depths->depth(p);
        depth_[r * columns_ + static_cast<std::size_t>(c)] = static_cast<float>(
            std::max(kLeastDepth, depth ? *depth : ground.depths->nearest_depth(p)));
      }
    }
  }
}

std::optional<std::size_t> WaterRaster::cell_at(const Vec2& p) const {
  const Vec2 at = (p - origin_) / cell_;
  if (!(at.x() >= 0.0 && at.y() >= 0.0 && at.x() < static_cast<double>(columns_) &&
        at.y() < static_cast<double>(rows_))) {
    return std::nullopt;
  }
  return static_cast<std::size_t>(at.y()) * columns_ + static_cast<std::size_t>(at.x());
}

Vec2 WaterRaster::centre(std::size_t i) const {
  const std::size_t row = i / columns_;
  const std::size_t column = i % columns_;
  return origin_ + cell_ * Vec2(static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5);
}

WaterRaster WaterRaster::only(const std::vector<char>& keep) const {
  WaterRaster part = *this;
  for (std::size_t i = 0; i < keep.size(); ++i) {
    if (keep[i] == 0) part.depth_[i] = 0.0F;
  }
  return part;
}

std::optional<double> WaterRaster::depth_near(const Vec2& p) const {
  const Vec2 at = (p - origin_) / cell_;
  const auto c0 = static_cast<std::int64_t>(std::floor(at.x()));
  const auto r0 = static_cast<std::int64_t>(std::floor(at.y()));
  constexpr std::int64_t kReach = 3;
  std::optional<double> found;
  double best = std::numeric_limits<double>::infinity();
  for (std::int64_t r = r0 - kReach; r <= r0 + kReach; ++r) {
    for (std::int64_t c = c0 - kReach; c <= c0 + kReach; ++c) {
      if (c < 0 || r < 0 || c >= static_cast<std::int64_t>(columns_) ||
          r >= static_cast<std::int64_t>(rows_)) {
        continue;
      }
      const auto i = static_cast<std::size_t>(r) * columns_ + static_cast<std::size_t>(c);
      if (!in_area(i)) continue;
      const double distance = (centre(i) - p).squaredNorm();
      if (distance < best) {
        best = distance;
        found = depth(i);
      }
    }
  }
  return found;
}

double gap_free_width_m(const PlanOptions& options, double depth_m, double gap_m) {
  const double below = std::max(depth_m - options.vehicle.draft_m, 1e-3);
  const double half = options.cover == Cover::footprint
                          ? 0.5 * options.sonar.max_opening.rad()
                          : gap_free_half_angle(options.sonar, below, gap_m).rad();
  const double range = options.sonar.max_range_m;
  const double reach = range > below ? std::sqrt(range * range - below * below) : 1e-3;
  return 2.0 * std::min(below * std::tan(half), reach);
}

std::vector<float> width_field(const WaterRaster& raster, const PlanOptions& options, double gap) {
  // W depends on the depth alone, so a table saves one bisection per cell.
  double deepest = 0.0;
  for (std::size_t i = 0; i < raster.size(); ++i) deepest = std::max(deepest, raster.depth(i));
  constexpr std::size_t kEntries = 2048;
  std::vector<double> table(kEntries + 2);
  const double step = std::max(deepest, 1e-3) / static_cast<double>(kEntries);
  for (std::size_t k = 0; k < table.size(); ++k) {
    table[k] = gap_free_width_m(options, static_cast<double>(k) * step, gap * options.resolution_m);
  }
  std::vector<float> widths(raster.size(), 0.0F);
  for (std::size_t i = 0; i < raster.size(); ++i) {
    if (!raster.in_area(i)) continue;
    const double at = raster.depth(i) / step;
    const auto k = static_cast<std::size_t>(at);
    const double share = at - static_cast<double>(k);
    widths[i] = static_cast<float>((1.0 - share) * table[k] + share * table[k + 1]);
  }
  return widths;
}

}  // namespace swathplan
