#include <algorithm>
#include <cmath>

#include "io/report/pictures_internal.h"

namespace swathplan::internal {
namespace {

const std::vector<Rgba> kWithinLimit{{222, 235, 247}, {66, 146, 198}, {8, 48, 107}};
constexpr Rgba kBeyondLimit{215, 48, 31};

std::vector<Rgba> tvu_palette() {
  std::vector<Rgba> palette{{0, 0, 0, 0}};
  for (int level = 0; level + 1 < kTvuLevels; ++level) {
    palette.push_back(blend(kWithinLimit, level / (kTvuLevels - 2.0)));
  }
  palette.push_back(kBeyondLimit);
  return palette;
}

// The worst cell of a pixel; 0 where no sounding fell.
std::uint8_t index_of(const UncertaintyRaster& raster, std::uint32_t factor, std::uint32_t column,
                      std::uint32_t row) {
  float worst = -1.0F;
  for (std::uint32_t r = row * factor; r < std::min((row + 1) * factor, raster.rows); ++r) {
    for (std::uint32_t c = column * factor; c < std::min((column + 1) * factor, raster.columns);
         ++c) {
      const float share = raster.tvu_share[std::size_t{r} * raster.columns + c];
      if (!std::isinf(share)) worst = std::max(worst, share);
    }
  }
  if (worst < 0.0F) return 0;
  if (worst > 1.0F) return kTvuLevels;
  const int level = static_cast<int>(worst * static_cast<float>(kTvuLevels - 1));
  return static_cast<std::uint8_t>(1 + std::min(level, kTvuLevels - 2));
}

}  // namespace

TvuPicture tvu_picture(const UncertaintyRaster& raster, std::uint32_t largest_side) {
  const std::uint32_t longest = std::max(raster.columns, raster.rows);
  const std::uint32_t factor = std::max(1U, (longest + largest_side - 1) / largest_side);
  TvuPicture out;
  IndexedPicture& picture = out.picture;
  picture.columns = (raster.columns + factor - 1) / factor;
  picture.rows = (raster.rows + factor - 1) / factor;
  picture.palette = tvu_palette();
  for (std::uint32_t row = picture.rows; row-- > 0;) {
    for (std::uint32_t column = 0; column < picture.columns; ++column) {
      picture.pixels.push_back(index_of(raster, factor, column, row));
    }
  }
  out.box.extend(raster.origin);
  out.box.extend(raster.origin + raster.cell_m * factor * Vec2(picture.columns, picture.rows));
  return out;
}

}  // namespace swathplan::internal
