#pragma once

#include <string>
#include <vector>

#include "mesh/seafloor.h"

namespace swathplan {

/// z = (x^2 - y^2)/64 - 35 on [-40, 40]^2, sampled each metre: 10 to 60 m deep.
[[nodiscard]] Seafloor saddle();
/// A 100 m square plain at 10 m with a 40 m square pit at 45 m in its centre, near-vertical walls.
[[nodiscard]] Seafloor shaft();
/// A harbour of about 300 x 400 m, 3 to 26 m deep: quay walls, a mole, a dredged channel, a
/// basin, a shoal and an island; sampled each 2 m.
[[nodiscard]] Seafloor harbour();
/// An open sea of 7.4 x 9.3 km, 20 to 200 m deep: a shelf with three smooth shoals and a basin, no
/// slope over 6 degrees; sampled each 50 m.
[[nodiscard]] Seafloor sea();
/// width x height metres with the lower-left corner at the origin and `depth` everywhere. It is
/// sampled each metre, or more coarsely so that it has no more than 250,000 nodes.
[[nodiscard]] Seafloor flat(double width, double height, double depth);
/// Depth grows from `depth` at the west edge along east with the given slope, [0, 89] degrees.
[[nodiscard]] Seafloor tilted(double width, double height, double depth, Angle slope);
/// `depth_west` up to the middle of its width, then a near-vertical wall to `depth_east`.
[[nodiscard]] Seafloor stepped(double width, double height, double depth_west, double depth_east);

}  // namespace swathplan
