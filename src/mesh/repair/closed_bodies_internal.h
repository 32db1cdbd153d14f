#pragma once

#include <cstddef>

#include "mesh/seafloor.h"

namespace swathplan {

/// Takes the underside off every closed body (a part without border edges): faces that look down
/// when the body is turned outside out, and walls that then hang from nothing but them.
/// Open parts stay as they are. Returns the number
/// of faces taken. Indices must be in range and faces must have area.
std::size_t drop_undersides(Seafloor& mesh);

}  // namespace swathplan
