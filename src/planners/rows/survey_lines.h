#pragma once

#include <optional>
#include <vector>

#include "mesh/base/angle.h"
#include "mesh/plane/polygons.h"

namespace swathplan {

/// A straight survey line, local metres.
struct SurveyLine {
  Vec2 from = Vec2::Zero(), to = Vec2::Zero();
  int row = 0;  ///< which of the parallel sweeps it is a piece of
};

struct ParallelLinesOptions {
  Angle azimuth;           ///< of the lines, clockwise from north
  double spacing_m = 1.0;  ///< > 0
  double inset_m = 0.0;    ///< lines stop this far before the outline
  double shift_m = 0.0;    ///< all rows lie this far to the right of where they are centred
};

/// Parallel lines across the area at an even spacing: as many as fit its width rounded, centred
/// in it (and shifted), each cut to the area. By row, then along. Pieces shorter than a fifth of
/// the spacing are left out where their row has a longer one.
[[nodiscard]] std::vector<SurveyLine> parallel_lines(const Area& area,
                                                     const ParallelLinesOptions& options);

/// The azimuth in [0, 180) degrees across which the area is narrowest, so that the fewest lines are
/// needed: along one of the outline's longer sides or a whole number of 5 degrees.
[[nodiscard]] Angle best_azimuth(const Area& area, double spacing_m);

/// Orders and turns lines for sailing: neighbouring rows that overlap one to one make a block that
/// is sailed to and fro; blocks follow by the nearest end. Begins nearest to `start`, if given.
[[nodiscard]] std::vector<SurveyLine> to_and_fro(const std::vector<SurveyLine>& lines,
                                                 const std::optional<Vec2>& start);

}  // namespace swathplan
