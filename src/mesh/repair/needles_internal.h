#pragma once

#include <cstddef>

#include "mesh/seafloor.h"

namespace swathplan {

/// Takes out needles: faces whose three different corners lie on one line. The neighbour across the
/// longest edge is cut at the middle corner, so that the mesh stays closed there. No vertex moves.
/// Returns the number of faces taken. Indices must be in range, and the corners of a face must
/// differ.
std::size_t drop_needles(Seafloor& mesh);

}  // namespace swathplan
