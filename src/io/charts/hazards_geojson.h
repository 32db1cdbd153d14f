#pragma once

#include <filesystem>

#include "io/charts/hazards.h"

namespace swathplan {

/// The hazards with their room, as GeoJSON: each a MultiPolygon with layer, name, buffer_m,
/// accuracy_m and what says so, and whether it is to be seen.
[[nodiscard]] std::string hazards_geojson(const Hazards& hazards, const Frame& frame);

/// Writes it as 'hazards.geojson' into the folder. @throws InvalidInput if that fails.
void write_hazards_geojson(const std::filesystem::path& folder, const Hazards& hazards,
                           const Frame& frame);

}  // namespace swathplan
