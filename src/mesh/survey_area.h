#pragma once

#include <optional>

#include "mesh/plane/polygons.h"
#include "mesh/seafloor.h"

namespace swathplan {

/// What limits the survey, beside the data themselves.
struct SurveyAreaOptions {
  std::optional<Area> limit;  ///< survey only inside this; empty: wherever there is data
  Area no_go;                 ///< never inside this
  double safe_depth_m = 0.0;  ///< shoalest depth that counts, >= 0; safe_depth_m() of vehicle.h
};

/// Outline of the seafloor in plan, with its holes: the border loops of the mesh, united.
[[nodiscard]] Area outline(const Seafloor& seafloor);

/// The outline of what lies above `z` (metres, local frame): at the water level, land.
[[nodiscard]] Area above_level(const Seafloor& seafloor, double z);

/// The survey area: the outline of the seafloor inside `limit`, less no-go, less water shoaler than
/// `safe_depth_m`. It may have several separate parts, the largest first.
/// @throws InvalidInput if nothing is left; the message says which condition took the last of it.
[[nodiscard]] Area survey_area(const Seafloor& seafloor, const SurveyAreaOptions& options);

/// What the safe depth takes off the survey area: ground inside `limit` and outside no-go that is
/// shoaler. Empty without a safe depth.
[[nodiscard]] Area shoal_ground(const Seafloor& seafloor, const SurveyAreaOptions& options);

}  // namespace swathplan
