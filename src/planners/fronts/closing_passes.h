#pragma once

#include "mesh/plane/area_query.h"
#include "planners/fronts/swept_lines.h"

namespace swathplan {

/// Adds short straight passes over gaps between lines, until no more than the share `most_missed`
/// of the area is missed. Passes run in `lines_in`. Those that sweep most for their metres and
/// their turns come first. A pass runs the short way across a gap, since its swath is wide. A gap
/// stays if no pass over it brings at least kLeastPassGain. Returns how many were added.
std::size_t add_closing_passes(std::vector<SweptLine>& lines, const SweptGround& ground,
                               const AreaQuery& lines_in, double most_missed);

inline constexpr double kLeastPassGain = 0.01;  ///< of W, square metres per metre

}  // namespace swathplan
