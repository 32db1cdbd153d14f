#include "planners/steering/water_path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "coverage/tracing/coverage_grid.h"
#include "mesh/plane/area_query.h"

namespace swathplan {
namespace {

/// A way may leave the water by this share of its length, since cuts at the outline are rounded.
constexpr double kDust = 1e-6;
/// Lattice cells are no finer than this, metres.
constexpr double kFinestCell = 0.5;

double lattice_cell(const Area& water) {
  const Vec2 size = extent(water).size();
  return std::max(kFinestCell, std::sqrt(size.x() * size.y() / WaterPath::kMostCells));
}

}  // namespace

struct WaterPath::Impl {
  Area eroded;
  AreaQuery water;
  std::optional<AreaQuery> clear;    // the water less the clearance
  std::optional<CoverageGrid> grid;  // cells whose centre keeps the clearance

  Impl(const Area& area, double clearance, double cell)
      : eroded(offset(area, -std::max(clearance, 0.75 * cell))), water(area) {
    if (eroded.empty()) return;
    clear.emplace(eroded);
    grid.emplace(eroded, cell);
  }

  static bool inside(const AreaQuery& area, const Vec2& a, const Vec2& b) {
    const double length = (b - a).norm();
    return length == 0.0 ? area.contains(a)
                         : area.inside_length(a, b) >= length - kDust * std::max(1.0, length);
  }

