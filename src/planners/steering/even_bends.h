#pragma once

#include <cstddef>

#include "coverage/route/route.h"
#include "planners/steering/connect.h"

namespace swathplan {

/// Widens bends that are tighter than `radius_m` only by the way they are written. Two curves meet
/// with chords of unequal length, or with a sliver (a very short chord) between them. The waypoint
/// there asks for a tighter turn than either curve (bend_radius_m). Such
/// waypoints move along the path, by less than a chord, until none asks for less than `radius_m`.
/// The ends of a sliver become one waypoint. A bend that stays tighter (a corner, or no water to
/// move in) is marked `feasible = false`. Guarantees: (1) only bends at marked legs are tighter
/// than `radius_m`; (2) both ends stay, and a path in the water stays in the water; (3) a route
/// without tight bends comes back unchanged. Cost: O(n), and a few hundred steps around each tight
/// bend. Returns the number of bends that were marked.
std::size_t even_bends(Route& route, double radius_m, const Connector& connector);

}  // namespace swathplan
