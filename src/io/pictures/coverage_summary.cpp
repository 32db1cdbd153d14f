#include "io/pictures/coverage_summary.h"

#include <algorithm>
#include <cmath>

namespace swathplan {
namespace {

/// What is known of the cells of one pixel.
struct Cells {
  std::uint32_t count = 0, empty = 0;
  std::uint64_t soundings = 0;
};

std::uint8_t index_of(const Cells& cells) {
  if (cells.count == 0) return 0;
  if (cells.empty > 0) {
    // Rounded up: one empty cell among thousands still shows.
    const std::uint64_t steps =
        (std::uint64_t{cells.empty} * kEmptySteps + cells.count - 1) / cells.count;
    return static_cast<std::uint8_t>(kEmpty + steps);
  }
  const double mean = static_cast<double>(cells.soundings) / cells.count;
  const auto level = std::upper_bound(kCoveredLimits.begin(), kCoveredLimits.end(), mean);
  return static_cast<std::uint8_t>(kCovered + (level - kCoveredLimits.begin()));
}

/// Adds the grid's row to a line of pixels.
void add_row(const CoverageGrid& grid, std::uint32_t row, std::uint32_t factor, bool logged_counts,
             std::vector<Cells>& line) {
  const std::size_t start = std::size_t{row} * grid.columns();
  for (std::uint32_t column = 0; column < grid.columns(); ++column) {
    const std::size_t i = start + column;
    if (!grid.counts(i)) continue;
    Cells& cells = line[column / factor];
    ++cells.count;
    cells.soundings += grid.soundings(i);
    if ((logged_counts ? grid.logged_soundings(i) : grid.soundings(i)) == 0) ++cells.empty;
  }
}

}  // namespace

CoverageSummary summarise(const CoverageGrid& grid, std::uint32_t largest_side,
                          bool logged_counts) {
  const std::uint32_t side = std::max(grid.columns(), grid.rows());
  CoverageSummary out;
  out.factor = std::max(1U, (side + largest_side - 1) / largest_side);
  out.columns = (grid.columns() + out.factor - 1) / out.factor;
  out.rows = (grid.rows() + out.factor - 1) / out.factor;
  out.pixels.resize(std::size_t{out.columns} * out.rows);
  std::vector<Cells> line;
  for (std::uint32_t r = 0; r < out.rows; ++r) {
    line.assign(out.columns, {});
    const std::uint32_t end = std::min(grid.rows(), (r + 1) * out.factor);
    for (std::uint32_t row = r * out.factor; row < end; ++row) {
      add_row(grid, row, out.factor, logged_counts, line);
    }
    const std::size_t start = std::size_t{out.rows - 1 - r} * out.columns;
    for (std::uint32_t c = 0; c < out.columns; ++c) out.pixels[start + c] = index_of(line[c]);
  }
  return out;
}

Rgba blend(const std::vector<Rgba>& stops, double t) {
  const double at = std::clamp(t, 0.0, 1.0) * static_cast<double>(stops.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  const double f = at - static_cast<double>(i);
  const auto mix = [f](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(std::lround(a + f * (b - a)));
  };
  return {mix(stops[i].r, stops[i + 1].r), mix(stops[i].g, stops[i + 1].g),
          mix(stops[i].b, stops[i + 1].b), 255};
}

std::vector<Rgba> coverage_palette() {
  const std::vector<Rgba> blues{{214, 230, 243, 255}, {120, 170, 214, 255}, {27, 78, 138, 255}};
  const std::vector<Rgba> reds{
      {253, 226, 198, 255}, {247, 168, 102, 255}, {232, 94, 30, 255}, {190, 30, 12, 255}};
  std::vector<Rgba> out(kEmpty + kEmptySteps + 1, Rgba{0, 0, 0, 0});
  for (std::size_t i = 0; i < kCoveredNames.size(); ++i) {
    out[kCovered + i] = blend(blues, static_cast<double>(i) / (kCoveredNames.size() - 1));
  }
  for (int i = 1; i <= kEmptySteps; ++i) {
    out[kEmpty + static_cast<std::size_t>(i)] =
        blend(reds, static_cast<double>(i - 1) / (kEmptySteps - 1));
  }
  return out;
}

}  // namespace swathplan
