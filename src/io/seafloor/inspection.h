#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "io/seafloor/import_seafloor.h"

namespace swathplan {

/// First settings for a survey, derived from the depths.
struct SuggestedSettings {
  double resolution_m = 0.1;      ///< cell that a 256-beam fan fills without gaps at the mean depth
  double swath_m = 25.6;          ///< that a fan of 100 degrees sweeps at the mean depth
  double line_spacing_m = 23.04;  ///< of such swaths with 10 % overlap
  int depth_bands = 1;
  double safe_depth_m = 1.0;  ///< shoalest depth to plan in
  std::size_t lines = 1;      ///< parallel lines, roughly
  double line_km = 0.0;       ///< their length together, roughly
};
[[nodiscard]] SuggestedSettings suggest_settings(const Seafloor& seafloor);

/// Warnings about data that probably need another option or a better mesh: depths in another unit,
/// several parts, non-manifold edges, hardly any relief, a very large extent.
[[nodiscard]] std::vector<std::string> warnings_of(const ImportedSeafloor& imported);

/// What `swathplan inspect` prints: a text for people, or the same as JSON.
[[nodiscard]] std::string inspection_text(const ImportedSeafloor& imported);
[[nodiscard]] nlohmann::json inspection_json(const ImportedSeafloor& imported);

}  // namespace swathplan
