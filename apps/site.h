#pragma once

#include <memory>

#include "apps/survey.h"
#include "coverage/covered/covered_before.h"
#include "coverage/water/leg_water.h"
#include "io/charts/hazards.h"
#include "io/seafloor/area_import.h"
#include "mesh/base/watch.h"

namespace swathplan {

/// A loaded site: the seafloor, where to survey and where the boat may be.
struct Site {
  ImportedSeafloor imported;
  std::unique_ptr<DepthQuery> depths;
  Area survey_area;  ///< cells that count; of a survey that is covered in part, the rest
  Area water;        ///< safe for the boat: deep enough, clear of walls and no-go
  Area no_go;
  Area land;                       ///< known: above the water in the data, and no_go
  Area keep_off;                   ///< not sailed over, but its cells count
  Hazards hazards;                 ///< near the survey; part of no_go or of keep_off
  std::vector<AreaPart> parts;     ///< the polygons that were asked for, where there are several
  double cut_off_m2 = 0.0;         ///< of the survey area outside the safe water
  std::vector<std::string> notes;  ///< one sentence each, for people
  /// Where a part was surveyed before (take_off_covered): the cells of the whole, and what is
  /// left of them.
  std::shared_ptr<const CoveredBefore> covered;
  Rest rest;
  std::shared_ptr<const Tide> tide;  ///< heights above the level that depths count from
  std::optional<double> departure_s;

  [[nodiscard]] bool is_timed() const { return tide != nullptr || departure_s.has_value(); }

  [[nodiscard]] const Seafloor& seafloor() const { return imported.seafloor; }
  /// What routes of the site are planned and scored on. Without a scene planners cannot simulate.
  [[nodiscard]] Ground ground(const RayScene* scene) const {
    Ground ground{&imported.seafloor, depths.get(), survey_area, water, scene};
    ground.land = land;
    if (covered) ground.lattice = covered->grid().origin();
    return ground;
  }
};

/// Which of the area's polygons the route has no survey line in, by name or place and with what of
/// them can be surveyed: one sentence, empty where each has one.
[[nodiscard]] std::string unserved_note(const Site& site, const Route& route);

/// Refuses a given route that nowhere comes near the data: it is in another CRS or of another
/// place.
/// @throws InvalidInput that names its file.
void check_meets_data(const Route& route, const Site& site, const std::filesystem::path& file);

/// Imports the seafloor: one file, or a mosaic of several.
/// @throws InvalidInput, UsageError as the importers do.
[[nodiscard]] ImportedSeafloor imported_seafloor(const SiteOptions& options);

/// Imports the seafloor and the polygons and derives the areas for a vehicle.
/// @throws InvalidInput, UsageError as the importers do.
[[nodiscard]] std::unique_ptr<Site> load_site(const SiteOptions& options, const Vehicle& vehicle,
                                              const Watch& watch = {});

/// Takes tide and departure, with notes on them. @throws InvalidInput if the table cannot be used
/// (io/water/tide_import.h); UsageError for a departure that is no time or outside the table.
void take_tide(Site& site, const WaterChoice& choice, const SiteOptions& options);

/// Takes what was surveyed before off the site's survey area, with notes of each file and of what
/// is left. Without files the site stays as it is.
/// @throws InvalidInput if a file cannot be used (io/covered/import_covered.h), or nothing is left.
void take_off_covered(Site& site, const CoveredChoice& choice, const Survey& survey,
                      const std::vector<std::string>& layers);

}  // namespace swathplan
