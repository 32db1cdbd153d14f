#include "planners/fronts/fitted_straight.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace swathplan {
namespace {

Vec2 along(Angle azimuth) { return {sin(azimuth), cos(azimuth)}; }
Vec2 across(Angle azimuth) { return {cos(azimuth), -sin(azimuth)}; }

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void extend(double v) {
    low = std::min(low, v);
    high = std::max(high, v);
  }
};

Range range_along(const WaterRaster& raster, const Vec2& direction) {
  Range range;
  // A cell stands for its whole square.
  const double half = 0.5 * raster.cell_m() * (std::abs(direction.x()) + std::abs(direction.y()));
  for (std::size_t i = 0; i < raster.size(); ++i) {
    if (!raster.in_area(i)) continue;
    const double at = raster.centre(i).dot(direction);
    range.extend(at - half);
    range.extend(at + half);
  }
  return range;
}

/// Where `share` of all swaths lie behind, metres across.
double row_at(const RowWidths& rows, double share) {
  const double wanted = share * rows.total();
  const auto it = std::lower_bound(rows.swaths.begin(), rows.swaths.end(), wanted);
  const auto bin = static_cast<std::size_t>(
      std::min(it - rows.swaths.begin(), static_cast<std::ptrdiff_t>(rows.swaths.size()) - 1));
  const double before = bin > 0 ? rows.swaths[bin - 1] : 0.0;
  const double here = rows.swaths[bin] - before;
  const double part = here > 0.0 ? std::clamp((wanted - before) / here, 0.0, 1.0) : 0.5;
  return rows.first_m + rows.bin_m * (static_cast<double>(bin) + part);
}

/// The share of all swaths that lie behind row k of `count`.
double share_behind(int k, int count, double total, const StraightLinesOptions& options) {
  const bool given = options.end_swaths || options.end_rows;
  const double ends =
      options.end_swaths ? *options.end_swaths / total : options.end_rows.value_or(0.0) / count;
  if (!given || count < 2 || ends >= 0.5) return (k + options.phase) / count;
  return ends + (1.0 - 2.0 * ends) * k / (count - 1);
}

/// Intervals of both lists, which are sorted.
std::vector<std::pair<double, double>> both(const std::vector<std::pair<double, double>>& a,
                                            const std::vector<std::pair<double, double>>& b) {
  std::vector<std::pair<double, double>> result;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    const double from = std::max(a[i].first, b[j].first);
    const double to = std::min(a[i].second, b[j].second);
    if (to > from) result.emplace_back(from, to);
    (a[i].second < b[j].second ? i : j) += 1;
  }
  return result;
}

}  // namespace

RowWidths row_widths(const WaterRaster& raster, const std::vector<float>& width, Angle azimuth,
                     double percentile) {
  RowWidths rows;
  const Vec2 v = across(azimuth);
  const Range range = range_along(raster, v);
  if (!(range.high > range.low)) return rows;
  const auto bins = static_cast<std::size_t>(
      std::max(1.0, std::ceil((range.high - range.low) / raster.cell_m())));
  rows.first_m = range.low;
  rows.bin_m = (range.high - range.low) / static_cast<double>(bins);
  std::vector<std::vector<float>> of_bin(bins);
  for (std::size_t i = 0; i < raster.size(); ++i) {
    if (!raster.in_area(i)) continue;
    const double at = (raster.centre(i).dot(v) - range.low) / rows.bin_m;
    of_bin[std::min(bins - 1, static_cast<std::size_t>(std::max(0.0, at)))].push_back(width[i]);
  }
  double sum = 0.0;
  double last = 0.0;
  rows.swaths.resize(bins);
  for (std::size_t b = 0; b < bins; ++b) {
    auto& w = of_bin[b];
    if (!w.empty()) {
      const auto k = static_cast<std::ptrdiff_t>(percentile * static_cast<double>(w.size() - 1));
      std::nth_element(w.begin(), w.begin() + k, w.end());
      last = static_cast<double>(w[static_cast<std::size_t>(k)]);
      w.clear();
      w.shrink_to_fit();
    }
    if (last > 0.0) sum += rows.bin_m / last;
    rows.swaths[b] = sum;
  }
  return rows;
}

std::vector<SurveyCurve> fitted_straight_lines(const WaterRaster& raster,
                                               const std::vector<float>& width,
                                               const AreaQuery& survey_area,
                                               const AreaQuery& lines_in,
                                               const StraightLinesOptions& options) {
  std::vector<SurveyCurve> lines;
  const RowWidths rows = row_widths(raster, width, options.azimuth, options.percentile);
  if (!(rows.total() > 0.0)) return lines;
  const int count =
      options.lines > 0 ? options.lines : std::max(1, static_cast<int>(std::ceil(rows.total())));
  const Vec2 u = along(options.azimuth);
  const Vec2 v = across(options.azimuth);
  const Range reach = range_along(raster, u);
  for (int k = 0; k < count; ++k) {
    const double at = row_at(rows, share_behind(k, count, rows.total(), options));
    const double before = row_at(rows, static_cast<double>(k) / count);
    const double after = row_at(rows, static_cast<double>(k + 1) / count);
    const Vec2 a = v * at + u * reach.low;
    const Vec2 b = v * at + u * reach.high;
    const double length = (b - a).norm();
    for (const auto& [t0, t1] : both(survey_area.clip(a, b), lines_in.clip(a, b))) {
      const double piece = (t1 - t0) * length;
      if (piece < kShortestPiece * (after - before)) continue;
      const double inset = std::min(options.inset_m, 0.3 * piece);
      lines.push_back(straight_curve(a + u * (t0 * length + inset), a + u * (t1 * length - inset)));
    }
  }
  return lines;
}

}  // namespace swathplan
