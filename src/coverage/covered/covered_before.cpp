#include "coverage/covered/covered_before.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace swathplan {
namespace {

using Marks = std::vector<std::uint8_t>;

/// Outlines of the rest are rounded within so many cells. The corners of a slanting edge lie up to
/// a cell off the straight.
constexpr double kRoundedSteps = 1.1;
/// Cells around the grid, so that its border needs no case of its own.
constexpr std::size_t kRim = 2;

/// The grid's cells with a rim around them.
struct Sheet {
  std::size_t columns, rows;

  explicit Sheet(const CoverageGrid& grid)
      : columns(grid.columns() + 2 * kRim), rows(grid.rows() + 2 * kRim) {}
  [[nodiscard]] std::size_t size() const { return columns * rows; }
  [[nodiscard]] std::size_t at(std::uint32_t c, std::uint32_t r) const {
    return (r + kRim) * columns + c + kRim;
  }

  /// 1 where `test` holds for the cell and its eight neighbours (all), or for any of them. The
  /// outermost ring stays 0.
  template <class Test>
  [[nodiscard]] Marks around(bool all, Test test) const {
    Marks result(size(), 0);
    for (std::size_t r = 1; r + 1 < rows; ++r) {
      for (std::size_t c = 1; c + 1 < columns; ++c) {
        int n = 0;
        for (std::size_t y = r - 1; y <= r + 1; ++y) {
          for (std::size_t x = c - 1; x <= c + 1; ++x) n += test(y * columns + x) ? 1 : 0;
        }
        result[r * columns + c] = (all ? n == kNarrowestRest * kNarrowestRest : n > 0) ? 1 : 0;
      }
    }
    return result;
  }
};

constexpr std::uint8_t kBeyond = 2;  ///< no part of the survey area

/// 1 where a cell is to be covered, kBeyond outside the area, else 0.
Marks empty_cells(const CoveredBefore& before, const Sheet& sheet) {
  Marks marks(sheet.size(), kBeyond);
  const CoverageGrid& grid = before.grid();
  for (std::uint32_t r = 0; r < grid.rows(); ++r) {
    for (std::uint32_t c = 0; c < grid.columns(); ++c) {
      const std::size_t i = std::size_t{r} * grid.columns() + c;
      if (grid.counts(i)) marks[sheet.at(c, r)] = before.covered(i) ? 0 : 1;
    }
  }
  return marks;
}

/// Takes out the cells of pieces that are no larger than `most` cells.
void drop_small_pieces(Marks& kept, const Sheet& sheet, std::size_t most) {
  Marks seen(kept.size(), 0);
  std::vector<std::size_t> piece;
  for (std::size_t start = 0; start < kept.size(); ++start) {
    if (kept[start] == 0 || seen[start] != 0) continue;
    piece.assign(1, start);
    seen[start] = 1;
    for (std::size_t k = 0; k < piece.size(); ++k) {
      const std::size_t i = piece[k];
      for (const std::size_t n : {i - 1, i + 1, i - sheet.columns, i + sheet.columns}) {
        if (kept[n] == 0 || seen[n] != 0) continue;
        seen[n] = 1;
        piece.push_back(n);
      }
    }
    if (piece.size() > most) continue;
    for (const std::size_t i : piece) kept[i] = 0;
  }
}

std::size_t pieces_of(const Marks& marks, const Sheet& sheet) {
  Marks left = marks;
  std::size_t count = 0;
  for (std::size_t start = 0; start < left.size(); ++start) {
    if (left[start] == 0) continue;
    ++count;
    std::vector<std::size_t> open{start};
    left[start] = 0;
    while (!open.empty()) {
      const std::size_t i = open.back();
      open.pop_back();
      for (const std::size_t n : {i - 1, i + 1, i - sheet.columns, i + sheet.columns}) {
        if (left[n] == 0) continue;
        left[n] = 0;
        open.push_back(n);
      }
    }
  }
  return count;
}

/// The empty cells that are worth a line: where a square of them has room, and what is beside it.
Marks worth_a_line(const Marks& empty, const Sheet& sheet, double smallest_m2, double cell_m2) {
  Marks kept = sheet.around(true, [&](std::size_t i) { return empty[i] == 1; });
  // Once gives the squares back that were found by their middles, once more their ragged edge.
  for (int ring = 0; ring < 2; ++ring) {
    Marks near = sheet.around(false, [&](std::size_t i) { return kept[i] != 0; });
    for (std::size_t i = 0; i < near.size(); ++i) {
      if (empty[i] != 1) near[i] = 0;
    }
    kept = std::move(near);
  }
  const double fewest = std::ceil(smallest_m2 / cell_m2);
  drop_small_pieces(kept, sheet, fewest > 1.0 ? static_cast<std::size_t>(fewest) - 1 : 0);
  return kept;
}

bool is_in_strip(const Vec2& p, const std::vector<Vec2>& path, std::size_t i, double half) {
  const Vec2 way = path[i + 1] - path[i];
  const double length = way.norm();
  if (!(length > 0.0)) return false;
  const Vec2 off = p - path[i];
  const double along = off.dot(way) / length;
  if (along < 0.0) return i > 0 && off.norm() <= half;
  if (along > length) return i + 2 < path.size() && (p - path[i + 1]).norm() <= half;
  return std::abs(off.x() * way.y() - off.y() * way.x()) / length <= half;
}

/// Where the first cell of `part` lies in `grid`.
std::array<std::int64_t, 2> shift_between(const CoverageGrid& part, const CoverageGrid& grid) {
  const Vec2 steps = (part.origin() - grid.origin()) / grid.resolution_m();
  return {std::llround(steps.x()), std::llround(steps.y())};
}

/// Calls visit(cell of `grid`, cell of `part`) for the cells that both have.
template <class Visit>
void for_each_shared(const CoverageGrid& grid, const CoverageGrid& part, Visit visit) {
  const auto [dx, dy] = shift_between(part, grid);
  for (std::int64_t r = 0; r < part.rows(); ++r) {
    if (r + dy < 0 || r + dy >= grid.rows()) continue;
    for (std::int64_t c = 0; c < part.columns(); ++c) {
      if (c + dx < 0 || c + dx >= grid.columns()) continue;
      visit(static_cast<std::size_t>((r + dy) * grid.columns() + c + dx),
            static_cast<std::size_t>(r * part.columns() + c));
    }
  }
}

double per_cent(std::uint64_t part, std::uint64_t all) {
  return all > 0 ? 100.0 * static_cast<double>(part) / static_cast<double>(all) : 0.0;
}

}  // namespace

