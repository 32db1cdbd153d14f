#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "coverage/tracing/coverage_grid.h"

namespace swathplan {

/// A colour of a palette.
struct Rgba {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;
  bool operator==(const Rgba&) const = default;
};

/// A coverage grid as a picture of palette indices. Row 0 is the northernmost. A pixel stands for
/// `factor` x `factor` cells, or for fewer at the east and north border of the grid.
struct CoverageSummary {
  std::uint32_t factor = 1, columns = 0, rows = 0;
  std::vector<std::uint8_t> pixels;
};

// Palette indices. 0: outside the area. kCovered + level: every cell has a sounding. kEmpty + steps
// with steps from 1 to kEmptySteps: a share of steps / kEmptySteps of the cells has no sounding.
inline constexpr std::uint8_t kCovered = 1;
inline constexpr std::uint8_t kEmpty = 9;
inline constexpr int kEmptySteps = 20;
/// Mean soundings per cell below which each covered level ends; the last one has no end.
inline constexpr std::array<double, 5> kCoveredLimits{1.5, 2.5, 4.5, 8.5, 16.5};
inline constexpr std::array<const char*, 6> kCoveredNames{"1", "2", "3-4", "5-8", "9-16", "17+"};

/// The grid, summarised so that no side is longer than `largest_side` pixels. With `logged_counts`
/// a cell that no logged ping sounded is empty; levels are of all pings.
[[nodiscard]] CoverageSummary summarise(const CoverageGrid& grid, std::uint32_t largest_side,
                                        bool logged_counts = false);

/// The colours of the indices: blue for covered cells, orange to red for empty ones. People with
/// red-green blindness can tell them apart. Index 0 is transparent.
[[nodiscard]] std::vector<Rgba> coverage_palette();

/// The colour at `t` in [0, 1] on the line through evenly spaced `stops`.
[[nodiscard]] Rgba blend(const std::vector<Rgba>& stops, double t);

}  // namespace swathplan
