#pragma once

#include <vector>

#include "coverage/ground.h"
#include "coverage/standards/judge.h"

namespace swathplan {

/// Most cells of all grids together: 32 bytes each.
inline constexpr double kMostJudgedCells = 8e7;

/// How far apart the points are that the seafloor is known by, metres: the side of the squares that
/// pairs of its faces would be if all were equal.
[[nodiscard]] double data_spacing_m(const Seafloor& seafloor);

/// The grids that the depths of the survey area ask for, one for each cell size, without soundings.
/// A cell is asked for where its centre lies in the area, at a depth of its grid's range.
/// @throws UsageError if they would hold more than kMostJudgedCells.
[[nodiscard]] std::vector<JudgedGrid> criterion_grids(const Criterion& criterion,
                                                      const Ground& ground);

}  // namespace swathplan
