#pragma once

#include "mesh/plane/area_query.h"
#include "planners/fronts/swept_lines.h"

namespace swathplan {

/// Adds short straight passes over what lines leave unswept, in `lines_in`, until no more than the
/// share `most_missed` of the area is missed: those first that sweep most for their metres and
/// their turns. A pass runs across the short way of a gap, since its swath is wide. Gaps of which
/// no pass brings at least kLeastPassGain are left.
/// Returns how many were added.
std::size_t add_closing_passes(std::vector<SweptLine>& lines, const SweptGround& ground,
                               const AreaQuery& lines_in, double most_missed);

inline constexpr double kLeastPassGain = 0.01;  ///< of W, square metres per metre

}  // namespace swathplan
