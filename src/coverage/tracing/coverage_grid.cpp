#include "coverage/tracing/coverage_grid.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <new>

#include "mesh/base/error.h"
#include "mesh/base/parallel.h"

namespace swathplan {

namespace {

// A centre this close to the outline lies on it, metres. The rounding of a crossing is far less,
// any survey's accuracy far more.
constexpr double kOnOutline = 1e-9;
// An extent may exceed a whole number of cells by this share of a cell and still count as that
// number: 80.00000000001 m is 800 cells of 0.1 m.
constexpr double kCellDust = 1e-6;

// The corner of the grid: that of the box, or of the lattice's cell that holds it.
Vec2 corner_of(const Box2& box, double resolution, const std::optional<Vec2>& lattice) {
  if (!lattice) return box.min;
  const Vec2 steps = ((box.min - *lattice) / resolution).array() + kCellDust;
  return *lattice + resolution * Vec2(std::floor(steps.x()), std::floor(steps.y()));
}

double cells_across(double length, double resolution) {
  return std::max(1.0, std::ceil(length / resolution - kCellDust));
}

// Which end of an edge belongs to it where a row of centres meets a vertex.
enum class EdgeEnd { lower, upper };

// The rows whose centre line crosses an edge, and where.
class RowCrossings {
 public:
  RowCrossings(const Area& area, const CoverageGrid& grid, EdgeEnd closed)
      : grid_(grid), closed_(closed), first_(grid.rows() + 1U, 0) {
    for_each_crossing(area, [&](std::size_t row, double) { ++first_[row + 1]; });
    for (std::size_t r = 0; r < grid.rows(); ++r) first_[r + 1] += first_[r];
    x_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for_each_crossing(area, [&](std::size_t row, double x) { x_[next[row]++] = x; });
    for (std::size_t r = 0; r < grid.rows(); ++r) {
      std::sort(x_.begin() + offset(first_[r]), x_.begin() + offset(first_[r + 1]));
    }
  }

  // Rows run in parallel, so `fill` may write to its own row only.
  template <class Fill>
  void for_each_span(Fill fill) const {
    for_each_index(std::uint32_t{0}, grid_.rows(), [&](std::uint32_t r) {
      for (std::size_t k = first_[r]; k + 1 < first_[r + 1]; k += 2) fill(r, x_[k], x_[k + 1]);
    });
  }

 private:
  static std::ptrdiff_t offset(std::size_t i) { return static_cast<std::ptrdiff_t>(i); }

  template <class Visit>
  void for_each_crossing(const Area& area, Visit visit) const {
    for (const Polygon& polygon : area) {
      ring_crossings(polygon.outer, visit);
      for (const Ring& hole : polygon.holes) ring_crossings(hole, visit);
    }
  }

  template <class Visit>
  void ring_crossings(const Ring& ring, Visit visit) const {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      Vec2 low = ring[i];
      Vec2 high = ring[(i + 1) % ring.size()];
      if (low.y() > high.y()) std::swap(low, high);
      if (low.y() == high.y()) continue;
      edge_crossings(low, high, visit);
    }
  }

  template <class Visit>
  void edge_crossings(const Vec2& low, const Vec2& high, Visit visit) const {
    const double base = grid_.origin().y();
    const double first = (low.y() - base) / grid_.resolution_m() - 1.5;
    for (double r = std::max(0.0, std::floor(first)); r < grid_.rows(); ++r) {
      const auto row = static_cast<std::uint32_t>(r);
      const double y = grid_.centre(0, row).y();
      if (closed_ == EdgeEnd::lower ? y < low.y() : y <= low.y()) continue;
      if (closed_ == EdgeEnd::lower ? y >= high.y() : y > high.y()) break;
      const double share = (y - low.y()) / (high.y() - low.y());
      visit(row, low.x() + share * (high.x() - low.x()));
    }
  }

