#pragma once

#include <optional>

#include "mesh/plane/polygons.h"
#include "mesh/seafloor.h"

namespace swathplan {

/// What bounds the survey besides the data itself.
struct SurveyAreaOptions {
  std::optional<Area> limit;  ///< survey only inside this; empty: wherever there is data
  Area no_go;                 ///< never inside this
  double safe_depth_m = 0.0;  ///< shoalest depth that counts (draft + under-keel margin), >= 0
};

/// Outline of the seafloor in plan with its holes: the boundary loops of the mesh, united.
[[nodiscard]] Area outline(const Seafloor& seafloor);

/// Survey area = outline of the seafloor with its holes, inside `limit`, less no-go, less water
/// shoaler than `safe_depth_m`. May have several separate parts, largest first.
/// @throws InvalidInput if nothing is left, saying which of the conditions took the last of it.
[[nodiscard]] Area survey_area(const Seafloor& seafloor, const SurveyAreaOptions& options);

}  // namespace swathplan
