#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "planners/plan.h"

namespace swathplan {

/// The survey area as square cells, with the depth below each centre. A frame of at least one cell
/// that is not in the area runs round it, so that neighbours need no bounds check.
class WaterRaster {
 public:
  /// `most_cells` bounds the memory; the cell is no finer than `finest_m`.
  explicit WaterRaster(const Ground& ground, double most_cells = 4e5, double finest_m = 0.25);

  [[nodiscard]] std::size_t columns() const { return columns_; }
  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] std::size_t size() const { return depth_.size(); }
  [[nodiscard]] double cell_m() const { return cell_; }
  /// The cell that holds p; empty beyond the raster.
  [[nodiscard]] std::optional<std::size_t> cell_at(const Vec2& p) const;
  [[nodiscard]] Vec2 centre(std::size_t i) const;
  [[nodiscard]] bool in_area(std::size_t i) const { return depth_[i] > 0.0F; }
  /// Depth below the water line, metres; 0 outside the area.
  [[nodiscard]] double depth(std::size_t i) const { return depth_[i]; }
  /// Depth at p, of the nearest cell of the area within three cells; empty farther off.
  [[nodiscard]] std::optional<double> depth_near(const Vec2& p) const;
  /// The same raster with only the cells in the area that `keep` names. `keep` has one flag a cell.
  [[nodiscard]] WaterRaster only(const std::vector<char>& keep) const;

 private:
  double cell_ = 1.0;
  Vec2 origin_ = Vec2::Zero();
  std::size_t columns_ = 0, rows_ = 0;
  std::vector<float> depth_;
};

/// The width of the swath over flat ground of `depth_m`, capped by the sonar's opening and range,
/// metres. Where hits count, neighbouring beams lie no farther apart than `gap_m`. Where footprints
/// count, `gap_m` has no effect, since footprints meet.
[[nodiscard]] double gap_free_width_m(const PlanOptions& options, double depth_m, double gap_m);

/// W of every cell of the area, metres; 0 outside. `gap` as a multiple of the scoring cell, > 0.
[[nodiscard]] std::vector<float> width_field(const WaterRaster& raster, const PlanOptions& options,
                                             double gap);

}  // namespace swathplan
