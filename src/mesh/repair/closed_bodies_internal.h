#pragma once

#include <cstddef>

#include "mesh/seafloor.h"

namespace swathplan {

/// Takes the underside off every closed body, that is, a part without border edges. The underside
/// is the faces that look down when all faces look outwards, and walls that hang only from these.
/// Open parts stay as they are. Returns the number of faces taken. Indices must be in range and
/// faces must have area.
std::size_t drop_undersides(Seafloor& mesh);

}  // namespace swathplan
