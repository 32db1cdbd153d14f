#include "apps/site.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/area_import.h"
#include "mesh/error.h"
#include "mesh/survey_area.h"

namespace swathplan {
namespace {

/// Says what of the survey area the boat cannot sail in: how much, and where the largest pieces
/// are.
void note_cut_off(Site& site) {
  constexpr double kWorthSaying = 1.0;  // square metres
  constexpr std::size_t kMostPlaces = 3;
  Area cut = subtract(site.survey_area, site.water);
  const double cut_m2 = area_m2(cut);
  site.cut_off_m2 = cut_m2;
  if (cut_m2 < kWorthSaying) return;
  std::sort(cut.begin(), cut.end(),
            [](const Polygon& a, const Polygon& b) { return area_m2({a}) > area_m2({b}); });
  std::string places;
  for (std::size_t i = 0; i < std::min(cut.size(), kMostPlaces); ++i) {
    const Vec2 at = site.seafloor().frame.to_file(inner_point({cut[i]}));
    places += fmt::format("{}{:.0f} m2 about ({:.1f}, {:.1f})", i > 0 ? ", " : "",
                          area_m2({cut[i]}), at.x(), at.y());
  }
  site.notes.push_back(fmt::format(
      "{:.0f} m2 of the survey area ({:.2f} %) lie outside the boat's safe water, in {} "
      "pieces; the largest: {}. They count in the coverage all the same",
      cut_m2, 100.0 * cut_m2 / area_m2(site.survey_area), cut.size(), places));
}

/// The strip along the data's outer edge, `margin_m` wide: holes in the data are land.
Area beyond_the_edge(const Seafloor& seafloor, double margin_m) {
  Area filled;
  for (const Polygon& polygon : outline(seafloor)) filled.push_back({polygon.outer, {}});
  return subtract(offset(filled, margin_m), filled);
}

}  // namespace

std::unique_ptr<Site> load_site(const SiteOptions& options, const Vehicle& vehicle) {
  auto site = std::make_unique<Site>();
  site->imported = import_seafloor(options.file, import_options(options));
  site->depths = std::make_unique<DepthQuery>(site->seafloor());
  const Frame& frame = site->seafloor().frame;
  SurveyAreaOptions bounds;
  bounds.safe_depth_m = safe_depth_m(vehicle);
  if (!options.no_go.empty()) site->no_go = bounds.no_go = import_area(options.no_go, frame);
  const Area deep = survey_area(site->seafloor(), bounds);
  if (!(options.run_out_margin_m >= 0.0)) {
    throw UsageError(
        fmt::format("--run-out-margin {:g}; must be 0 metres or more", options.run_out_margin_m));
  }
  Area sailable = deep;
  if (options.run_out_margin_m > 0.0) {
    const Area strip = beyond_the_edge(site->seafloor(), options.run_out_margin_m);
    sailable = subtract(unite(deep, strip), site->no_go);
  }
  site->water = offset(sailable, -vehicle.clearance_m);
  if (site->water.empty()) {
    throw InvalidInput(
        fmt::format("no water is left {:g} m off walls, shoals and no-go areas; lower --clearance",
                    vehicle.clearance_m));
  }
  if (!options.area.empty()) {
    bounds.limit = import_area(options.area, frame, extent(site->seafloor()));
  }
  site->survey_area = bounds.limit ? survey_area(site->seafloor(), bounds) : deep;
  note_cut_off(*site);
  return site;
}

}  // namespace swathplan
