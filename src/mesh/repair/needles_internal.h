#pragma once

#include <cstddef>

#include "mesh/seafloor.h"

namespace swathplan {

/// Takes out faces whose three different corners lie on one line. The neighbour across the longest
/// edge is cut at the middle corner, so that the mesh stays closed there and no vertex moves.
/// Returns the number of faces taken. Indices must be in range and corners of a face differ.
std::size_t drop_needles(Seafloor& mesh);

}  // namespace swathplan
