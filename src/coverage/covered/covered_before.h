#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "coverage/covered/cell_outlines.h"
#include "coverage/score.h"
#include "coverage/tracing/coverage_grid.h"

namespace swathplan {

/// What is left of a survey area that was surveyed in part.
struct Rest {
  Area area;             ///< still to be covered; empty if nothing is
  std::size_t gaps = 0;  ///< of the earlier survey that are too small to be planned for
  double gaps_m2 = 0.0;  ///< their area; they are no part of `area`
};

/// Gaps narrower than so many cells are no part of the rest: lines are never laid that near.
inline constexpr int kNarrowestRest = 3;

/// What was surveyed before, on the scoring cells of a survey area: a cell is covered once it has
/// as many soundings as are wanted, or once an area that counts as covered holds its centre.
class CoveredBefore {
 public:
  /// `wanted`: soundings that cover a cell, at least 1; more than 7 logged soundings of a route
  /// cannot be told apart. @throws UsageError, InvalidInput as CoverageGrid does.
  CoveredBefore(const Area& survey_area, double resolution_m, std::uint32_t wanted);

  /// The same cells, none of them covered.
  [[nodiscard]] CoveredBefore without_soundings() const;

  /// The cells, with their earlier soundings. Its `counts` are those of the whole area.
  [[nodiscard]] const CoverageGrid& grid() const { return grid_; }
  [[nodiscard]] bool covered(std::size_t cell) const { return grid_.soundings(cell) >= wanted_; }
  [[nodiscard]] std::uint64_t cells() const;          ///< of the whole area
  [[nodiscard]] std::uint64_t covered_cells() const;  ///< of them

  void cover(std::size_t cell) { add(cell, wanted_); }
  void add(std::size_t cell, std::uint32_t soundings);
  /// The index of the cell that holds `p`, if that counts.
  [[nodiscard]] std::optional<std::size_t> cell_at(const Vec2& p) const;
  /// Covers the cells whose centre lies in the area.
  void cover(const Area& area);
  /// Covers a strip about the path, `swath_m` across, as far as its ends and round its bends.
  void cover(const std::vector<Vec2>& path, double swath_m);
  /// Adds the soundings of a scored route: of all its pings, or of logged ones. `scored` must have
  /// cells on this lattice.
  void add(const CoverageGrid& scored, bool logged_only);

  /// The cells that are not covered, by their true outline, rounded by about a cell. Gaps that
  /// hold no square of kNarrowestRest cells, or are smaller than `smallest_m2`, are left out.
  [[nodiscard]] Rest rest(double smallest_m2) const;
  /// Coverage of the whole with a route whose score is of the rest. `scored` must have cells on
  /// this lattice. The gaps left out are those of rest().
  [[nodiscard]] WholeFigures whole(const CoverageGrid& scored, const Rest& rest) const;

 private:
  Area survey_area_;
  CoverageGrid grid_;
  std::uint32_t wanted_;
};

}  // namespace swathplan
