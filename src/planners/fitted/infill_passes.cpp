#include <algorithm>
#include <cmath>
#include <numbers>

#include "planners/fitted/infill.h"
#include "planners/fitted/infill_passes_internal.h"

namespace swathplan {
namespace {

/// Empty cells are summed up in bins. A bin is at least so wide, metres.
constexpr double kFinestBin = 0.5;
/// What a cut at the outline may be off by rounding, metres.
constexpr double kDust = 1e-6;
/// The share of its swath that a pass may count on. The rim is thinly sounded.
constexpr double kSureShare = 0.9;

/// The square metres of empty cells in each cell of the raster that has some.
std::vector<std::pair<Vec2, double>> gather(const CoverageGrid& grid, const LineWorkshop& shop,
                                            double smallest_m2) {
  const WaterRaster& raster = shop.raster();
  std::vector<float> empty(raster.size(), 0.0F);
  const double cell = grid.resolution_m() * grid.resolution_m();
  for (std::uint32_t r = 0; r < grid.rows(); ++r) {
    for (std::uint32_t c = 0; c < grid.columns(); ++c) {
      const std::size_t i = static_cast<std::size_t>(r) * grid.columns() + c;
      if (!grid.counts(i) || shop.covered(grid, i)) continue;
      const auto at = raster.cell_at(grid.centre(c, r));
      if (at) empty[*at] += static_cast<float>(cell);
    }
  }
  std::vector<std::pair<Vec2, double>> list;
  for (std::size_t i = 0; i < empty.size(); ++i) {
    if (static_cast<double>(empty[i]) > smallest_m2) {
      list.emplace_back(raster.centre(i), static_cast<double>(empty[i]));
    }
  }
  return list;
}

}  // namespace

EmptyGround::EmptyGround(const CoverageGrid& grid, LineWorkshop& shop, double least_gain_m,
                         double smallest_m2)
    : shop_(shop),
      width_(shop.width(1.0)),
      sure_(kSureShare * counted_share(shop.options())),
      least_gain_(least_gain_m),
      bin_(std::max(kFinestBin, 1.5 * shop.raster().cell_m())),
      empties_(gather(grid, shop, smallest_m2)) {
  Box2 box;
  for (const auto& [p, m2] : empties_) box.extend(p);
  if (empties_.empty()) return;
  const Vec2 corners[] = {box.min, {box.max.x(), box.min.y()}, box.max, {box.min.x(), box.max.y()}};
  double widest = 0.0;
  for (const float w : width_) widest = std::max(widest, static_cast<double>(w));
  for (int k = 0; k < kInfillHeadings; ++k) {
    const double azimuth = std::numbers::pi * k / kInfillHeadings;
    Heading h;
    h.along = {std::sin(azimuth), std::cos(azimuth)};
    h.across = {h.along.y(), -h.along.x()};
    Box2 turned;
    for (const Vec2& c : corners) turned.extend({c.dot(h.along), c.dot(h.across)});
    // A pass may run half a swath beside the gap.
    turned.min.y() -= 0.5 * widest;
    turned.max.y() += 0.5 * widest;
    h.origin = turned.min;
    h.columns = static_cast<std::size_t>(turned.size().x() / bin_) + 1;
    h.rows = static_cast<std::size_t>(turned.size().y() / bin_) + 1;
    h.empty.assign(h.columns * h.rows, 0.0F);
    for (const auto& [p, m2] : empties_) {
      const auto c = static_cast<std::size_t>((p.dot(h.along) - h.origin.x()) / bin_);
      const auto r = static_cast<std::size_t>((p.dot(h.across) - h.origin.y()) / bin_);
      h.empty[std::min(r, h.rows - 1) * h.columns + std::min(c, h.columns - 1)] +=
          static_cast<float>(m2);
    }
    headings_.push_back(std::move(h));
    for (std::size_t r = 0; r < headings_.back().rows; ++r) {
      const InfillPass pass = best_on(headings_.back(), r);
      const double worth = pass.gain_m2 - least_gain_ * (pass.to - pass.from).norm();
      if (worth > 0.0) rows_.push_back({worth, headings_.size() - 1, r});
    }
  }
}

double EmptyGround::swath_gain(const Heading& h, std::size_t column, std::size_t row,
                               double width) const {
  const auto half = static_cast<std::ptrdiff_t>(0.5 * sure_ * width / bin_);
  const auto r = static_cast<std::ptrdiff_t>(row);
  const std::ptrdiff_t last = std::min(static_cast<std::ptrdiff_t>(h.rows) - 1, r + half);
  double gain = 0.0;
  for (std::ptrdiff_t k = std::max<std::ptrdiff_t>(0, r - half); k <= last; ++k) {
    gain += static_cast<double>(h.empty[static_cast<std::size_t>(k) * h.columns + column]);
  }
  return gain;
}

/// The run along a row with the most gain, less the price of its length (Kadane's algorithm).
InfillPass EmptyGround::best_on(const Heading& h, std::size_t row) const {
  InfillPass best;
  double best_worth = 0.0;
  double worth = 0.0;
  double gain = 0.0;
  std::size_t first = 0;
  const double across = h.origin.y() + (static_cast<double>(row) + 0.5) * bin_;
  const auto at = [&](double column) -> Vec2 {
    return (h.origin.x() + column * bin_) * h.along + across * h.across;
  };
  for (std::size_t c = 0; c < h.columns; ++c) {
    const Vec2 p = at(static_cast<double>(c) + 0.5);
    const auto i = shop_.raster().cell_at(p);
    const double width = i ? static_cast<double>(width_[*i]) : 0.0;
    if (width <= 0.0 || !shop_.lines_in().contains(p)) {
      worth = gain = 0.0;
      first = c + 1;
      continue;
    }
    const double here = swath_gain(h, c, row, width);
    worth += here - least_gain_ * bin_;
    gain += here;
    if (worth <= 0.0) {
      worth = gain = 0.0;
      first = c + 1;
    } else if (worth > best_worth) {
      best_worth = worth;
      // The pass runs from centre to centre: these are known to lie in water.
      best = {at(static_cast<double>(first) + 0.5), at(static_cast<double>(c) + 0.5), gain};
    }
  }
  return best;
}

void EmptyGround::sweep(const InfillPass& pass) {
  const Vec2 along = (pass.to - pass.from).normalized();
  const double length = (pass.to - pass.from).norm();
  for (auto& [p, m2] : empties_) {
    if (m2 <= 0.0) continue;
    const double s = (p - pass.from).dot(along);
    if (s < 0.0 || s > length) continue;
    const auto i = shop_.raster().cell_at(pass.from + s * along);
    const double half = i ? 0.5 * sure_ * static_cast<double>(width_[*i]) : 0.0;
    if ((p - pass.from - s * along).norm() > half) continue;
    for (Heading& h : headings_) {
      const auto c = static_cast<std::size_t>((p.dot(h.along) - h.origin.x()) / bin_);
      const auto r = static_cast<std::size_t>((p.dot(h.across) - h.origin.y()) / bin_);
      float& bin = h.empty[std::min(r, h.rows - 1) * h.columns + std::min(c, h.columns - 1)];
      bin = std::max(0.0F, bin - static_cast<float>(m2));
    }
    m2 = 0.0;
  }
}

std::optional<InfillPass> EmptyGround::take_best(
    const std::function<double(const InfillPass&)>& detour) {
  // Rows are taken in the order of their bounds, and a bound only shrinks. So the first row that
  // keeps its place is the best. A row that brings nothing is dropped.
  const auto less = [](const Row& a, const Row& b) {
    if (a.bound != b.bound) return a.bound < b.bound;
    return a.heading != b.heading ? a.heading > b.heading : a.row > b.row;
  };
  std::make_heap(rows_.begin(), rows_.end(), less);
  while (!rows_.empty()) {
    std::pop_heap(rows_.begin(), rows_.end(), less);
    Row row = rows_.back();
    rows_.pop_back();
    const InfillPass pass = best_on(headings_[row.heading], row.row);
    const double length = (pass.to - pass.from).norm();
    double worth = pass.gain_m2 - least_gain_ * length;
    if (!(length > 0.0) || worth <= 0.0) continue;
    // Land narrower than a bin may lie between two centres.
    if (shop_.lines_in().inside_length(pass.from, pass.to) < length - kDust) continue;
    if (!rows_.empty() && worth < rows_.front().bound) {
      // The pass is not the best even without its detour, which is slow to compute.
      row.bound = worth;
      rows_.push_back(row);
      std::push_heap(rows_.begin(), rows_.end(), less);
      continue;
    }
    worth -= least_gain_ * detour(pass);
    if (worth <= 0.0) continue;
    row.bound = worth;
    if (rows_.empty() || worth >= rows_.front().bound) {
      sweep(pass);
      rows_.push_back(row);
      return pass;
    }
    rows_.push_back(row);
    std::push_heap(rows_.begin(), rows_.end(), less);
  }
  return std::nullopt;
}

}  // namespace swathplan