CoveredBefore::CoveredBefore(const Area& survey_area, double resolution_m, std::uint32_t wanted)
    : survey_area_(survey_area),
      grid_(survey_area, resolution_m),
      wanted_(std::max<std::uint32_t>(1, wanted)) {}

CoveredBefore CoveredBefore::without_soundings() const {
  CoveredBefore same = *this;
  for (std::uint32_t& word : same.grid_.words()) word &= ~CoverageGrid::kCountMask;
  return same;
}

std::uint64_t CoveredBefore::cells() const {
  std::uint64_t n = 0;
  for (std::size_t i = 0; i < grid_.words().size(); ++i) n += grid_.counts(i) ? 1U : 0U;
  return n;
}

std::uint64_t CoveredBefore::covered_cells() const {
  std::uint64_t n = 0;
  for (std::size_t i = 0; i < grid_.words().size(); ++i) {
    n += grid_.counts(i) && covered(i) ? 1U : 0U;
  }
  return n;
}

void CoveredBefore::add(std::size_t cell, std::uint32_t soundings) {
  std::uint32_t& word = grid_.words()[cell];
  const std::uint64_t sum = std::uint64_t{word & CoverageGrid::kCountMask} + soundings;
  const auto count =
      static_cast<std::uint32_t>(std::min<std::uint64_t>(CoverageGrid::kCountMask, sum));
  word = (word & ~CoverageGrid::kCountMask) | count;
}

std::optional<std::size_t> CoveredBefore::cell_at(const Vec2& p) const {
  const Vec2 at = (p - grid_.origin()) / grid_.resolution_m();
  if (!(at.x() >= 0.0 && at.y() >= 0.0 && at.x() < grid_.columns() && at.y() < grid_.rows())) {
    return std::nullopt;
  }
  const std::size_t i =
      static_cast<std::size_t>(at.y()) * grid_.columns() + static_cast<std::size_t>(at.x());
  return grid_.counts(i) ? std::optional(i) : std::nullopt;
}