  [[nodiscard]] Vec2 centre(std::uint32_t i) const {
    return grid->centre(i % grid->columns(), i / grid->columns());
  }
  [[nodiscard]] std::optional<std::uint32_t> nearest_cell(const Vec2& p) const;
  [[nodiscard]] std::vector<std::uint32_t> search(std::uint32_t from, std::uint32_t to) const;
  [[nodiscard]] std::vector<Vec2> pulled_taut(const std::vector<Vec2>& way) const;
};

/// The nearest passable cell that is in sight of p through the water.
std::optional<std::uint32_t> WaterPath::Impl::nearest_cell(const Vec2& p) const {
  const auto columns = static_cast<std::int64_t>(grid->columns());
  const auto rows = static_cast<std::int64_t>(grid->rows());
  const Vec2 at = (p - grid->origin()) / grid->resolution_m();
  const auto c0 = static_cast<std::int64_t>(std::floor(at.x()));
  const auto r0 = static_cast<std::int64_t>(std::floor(at.y()));
  constexpr std::int64_t kRings = 60;
  std::optional<std::uint32_t> best;
  double best_distance = std::numeric_limits<double>::infinity();
  for (std::int64_t ring = 0; ring <= kRings; ++ring) {
    if (best && static_cast<double>(ring - 1) * grid->resolution_m() > best_distance) break;
    for (std::int64_t r = r0 - ring; r <= r0 + ring; ++r) {
      const bool whole_row = r == r0 - ring || r == r0 + ring;
      for (std::int64_t c = c0 - ring; c <= c0 + ring;
           c += whole_row ? 1 : std::max<std::int64_t>(1, 2 * ring)) {
        if (c < 0 || r < 0 || c >= columns || r >= rows) continue;
        const auto i = static_cast<std::uint32_t>(r * columns + c);
        if (!grid->counts(i)) continue;
        const double distance = (centre(i) - p).norm();
        if (distance < best_distance && inside(water, p, centre(i))) {
          best_distance = distance;
          best = i;
        }
      }
    }
  }
  return best;
}

/// A* over the eight neighbours; a diagonal step needs both cells beside it.
std::vector<std::uint32_t> WaterPath::Impl::search(std::uint32_t from, std::uint32_t to) const {
  const auto columns = static_cast<std::int64_t>(grid->columns());
  const auto rows = static_cast<std::int64_t>(grid->rows());
  const std::size_t cells = static_cast<std::size_t>(columns * rows);
  constexpr std::uint32_t kNone = 0xFFFFFFFFU;
  std::vector<float> cost(cells, std::numeric_limits<float>::infinity());
  std::vector<std::uint32_t> before(cells, kNone);
  const auto to_c = static_cast<double>(to % columns);
  const auto row_of = [&](std::uint32_t i) {
    const std::int64_t row = i / columns;
    return static_cast<double>(row);
  };
  const double to_r = row_of(to);
  const auto heuristic = [&](std::uint32_t i) {
    const double dc = std::abs(static_cast<double>(i % columns) - to_c);
    const double dr = std::abs(row_of(i) - to_r);
    return static_cast<float>(std::max(dc, dr) + (std::sqrt(2.0) - 1.0) * std::min(dc, dr));
  };
  using Item = std::pair<float, std::uint32_t>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> open;
  cost[from] = 0.0F;
  open.emplace(heuristic(from), from);
  const auto free = [&](std::int64_t c, std::int64_t r) {
    return c >= 0 && r >= 0 && c < columns && r < rows &&
           grid->counts(static_cast<std::size_t>(r * columns + c));
  };
  while (!open.empty()) {
    const auto [estimate, here] = open.top();
    open.pop();
    if (here == to) break;
    if (estimate > cost[here] + heuristic(here) + 1e-3F) continue;
    const auto c = static_cast<std::int64_t>(here) % columns;
    const auto r = static_cast<std::int64_t>(here) / columns;
    for (std::int64_t dr = -1; dr <= 1; ++dr) {
      for (std::int64_t dc = -1; dc <= 1; ++dc) {
        if ((dc == 0 && dr == 0) || !free(c + dc, r + dr)) continue;
        if (dc != 0 && dr != 0 && !(free(c + dc, r) && free(c, r + dr))) continue;
        const auto there = static_cast<std::uint32_t>((r + dr) * columns + c + dc);
        const float step = dc != 0 && dr != 0 ? std::sqrt(2.0F) : 1.0F;
        if (cost[here] + step >= cost[there]) continue;
        cost[there] = cost[here] + step;
        before[there] = here;
        open.emplace(cost[there] + heuristic(there), there);
      }
    }
  }
  std::vector<std::uint32_t> way;
  if (from != to && before[to] == kNone) return way;
  for (std::uint32_t i = to; i != kNone; i = before[i]) way.push_back(i);
  std::reverse(way.begin(), way.end());
  return way;
}

std::vector<Vec2> WaterPath::Impl::pulled_taut(const std::vector<Vec2>& way) const {
  std::vector<Vec2> taut{way.front()};
  for (std::size_t i = 0; i + 1 < way.size();) {
    // Doubling and halving find the farthest point in sight, since a point behind a hidden one is
    // seldom in sight itself.
    std::size_t reach = i + 1;
    std::size_t step = 1;
    const auto sees = [&](std::size_t j) {
      const bool at_an_end = i == 0 || j + 1 == way.size();
      return inside(at_an_end ? water : *clear, way[i], way[j]);
    };
    while (step > 0) {
      const std::size_t j = reach + step;
      if (j < way.size() && sees(j)) {
        reach = j;
        step *= 2;
      } else {
        step /= 2;
      }
    }
    taut.push_back(way[reach]);
    i = reach;
  }
  return taut;
}

WaterPath::WaterPath(const Area& water, double clearance_m)
    : impl_(std::make_unique<Impl>(water, clearance_m, lattice_cell(water))) {}
WaterPath::~WaterPath() = default;
WaterPath::WaterPath(WaterPath&&) noexcept = default;
WaterPath& WaterPath::operator=(WaterPath&&) noexcept = default;

std::optional<std::vector<Vec2>> WaterPath::find(const Vec2& from, const Vec2& to) const {
  if (Impl::inside(impl_->water, from, to)) return std::vector<Vec2>{from, to};
  if (!impl_->grid) return std::nullopt;
  const auto a = impl_->nearest_cell(from);
  const auto b = impl_->nearest_cell(to);
  if (!a || !b) return std::nullopt;
  const auto cells = impl_->search(*a, *b);
  if (cells.empty()) return std::nullopt;
  std::vector<Vec2> way{from};
  for (const std::uint32_t i : cells) way.push_back(impl_->centre(i));
  way.push_back(to);
  return impl_->pulled_taut(way);
}

}  // namespace swathplan
