#pragma once

#include <optional>
#include <vector>

#include "mesh/base/angle.h"
#include "mesh/plane/polygons.h"

namespace swathplan {

/// A straight survey line, local metres.
struct SurveyLine {
  Vec2 from = Vec2::Zero(), to = Vec2::Zero();
  int row = 0;  ///< the parallel row that it is a piece of
};

struct ParallelLinesOptions {
  Angle azimuth;           ///< of the lines, clockwise from north
  double spacing_m = 1.0;  ///< > 0
  double inset_m = 0.0;    ///< lines stop this far before the outline
  double shift_m = 0.0;    ///< all rows lie this far to the right of where they are centred
  /// Rows are as many as it takes for swaths so wide to cover the area's width. 0: the width over
  /// the spacing, rounded.
  double swath_m = 0.0;
};

/// Parallel lines over the area at an even spacing. They are centred (then shifted) and cut to the
/// area. Pieces come row by row, in the order along it. A piece shorter than a fifth of the spacing
/// is left out where its row has a longer one.
[[nodiscard]] std::vector<SurveyLine> parallel_lines(const Area& area,
                                                     const ParallelLinesOptions& options);

/// The lines that are at least so long; all where none is.
[[nodiscard]] std::vector<SurveyLine> no_shorter_than(double least_m,
                                                      std::vector<SurveyLine> lines);

/// The azimuth of lines, in [0, 180) degrees, across which the area is narrowest: the fewest lines
/// are needed. It is that of one of the outline's longer sides, or a multiple of 5 degrees.
[[nodiscard]] Angle best_azimuth(const Area& area, double spacing_m);

/// Orders and turns lines for sailing. Neighbouring rows that overlap one to one make a block,
/// which is sailed to and fro. The next block is always the one with the nearest end. Begins
/// nearest to `start`, if given.
[[nodiscard]] std::vector<SurveyLine> to_and_fro(const std::vector<SurveyLine>& lines,
                                                 const std::optional<Vec2>& start);

}  // namespace swathplan
