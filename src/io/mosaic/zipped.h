#pragma once

#include <vector>

#include "mesh/seafloor.h"

namespace swathplan {

/// Two surfaces made one.
struct Zipped {
  Seafloor seafloor;
  double upper_m2 = 0.0, lower_m2 = 0.0;  ///< of the result, from each
  std::vector<double> steps_m;            ///< lower less upper depth, at the upper's border
};

/// Joins two surfaces in one frame. Guarantees: (1) every face of `upper` stays; (2) faces of
/// `lower` that neither meet nor cover any of it stay; (3) the strip between, and gaps between the
/// two that no edge longer than `bridge_m` is needed for, are filled with triangles between their
/// vertices, so that there is no slit for a ray or a boat's clearance; (4) no ground is made where
/// neither has any, gaps aside. O(n log n) in the vertices of the borders, O(n) in the faces.
[[nodiscard]] Zipped zipped(const Seafloor& upper, const Seafloor& lower, double bridge_m);

}  // namespace swathplan