void CoveredBefore::cover(const Area& area) {
  const Area inside = intersect(area, survey_area_);
  if (inside.empty()) return;
  const CoverageGrid part(inside, grid_.resolution_m(), grid_.origin());
  for_each_shared(grid_, part, [&](std::size_t i, std::size_t k) {
    if (part.counts(k) && grid_.counts(i)) cover(i);
  });
}

void CoveredBefore::cover(const std::vector<Vec2>& path, double swath_m) {
  const double half = 0.5 * swath_m;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    Box2 box;
    box.extend(path[i]);
    box.extend(path[i + 1]);
    const auto index = [&](double metres, std::uint32_t most) {
      const double cell = std::floor(metres / grid_.resolution_m());
      return static_cast<std::uint32_t>(std::clamp(cell, 0.0, static_cast<double>(most)));
    };
    const Vec2 low = box.min - Vec2::Constant(half) - grid_.origin();
    const Vec2 high = box.max + Vec2::Constant(half) - grid_.origin();
    const std::uint32_t last_row = index(high.y(), grid_.rows() - 1);
    const std::uint32_t last_column = index(high.x(), grid_.columns() - 1);
    for (std::uint32_t r = index(low.y(), grid_.rows()); r <= last_row; ++r) {
      for (std::uint32_t c = index(low.x(), grid_.columns()); c <= last_column; ++c) {
        const std::size_t cell = std::size_t{r} * grid_.columns() + c;
        if (grid_.counts(cell) && is_in_strip(grid_.centre(c, r), path, i, half)) cover(cell);
      }
    }
  }
}

void CoveredBefore::add(const CoverageGrid& scored, bool logged_only) {
  for_each_shared(grid_, scored, [&](std::size_t i, std::size_t k) {
    if (grid_.counts(i)) add(i, logged_only ? scored.logged_soundings(k) : scored.soundings(k));
  });
}

Rest CoveredBefore::rest(double smallest_m2) const {
  const Sheet sheet(grid_);
  const double cell_m = grid_.resolution_m();
  const Marks empty = empty_cells(*this, sheet);
  const Marks kept = worth_a_line(empty, sheet, smallest_m2, cell_m * cell_m);
  Rest rest;
  Marks left_out(empty.size(), 0);
  std::size_t left_out_cells = 0;
  for (std::size_t i = 0; i < empty.size(); ++i) {
    left_out[i] = empty[i] == 1 && kept[i] == 0 ? 1 : 0;
    left_out_cells += left_out[i];
  }
  rest.gaps = pieces_of(left_out, sheet);
  rest.gaps_m2 = static_cast<double>(left_out_cells) * cell_m * cell_m;
  // The rest reaches to the outline of the area, not only to the outermost cells that count.
  Marks wide = kept;
  for (std::size_t ring = 0; ring < kRim; ++ring) {
    const Marks near = sheet.around(false, [&](std::size_t i) { return wide[i] != 0; });
    for (std::size_t i = 0; i < wide.size(); ++i) {
      if (near[i] != 0 && empty[i] == kBeyond) wide[i] = 1;
    }
  }
  const CellLattice lattice{grid_.origin() - Vec2::Constant(cell_m * kRim), cell_m, sheet.columns,
                            sheet.rows};
  rest.area = intersect(simplify(outlines(wide, lattice), kRoundedSteps * cell_m), survey_area_);
  const double least = std::max(smallest_m2, cell_m * cell_m * kNarrowestRest);
  std::erase_if(rest.area, [&](const Polygon& piece) { return area_m2({piece}) < least; });
  return rest;
}

WholeFigures CoveredBefore::whole(const CoverageGrid& scored, const Rest& rest) const {
  std::uint64_t all = covered_cells();
  std::uint64_t logged = all;
  for_each_shared(grid_, scored, [&](std::size_t i, std::size_t k) {
    if (!grid_.counts(i) || covered(i)) return;
    const std::uint32_t before = grid_.soundings(i);
    all += before + scored.soundings(k) >= wanted_ ? 1U : 0U;
    logged += before + scored.logged_soundings(k) >= wanted_ ? 1U : 0U;
  });
  WholeFigures figures;
  figures.cells = cells();
  figures.area_m2 = area_m2(survey_area_);
  figures.before_pct = per_cent(covered_cells(), figures.cells);
  figures.all_pct = per_cent(all, figures.cells);
  figures.logged_pct = per_cent(logged, figures.cells);
  figures.left_out_m2 = rest.gaps_m2;
  return figures;
}

}  // namespace swathplan
