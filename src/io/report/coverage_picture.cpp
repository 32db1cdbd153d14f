#include "io/report/pictures_internal.h"

namespace swathplan::internal {
namespace {
constexpr std::uint32_t kLargestSide = 1600, kSmallestSide = 300;
}  // namespace

CoveragePicture coverage_picture(const CoverageGrid& grid, bool logged_counts, std::size_t budget) {
  for (std::uint32_t side = kLargestSide;; side = side * 13 / 15) {
    CoverageSummary summary = summarise(grid, side, logged_counts);
    CoveragePicture out{.png = png_bytes({.columns = summary.columns,
                                          .rows = summary.rows,
                                          .pixels = std::move(summary.pixels),
                                          .palette = coverage_palette()}),
                        .columns = summary.columns,
                        .rows = summary.rows,
                        .factor = summary.factor,
                        .box = {}};
    if (out.png.size() > budget && side > kSmallestSide) continue;
    const double pixel = grid.resolution_m() * summary.factor;
    out.box.extend(grid.origin());
    out.box.extend(grid.origin() + pixel * Vec2(summary.columns, summary.rows));
    return out;
  }
}

}  // namespace swathplan::internal
