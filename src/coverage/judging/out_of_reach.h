#pragma once

#include "coverage/ground.h"
#include "coverage/route/sonar.h"
#include "coverage/route/vehicle.h"
#include "coverage/standards/judge.h"

namespace swathplan {

/// Takes back the asked cells that hold no sounding and that the sonar can see from no place in
/// safe water: quays, moles or shoals stand before them, or all water near them is unsafe.
/// Looked for in kAzimuths directions and each kAngleStepDeg of the widest fan's half.
/// @return their area, square metres
double leave_out_of_reach(std::vector<JudgedGrid>& grids, const Ground& ground, const Sonar& sonar,
                          const Vehicle& vehicle);
inline constexpr int kAzimuths = 32;
inline constexpr double kAngleStepDeg = 5.0;

}  // namespace swathplan
