#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "planners/fronts/water_raster.h"

namespace swathplan {

/// A cell from which a front starts.
struct FrontCell {
  std::size_t cell = 0;
  double value = 0.0;       ///< u there, >= 0
  std::uint32_t label = 0;  ///< passed on to the cells that the front reaches from here
};

struct Front {
  std::vector<float> u;              ///< infinite where no front comes
  std::vector<std::uint32_t> label;  ///< kNoLabel there
};
inline constexpr std::uint32_t kNoLabel = 0xFFFFFFFFU;

/// Solves |grad u| = 1/width over the cells of the area, by first-order fast marching on the four
/// neighbours. So u counts swath widths from the start of the front. Cells outside the area, and
/// cells with width 0, stop the front. Of equal values the lower cell comes first, so the result is
/// always the same.
/// The front stops where u exceeds `farthest`. Cost: O(n log n). Method: [sethian-fmm].
[[nodiscard]] Front march(const WaterRaster& raster, const std::vector<float>& width,
                          const std::vector<FrontCell>& from,
                          double farthest = std::numeric_limits<double>::infinity());

}  // namespace swathplan
