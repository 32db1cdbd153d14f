#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "coverage/judging/judged_survey.h"
#include "coverage/tracing/coverage_grid.h"
#include "io/pictures/coverage_summary.h"
#include "mesh/seafloor.h"

namespace swathplan::internal {

/// A picture of palette indices, row 0 at the top.
struct IndexedPicture {
  std::uint32_t columns = 0, rows = 0;
  std::vector<std::uint8_t> pixels;
  std::vector<Rgba> palette;
};

/// The bytes of a palette PNG.
/// @throws InvalidInput if GDAL cannot make one.
[[nodiscard]] std::string png_bytes(const IndexedPicture& picture);
[[nodiscard]] std::string base64(std::string_view bytes);

/// Depths at the centres of pixels. NaN where there is no seafloor. Row 0 is the northernmost.
struct DepthField {
  std::uint32_t columns = 0, rows = 0;
  double pixel_m = 1.0;
  Vec2 corner = Vec2::Zero();  ///< upper left, local metres
  std::vector<double> depth;
  /// NaN outside.
  [[nodiscard]] double at(std::uint32_t c, std::uint32_t r) const;
};
/// Depths over `box` (local metres).
[[nodiscard]] DepthField depth_field(const DepthQuery& depths, const Box2& box,
                                     std::uint32_t largest_side);

/// A map of depth, shaded from the north-west, with isobaths.
struct DepthPicture {
  IndexedPicture picture;           ///< index 0: no seafloor
  Box2 box;                         ///< what the picture covers
  double min_m = 0.0, max_m = 0.0;  ///< of the depths met
  double isobath_m = 0.0;           ///< interval
};
// Index 1 + level * kDepthShades + shade; the last shade is that of isobaths.
inline constexpr int kDepthLevels = 40, kDepthShades = 6;
[[nodiscard]] DepthPicture depth_picture(const DepthField& field);

/// A map of the seafloor's slope from pixel to pixel.
struct SlopePicture {
  IndexedPicture picture;  ///< index 0: no seafloor; 1 + level otherwise
  Box2 box;
};
/// The last level has no end.
inline constexpr int kSlopeLevels = 30;
inline constexpr double kSlopeStepDeg = 1.5;
[[nodiscard]] SlopePicture slope_picture(const DepthField& field);

/// The grid as a PNG (see summarise() for `logged_counts`). The picture gets coarser step by step
/// until it has at most `budget` bytes, or until its longer side is as short as it may be.
struct CoveragePicture {
  std::string png;
  std::uint32_t columns = 0, rows = 0, factor = 1;
  Box2 box;
};
[[nodiscard]] CoveragePicture coverage_picture(const CoverageGrid& grid, bool logged_counts,
                                               std::size_t budget);

/// A map of each cell's TVU as a share of its limit; a pixel shows its worst cell.
struct TvuPicture {
  IndexedPicture picture;  ///< index 0: no sounding of a logged line; 1 + level otherwise
  Box2 box;
};
/// Even steps up to the limit, and one level beyond it.
inline constexpr int kTvuLevels = 11;
[[nodiscard]] TvuPicture tvu_picture(const UncertaintyRaster& raster, std::uint32_t largest_side);

}  // namespace swathplan::internal
