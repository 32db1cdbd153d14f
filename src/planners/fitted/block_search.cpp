#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "planners/fitted/block_search_internal.h"
#include "planners/fronts/fitted_straight.h"
#include "planners/wording.h"

namespace swathplan {

BlockSearch::BlockSearch(const StraightCandidate& base, int coarse, LineWorkshop& shop)
    : base_(base), coarse_(coarse), shop_(shop) {
  const std::vector<SurveyCurve> lines = lines_of(base, shop);
  blocks_ = row_blocks(lines, Angle::degrees(base.azimuth_deg), shop.raster());
  for (const auto& block : blocks_.lines) {
    layouts_.emplace_back(1);
    for (const std::size_t k : block) layouts_.back().front().push_back(lines[k]);
  }
  if (!has_blocks()) return;
  for (const std::size_t b : largest()) add_layouts(b);
}

std::vector<std::size_t> BlockSearch::largest() const {
  const auto& cells = blocks_.cells;
  const auto all = static_cast<double>(std::accumulate(cells.begin(), cells.end(), std::size_t{0}));
  std::vector<std::size_t> order(cells.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase_if(order,
                [&](std::size_t b) { return static_cast<double>(cells[b]) < kLeastShare * all; });
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return cells[a] > cells[b]; });
  order.resize(std::min(order.size(), kMostBlocks));
  return order;
}

/// Adds layouts with as many rows as the base's density asks for, with one more and with one less.
/// Rows across the base's pay where they save the way back out of a basin. Few of them do then.
void BlockSearch::add_layouts(std::size_t block) {
  std::vector<char> mask(blocks_.of_cell.size());
  std::transform(blocks_.of_cell.begin(), blocks_.of_cell.end(), mask.begin(),
                 [&](auto b) { return static_cast<char>(b == static_cast<std::int32_t>(block)); });
  const WaterRaster part = shop_.raster().only(mask);
  const std::vector<float>& width = width_of(base_, shop_);
  const auto swaths = [&](const WaterRaster& raster, Angle azimuth) {
    return row_widths(raster, width, azimuth, base_.percentile).total();
  };
  const double density = base_.lines / swaths(shop_.raster(), Angle::degrees(base_.azimuth_deg));
  for (const bool across : {false, true}) {
    if (across && shop_.options().heading) break;
    const Angle azimuth = Angle::degrees(std::fmod(base_.azimuth_deg + (across ? 90. : 0.), 180.));
    const int middle = std::max(1, static_cast<int>(std::lround(density * swaths(part, azimuth))));
    for (int rows = std::max(1, middle - 1); rows <= middle + (across ? 0 : 1); ++rows) {
      auto lines =
          cut_to_block(fitted_straight_lines(part, width, shop_.survey_area(), shop_.lines_in(),
                                             {.azimuth = azimuth,
                                              .percentile = base_.percentile,
                                              .lines = rows,
                                              .inset_m = base_.inset_m}),
                       blocks_, static_cast<std::int32_t>(block), shop_.raster(),
                       kShortestPiece * lane_m(shop_.options()));
      if (!lines.empty()) layouts_[block].push_back(std::move(lines));
    }
  }
}

std::vector<SurveyCurve> BlockSearch::lines_for(const Choice& choice) const {
  std::vector<SurveyCurve> lines;
  for (std::size_t b = 0; b < choice.size(); ++b) {
    const auto& layout = layouts_[b][choice[b]];
    lines.insert(lines.end(), layout.begin(), layout.end());
  }
  return lines;
}

const Outcome& BlockSearch::outcome_of(const Choice& choice) {
  const auto [it, fresh] = judged_.try_emplace(choice);
  if (fresh) {
    const std::vector<SurveyCurve> lines = lines_for(choice);
    it->second = shop_.estimate(
        lines, width_of(base_, shop_), angles_of(base_), coarse_,
        fmt::format("{}, block by block, most at {}", counted(lines.size(), "line"),
                    azimuth_text(base_.azimuth_deg, shop_.options().grid_north.deg())));
  }
  return it->second;
}

std::optional<BlockedRows> BlockSearch::best_for(double price) {
  const Choice base(layouts_.size(), 0);
  Choice best = base;
  for (const std::size_t b : largest()) {
    Choice tried = best;
    for (std::size_t k = 1; k < layouts_[b].size(); ++k) {
      tried[b] = k;
      if (worth(outcome_of(tried), price) > worth(outcome_of(best), price)) best = tried;
    }
  }
  return best == base ? std::nullopt : taken(best);
}

std::optional<BlockedRows> BlockSearch::best_between(const Outcome& shorter,
                                                     const Outcome& longer) {
  const double price = (longer.cover_pct - shorter.cover_pct) /
                       std::max(longer.length_ratio - shorter.length_ratio, 1e-9);
  const Choice* best = nullptr;
  for (const auto& [choice, outcome] : judged_) {
    if (outcome.length_ratio < shorter.length_ratio * (1.0 + kApart) ||
        outcome.length_ratio > longer.length_ratio * (1.0 - kApart)) {
      continue;
    }
    if (best == nullptr || worth(outcome, price) > worth(judged_.at(*best), price)) best = &choice;
  }
  return best == nullptr ? std::nullopt : taken(*best);
}

std::optional<BlockedRows> BlockSearch::taken(const Choice& choice) {
  if (!taken_.insert(choice).second) return std::nullopt;
  return BlockedRows{lines_for(choice), base_, outcome_of(choice)};
}

}  // namespace swathplan
