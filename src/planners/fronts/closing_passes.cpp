#include "planners/fronts/closing_passes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/base/parallel.h"

namespace swathplan {
namespace {

constexpr int kHeadings = 12;
constexpr int kRounds = 6;
/// Number of gaps that get a pass in one round; the largest gaps come first.
constexpr std::size_t kGaps = 60;
/// Turning into a pass and out of it costs about this share of W.
constexpr double kTurnShare = 0.25;
/// A pass is no shorter than this share of W.
constexpr double kShortestPass = 0.1;
/// Lengths that are tried, as shares of the gap's extent.
constexpr double kLengths[] = {1.0, 0.75, 0.5, 0.25};
/// A pass chosen earlier in the round may have swept a part of the gap. A pass that now brings less
/// than this share of its first gain is left to the next round.
constexpr double kStillWorth = 0.7;

using Cells = std::vector<std::uint32_t>;

std::vector<char> swept_cells(const std::vector<SweptLine>& lines, const WaterRaster& raster) {
  std::vector<char> is(raster.size(), 0);
  for (const SweptLine& line : lines) {
    for (const std::uint32_t cell : line.cells) is[cell] = 1;
  }
  return is;
}

/// Connected cells of the area that nothing sweeps, the largest first.
std::vector<Cells> gaps_of(const std::vector<char>& is_swept, const WaterRaster& raster) {
  std::vector<char> seen = is_swept;
  std::vector<Cells> gaps;
  for (std::size_t i = 0; i < raster.size(); ++i) {
    if (!raster.in_area(i) || seen[i] != 0) continue;
    Cells gap{static_cast<std::uint32_t>(i)};
    seen[i] = 1;
    for (std::size_t k = 0; k < gap.size(); ++k) {
      const std::size_t at = gap[k];
      const std::size_t columns = raster.columns();
      for (const std::size_t n : {at - columns, at - 1, at + 1, at + columns}) {
        if (!raster.in_area(n) || seen[n] != 0) continue;
        seen[n] = 1;
        gap.push_back(static_cast<std::uint32_t>(n));
      }
    }
    gaps.push_back(std::move(gap));
  }
  std::stable_sort(gaps.begin(), gaps.end(),
                   [](const Cells& a, const Cells& b) { return a.size() > b.size(); });
  if (gaps.size() > kGaps) gaps.resize(kGaps);
  return gaps;
}

struct Pass {
  SweptLine line;
  std::size_t gain = 0;  // cells
  double rate = 0.0;     // cells per metre, turns included
};

std::size_t fresh_cells(const SweptLine& line, const std::vector<char>& is_swept) {
  Cells cells = line.cells;
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return static_cast<std::size_t>(
      std::count_if(cells.begin(), cells.end(), [&](std::uint32_t c) { return is_swept[c] == 0; }));
}

/// The gap's extent in a direction, half a cell added on either side.
std::pair<double, double> extent_along(const Cells& gap, const WaterRaster& raster, const Vec2& u) {
  double low = 1e300;
  double high = -1e300;
  for (const std::uint32_t cell : gap) {
    const double at = raster.centre(cell).dot(u);
    low = std::min(low, at);
    high = std::max(high, at);
  }
  return {low - 0.5 * raster.cell_m(), high + 0.5 * raster.cell_m()};
}

Pass best_pass(const Cells& gap, const SweptGround& ground, const AreaQuery& lines_in,
               const std::vector<char>& is_swept) {
  Pass best;
  for (int h = 0; h < kHeadings; ++h) {
    const double a = std::numbers::pi * h / kHeadings;
    const Vec2 u(std::sin(a), std::cos(a));
    const Vec2 v(u.y(), -u.x());
    const auto [low, high] = extent_along(gap, ground.raster(), u);
    const auto [left, right] = extent_along(gap, ground.raster(), v);
    const Vec2 middle = 0.5 * (low + high) * u + 0.5 * (left + right) * v;
    const double w = ground.width_m(middle);
    for (const double share : kLengths) {
      const double half = 0.5 * std::max(share * (high - low), kShortestPass * w);
      const Vec2 from = middle - half * u;
      const Vec2 to = middle + half * u;
      if (lines_in.inside_length(from, to) < 2.0 * half - 1e-6) continue;
      SweptLine line = swept(straight_curve(from, to), ground);
      const std::size_t gain = fresh_cells(line, is_swept);
      const double rate = static_cast<double>(gain) / (2.0 * half + kTurnShare * w);
      const double cell_m2 = ground.raster().cell_m() * ground.raster().cell_m();
      if (rate <= best.rate ||
          static_cast<double>(gain) * cell_m2 < kLeastPassGain * w * 2.0 * half)
        continue;
      best = {std::move(line), gain, rate};
    }
  }
  return best;
}

}  // namespace

std::size_t add_closing_passes(std::vector<SweptLine>& lines, const SweptGround& ground,
                               const AreaQuery& lines_in, double most_missed) {
  const WaterRaster& raster = ground.raster();
  std::vector<char> is_swept = swept_cells(lines, raster);
  std::size_t area = 0;
  std::size_t missed = 0;
  for (std::size_t i = 0; i < raster.size(); ++i) {
    if (!raster.in_area(i)) continue;
    ++area;
    if (is_swept[i] == 0) ++missed;
  }
  const double allowed = most_missed * static_cast<double>(area);
  std::size_t added = 0;
  for (int round = 0; round<kRounds&& static_cast<double>(missed)> allowed; ++round) {
    const std::vector<Cells> gaps = gaps_of(is_swept, raster);
    std::vector<Pass> passes(gaps.size());
    for_each_index(std::size_t{0}, gaps.size(), [&](std::size_t k) {
      passes[k] = best_pass(gaps[k], ground, lines_in, is_swept);
    });
    std::stable_sort(passes.begin(), passes.end(),
                     [](const Pass& a, const Pass& b) { return a.rate > b.rate; });
    const std::size_t before = added;
    for (Pass& pass : passes) {
      if (pass.gain == 0 || static_cast<double>(missed) <= allowed) break;
      const std::size_t gain = fresh_cells(pass.line, is_swept);
      if (static_cast<double>(gain) < kStillWorth * static_cast<double>(pass.gain)) continue;
      for (const std::uint32_t cell : pass.line.cells) is_swept[cell] = 1;
      missed -= gain;
      lines.push_back(std::move(pass.line));
      ++added;
    }
    if (added == before) break;
  }
  return added;
}

}  // namespace swathplan
