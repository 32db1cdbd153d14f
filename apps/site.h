#pragma once

#include <memory>

#include "apps/survey.h"

namespace swathplan {

/// A loaded site: the seafloor, where to survey and where the boat may be.
struct Site {
  ImportedSeafloor imported;
  std::unique_ptr<DepthQuery> depths;
  Area survey_area;  ///< cells that count
  Area water;        ///< safe for the boat: deep enough, clear of walls and no-go
  Area no_go;
  double cut_off_m2 = 0.0;         ///< of the survey area outside the safe water
  std::vector<std::string> notes;  ///< one sentence each, for people

  [[nodiscard]] const Seafloor& seafloor() const { return imported.seafloor; }
  /// What routes of the site are planned and scored on. Without a scene planners cannot simulate.
  [[nodiscard]] Ground ground(const RayScene* scene) const {
    return {&imported.seafloor, depths.get(), survey_area, water, scene};
  }
};

/// Imports the seafloor and the polygons and derives the areas for a vehicle.
/// @throws InvalidInput, UsageError as the importers do.
[[nodiscard]] std::unique_ptr<Site> load_site(const SiteOptions& options, const Vehicle& vehicle);

}  // namespace swathplan
