#include "planners/fronts/channel.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "planners/fronts/eikonal.h"
#include "planners/fronts/field_lines.h"
#include "planners/fronts/level_lines.h"

namespace swathplan {
namespace {

constexpr float kNone = std::numeric_limits<float>::infinity();
/// A hole makes a ring of the water only if its shore has at least this share of the outer shore's
/// length.
constexpr double kLeastInner = 0.3;
/// A cell of the area lies within this many cells of any point of the outline.
constexpr int kRimCells = 2;

SurveyCurve closed(const Ring& ring) {
  SurveyCurve curve{ring};
  curve.points.push_back(ring.front());
  return curve;
}

/// Metres through the water from a cell.
std::vector<float> metres_from(const WaterRaster& raster, std::size_t cell) {
  std::vector<float> unit(raster.size(), 0.0F);
  for (std::size_t i = 0; i < unit.size(); ++i) unit[i] = raster.in_area(i) ? 1.0F : 0.0F;
  return march(raster, unit, {{cell, 0.0, 0}}).u;
}

std::size_t farthest(const std::vector<float>& metres) {
  std::size_t best = 0;
  for (std::size_t i = 0; i < metres.size(); ++i) {
    if (std::isfinite(metres[i]) && (!std::isfinite(metres[best]) || metres[i] > metres[best])) {
      best = i;
    }
  }
  return best;
}

/// The least value of the cells about p.
float value_near(const WaterRaster& raster, const std::vector<float>& values, const Vec2& p) {
  float least = kNone;
  for (int dy = -kRimCells; dy <= kRimCells; ++dy) {
    for (int dx = -kRimCells; dx <= kRimCells; ++dx) {
      const auto i = raster.cell_at(p + raster.cell_m() * Vec2(dx, dy));
      if (i) least = std::min(least, values[*i]);
    }
  }
  return least;
}

enum class End { none, first, second };

/// Points of a closed shore, from `first` on.
struct Stretch {
  std::size_t first = 0, count = 0;
};

/// The stretches of a closed shore between one end and the other.
std::vector<Stretch> stretches(const std::vector<End>& ends) {
  const auto first =
      static_cast<std::size_t>(std::find(ends.begin(), ends.end(), End::first) - ends.begin());
  std::vector<Stretch> list;
  Stretch current;
  End behind = End::first;
  for (std::size_t k = 1; k <= ends.size() && first < ends.size(); ++k) {
    const std::size_t i = (first + k) % ends.size();
    if (ends[i] == End::none) {
      if (current.count++ == 0) current.first = i;
      continue;
    }
    if (ends[i] != behind && current.count > 1) list.push_back(current);
    current = {};
    behind = ends[i];
  }
  return list;
}

/// A bank runs on around an end until its direction has changed by this.
constexpr double kCosOfEnd = 0.7;
/// The chord that a bank's direction is taken from, as a share of the water's width.
constexpr double kChordOfWidth = 0.2;

/// The stretch as a curve that runs on at both of its ends. Directions are those of chords over
/// `chord` points, so that steps in the outline do not count.
SurveyCurve run_on(const std::vector<Vec2>& shore, const Stretch& stretch, std::size_t chord) {
  const std::size_t size = shore.size();
  const auto at = [&](std::size_t i) -> const Vec2& { return shore[i % size]; };
  const auto straight = [&](std::size_t tip, std::size_t from, std::size_t step) {
    // A step backwards is size - 1 steps forwards round the shore.
    const Vec2 along = (at(tip) - at(tip + (size - step) * chord)).normalized();
    const Vec2 here = (at(from + step * chord) - at(from)).normalized();
    return along.dot(here) > kCosOfEnd;
  };
  const std::size_t most = (size - stretch.count) / 4;
  const std::size_t last = stretch.first + stretch.count - 1;
  std::size_t ahead = 0;
  while (ahead < most && straight(last, last + ahead, 1)) ++ahead;
  std::size_t back = 0;
  while (back < most && straight(stretch.first, stretch.first + back * (size - 1), size - 1)) {
    ++back;
  }
  SurveyCurve bank;
  for (std::size_t k = 0; k < stretch.count + ahead + back; ++k) {
    bank.points.push_back(at(stretch.first + size - back + k));
  }
  return bank;
}

std::optional<Banks> banks_of_channel(const WaterRaster& raster, const Polygon& water) {
  const auto inside = raster.cell_at(inner_point({water}));
  if (!inside || !raster.in_area(*inside)) return std::nullopt;
  const std::size_t first = farthest(metres_from(raster, *inside));
  const std::vector<float> from_first = metres_from(raster, first);
  const std::size_t second = farthest(from_first);
  const std::vector<float> from_second = metres_from(raster, second);
  const double length = static_cast<double>(from_first[second]);
  const double width = area_m2({water}) / std::max(length, raster.cell_m());
  if (length < kElongated * width) return std::nullopt;
  SurveyCurve shore = resampled(closed(water.outer), raster.cell_m());
  shore.points.pop_back();
  std::vector<End> ends;
  ends.reserve(shore.points.size());
  const auto beyond = static_cast<float>(length - kEndOfWidth * width);
  for (const Vec2& p : shore.points) {
    const float a = value_near(raster, from_first, p);
    const float b = value_near(raster, from_second, p);
    const bool at_second = std::isfinite(a) && a > beyond;
    const bool at_first = std::isfinite(b) && b > beyond;
    ends.push_back(at_second ? End::second : at_first ? End::first : End::none);
  }
  const std::vector<Stretch> banks = stretches(ends);
  if (banks.size() != 2) return std::nullopt;
  const auto chord =
      std::max<std::size_t>(3, static_cast<std::size_t>(kChordOfWidth * width / raster.cell_m()));
  Banks found{run_on(shore.points, banks[0], chord), run_on(shore.points, banks[1], chord),
              std::vector<float>(raster.size(), kNone)};
  for (std::size_t i = 0; i < raster.size(); ++i) {
    const float all = from_first[i] + from_second[i];
    if (std::isfinite(all) && all > 0.0F) found.along[i] = from_first[i] / all;
  }
  return found;
}

std::optional<Banks> banks_of_ring(const WaterRaster& raster, const Polygon& water) {
  if (water.holes.empty()) return std::nullopt;
  const SurveyCurve outer = closed(water.outer);
  SurveyCurve inner;
  for (const Ring& hole : water.holes) {
    SurveyCurve shore = closed(hole);
    if (length_m(shore) > length_m(inner)) inner = std::move(shore);
  }
  const double length = 0.5 * (length_m(outer) + length_m(inner));
  if (length_m(inner) < kLeastInner * length_m(outer)) return std::nullopt;
  if (length < kElongated * area_m2({water}) / length) return std::nullopt;
  return Banks{resampled(outer, raster.cell_m()), resampled(inner, raster.cell_m()), {}};
}

/// Stations along a channel that its swaths are counted at.
constexpr std::size_t kStations = 24;
/// The cost of a change in the number of lines, in lines at one station: it brings turns and a
/// seam.
constexpr double kChange = 1.5;
/// One line too few leaves a gap as wide as a swath. One line too many only costs its metres.
constexpr double kTooFew = 3.0;

/// The number of lines that each station asks for: the mean over its cells. A station without cells
/// takes the number of the one before it.
std::vector<double> wanted_lines(const Banks& banks, const BetweenBanks& between, double density) {
  std::vector<double> sum(kStations, 0.0);
  std::vector<std::size_t> cells(kStations, 0);
  for (std::size_t i = 0; i < between.swaths.size(); ++i) {
    if (!std::isfinite(between.swaths[i]) || !std::isfinite(banks.along[i])) continue;
    const auto s = std::min(kStations - 1, static_cast<std::size_t>(banks.along[i] * kStations));
    sum[s] += static_cast<double>(between.swaths[i]);
    ++cells[s];
  }
  double before = between.mean_swaths;
  for (std::size_t s = 0; s < kStations; ++s) {
    if (cells[s] > 0) before = sum[s] / static_cast<double>(cells[s]);
    sum[s] = density * before;
  }
  return sum;
}

/// Whole numbers near the wanted ones, with few changes. Dynamic programming over the stations.
std::vector<int> steady_lines(const std::vector<double>& wanted) {
  const double largest = *std::max_element(wanted.begin(), wanted.end());
  const auto most = static_cast<std::size_t>(std::max(1.0, std::ceil(largest)));
  std::vector<double> cost(most, 0.0);
  std::vector<std::vector<std::size_t>> came(wanted.size(), std::vector<std::size_t>(most, 0));
  for (std::size_t s = 0; s < wanted.size(); ++s) {
    const auto cheapest = std::min_element(cost.begin(), cost.end());
    const auto from = static_cast<std::size_t>(cheapest - cost.begin());
    const double changed = *cheapest + kChange;
    for (std::size_t n = 0; n < most; ++n) {
      came[s][n] = changed < cost[n] ? from : n;
      const double off = wanted[s] - static_cast<double>(n + 1);
      cost[n] = std::min(cost[n], changed) + (off > 0.0 ? kTooFew * off : -off);
    }
  }
  std::vector<int> lines(wanted.size(), 1);
  auto n = static_cast<std::size_t>(std::min_element(cost.begin(), cost.end()) - cost.begin());
  for (std::size_t s = wanted.size(); s-- > 0;) {
    lines[s] = static_cast<int>(n + 1);
    n = came[s][n];
  }
  return lines;
}

}  // namespace

std::optional<Banks> banks_of(const WaterRaster& raster, const Area& area) {
  const auto largest = std::max_element(
      area.begin(), area.end(),
      [](const Polygon& a, const Polygon& b) { return area_m2({a}) < area_m2({b}); });
  if (largest == area.end() || area_m2({*largest}) < kMostOfArea * area_m2(area)) {
    return std::nullopt;
  }
  std::optional<Banks> ring = banks_of_ring(raster, *largest);
  return ring ? ring : banks_of_channel(raster, *largest);
}

BetweenBanks between_banks(const WaterRaster& raster, const std::vector<float>& width,
                           const Banks& banks) {
  const auto from = [&](const SurveyCurve& bank) {
    return march(raster, width, front_along(raster, width, {bank})).u;
  };
  const std::vector<float> one = from(banks.one);
  const std::vector<float> other = from(banks.other);
  BetweenBanks between{std::vector<float>(raster.size(), kNone),
                       std::vector<float>(raster.size(), kNone), 0.0};
  double sum = 0.0;
  std::size_t cells = 0;
  for (std::size_t i = 0; i < raster.size(); ++i) {
    const float all = one[i] + other[i];
    if (!std::isfinite(all) || !(all > 0.0F)) continue;
    between.share[i] = one[i] / all;
    between.swaths[i] = all;
    sum += static_cast<double>(all);
    ++cells;
  }
  if (cells > 0) between.mean_swaths = sum / static_cast<double>(cells);
  return between;
}

std::vector<ChannelSection> sections_of(const Banks& banks, const BetweenBanks& between,
                                        double density) {
  if (banks.along.empty()) {
    return {
        {0.0F, 1.0F, std::max(1, static_cast<int>(std::lround(density * between.mean_swaths)))}};
  }
  const std::vector<double> wanted = wanted_lines(banks, between, density);
  const std::vector<int> lines = steady_lines(wanted);
  std::vector<ChannelSection> sections;
  for (std::size_t s = 0; s < lines.size(); ++s) {
    const auto share = [&](std::size_t k) {
      return static_cast<float>(k) / static_cast<float>(lines.size());
    };
    if (sections.empty() || sections.back().lines != lines[s]) {
      sections.push_back({share(s), share(s), lines[s]});
    }
    sections.back().to = share(s + 1);
  }
  return sections;
}

std::vector<SurveyCurve> lines_between(const WaterRaster& raster, const Banks& banks,
                                       const BetweenBanks& between,
                                       const std::vector<ChannelSection>& sections,
                                       int smooth_passes) {
  std::vector<SurveyCurve> list;
  for (const ChannelSection& section : sections) {
    const auto within = [&](std::size_t i) {
      return banks.along.empty() ||
             (banks.along[i] >= section.from && banks.along[i] <= section.to);
    };
    std::vector<float> all = between.share;
    std::vector<float> roomy = between.share;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (!within(i)) all[i] = kNone;
      const bool crowded = static_cast<double>(between.swaths[i]) < kCrowded * section.lines;
      if (crowded || !within(i)) roomy[i] = kNone;
    }
    for (int k = 0; k < section.lines; ++k) {
      const std::vector<float>& share = k == section.lines / 2 ? all : roomy;
      for (const SurveyCurve& chain : level_lines(raster, share, (k + 0.5) / section.lines)) {
        list.push_back(smoothed(resampled(chain, kCurveStep), smooth_passes));
      }
    }
  }
  return list;
}

}  // namespace swathplan
