#pragma once

#include <vector>

#include "mesh/plane/area_query.h"

namespace swathplan {

/// Where the boat may be, indexed once for the many paths that are held against it. A raster of
/// distances to the outline settles most questions; the outline itself answers the others, so that
/// the answers are those of AreaQuery.
class SafeWater {
 public:
  explicit SafeWater(const Area& area);

  /// As AreaQuery::contains.
  [[nodiscard]] bool contains(const Vec2& p) const;
  /// Metres around p that are water for certain; 0 where none are or nothing is known.
  [[nodiscard]] double clear_around(const Vec2& p) const;
  /// True if each segment of the path stays in the water, to kDust of its length (but at least to
  /// kDust metres).
  [[nodiscard]] bool holds(const std::vector<Vec2>& path) const;
  [[nodiscard]] const AreaQuery& outline() const { return outline_; }

  /// The raster: square cells, from the lower left corner of the water's extent.
  [[nodiscard]] Vec2 origin() const { return origin_; }
  [[nodiscard]] double cell_m() const { return cell_; }
  [[nodiscard]] std::size_t columns() const { return columns_; }
  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] std::size_t cells() const { return clear_.size(); }
  [[nodiscard]] Vec2 centre(std::size_t cell) const;

  static constexpr double kDust = 1e-6;
  static constexpr double kMostCells = 4e4;

 private:
  /// Index of the cell that p lies in, or the number of cells beyond the raster.
  [[nodiscard]] std::size_t cell_of(const Vec2& p) const;
  [[nodiscard]] bool segment_holds(const Vec2& a, const Vec2& b) const;

  AreaQuery outline_;
  Vec2 origin_ = Vec2::Zero();
  double cell_ = 1.0;
  std::size_t columns_ = 0, rows_ = 0;
  /// Metres from any place of the cell to the outline at least: above 0 in the water, below 0
  /// outside it, 0 where the outline may cross the cell.
  std::vector<float> clear_;
};

}  // namespace swathplan