  const CoverageGrid& grid_;
  EdgeEnd closed_;
  std::vector<std::size_t> first_;
  std::vector<double> x_;
};

void mark_span(CoverageGrid& grid, std::uint32_t row, double x0, double x1) {
  const double base = grid.origin().x();
  const double first = std::ceil((x0 - kOnOutline - base) / grid.resolution_m() - 0.5);
  const double last = std::floor((x1 + kOnOutline - base) / grid.resolution_m() - 0.5);
  const double end = std::min(last + 1.0, static_cast<double>(grid.columns()));
  if (!(end > 0.0)) return;
  std::uint32_t* const words = grid.words().data() + std::size_t{row} * grid.columns();
  const auto stop = static_cast<std::size_t>(end);
  for (auto c = static_cast<std::size_t>(std::max(0.0, first)); c < stop; ++c) {
    words[c] |= CoverageGrid::kInArea;
  }
}

// Marks centres that lie on an edge along a row. Neither rule for vertices sees such an edge.
void mark_level_edges(CoverageGrid& grid, const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2& a = ring[i];
    const Vec2& b = ring[(i + 1) % ring.size()];
    if (a.y() != b.y()) continue;
    const double r = std::round((a.y() - grid.origin().y()) / grid.resolution_m() - 0.5);
    if (r < 0 || r >= grid.rows()) continue;
    const auto row = static_cast<std::uint32_t>(r);
    if (std::abs(grid.centre(0, row).y() - a.y()) > kOnOutline) continue;
    mark_span(grid, row, std::min(a.x(), b.x()), std::max(a.x(), b.x()));
  }
}

}  // namespace

GridSize grid_size(const Area& area, double resolution_m, const std::optional<Vec2>& lattice) {
  if (!(resolution_m > 0) || !std::isfinite(resolution_m)) {
    throw UsageError("resolution", fmt::format("{} m", resolution_m),
                     "must be greater than 0 and finite");
  }
  const Box2 box = extent(area);
  if (box.empty()) throw InvalidInput("the survey area is empty; give an area that meets the data");
  const Vec2 size = box.max - corner_of(box, resolution_m, lattice);
  const double columns = cells_across(size.x(), resolution_m);
  const double rows = cells_across(size.y(), resolution_m);
  const auto limit = static_cast<double>(CoverageGrid::kMaxCells);
  if (columns * rows > limit) {
    throw UsageError(
        "resolution", fmt::format("{} m", resolution_m),
        fmt::format(
            "the scoring grid would hold {:.0f} x {:.0f} = {:.3g} cells ({:.3g} GB) "
            "and the limit is {:.3g} cells (8 GB): use a coarser resolution or a smaller area",
            columns, rows, columns * rows, columns * rows * 4e-9, limit));
  }
  return {static_cast<std::uint32_t>(columns), static_cast<std::uint32_t>(rows)};
}

CoverageGrid::CoverageGrid(const Area& area, double resolution_m,
                           const std::optional<Vec2>& lattice)
    : resolution_(resolution_m) {
  const GridSize size = grid_size(area, resolution_m, lattice);
  columns_ = size.columns;
  rows_ = size.rows;
  origin_ = corner_of(extent(area), resolution_m, lattice);
  words_.assign(std::size_t{columns_} * rows_, 0);
  // The even-odd rule leaves out one end of each edge. Both choices together give the closed area.
  for (const EdgeEnd closed : {EdgeEnd::lower, EdgeEnd::upper}) {
    RowCrossings(area, *this, closed).for_each_span([&](std::uint32_t row, double x0, double x1) {
      mark_span(*this, row, x0, x1);
    });
  }
  for (const Polygon& polygon : area) {
    mark_level_edges(*this, polygon.outer);
    for (const Ring& hole : polygon.holes) mark_level_edges(*this, hole);
  }
}

Vec2 CoverageGrid::centre(std::uint32_t column, std::uint32_t row) const {
  return origin_ + Vec2(column + 0.5, row + 0.5) * resolution_;
}

}  // namespace swathplan
