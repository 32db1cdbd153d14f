#pragma once

#include <cmath>

#include "mesh/base/angle.h"

namespace swathplan {

/// A full fan of 120 degrees, and the tangent of half of it.
inline const Angle kOpening = Angle::degrees(120.0);
inline const double kTan = std::sqrt(3.0);

}  // namespace swathplan
