#include "apps/site.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/seafloor/area_import.h"
#include "mesh/base/error.h"
#include "mesh/survey_area.h"

namespace swathplan {
namespace {

/// Areas under this are not worth a note, square metres.
constexpr double kWorthSaying = 1.0;

/// "3 pieces; the largest: 120 m2 about (x, y), ...", in the file's coordinates.
std::string pieces(Area area, const Frame& frame) {
  constexpr std::size_t kMostPlaces = 3;
  std::sort(area.begin(), area.end(),
            [](const Polygon& a, const Polygon& b) { return area_m2({a}) > area_m2({b}); });
  std::string text = fmt::format("{} piece{}{}", area.size(), area.size() == 1 ? "" : "s",
                                 area.size() == 1 ? ":" : "; the largest:");
  for (std::size_t i = 0; i < std::min(area.size(), kMostPlaces); ++i) {
    if (i > 0 && area_m2({area[i]}) < kWorthSaying) break;
    const Vec2 at = frame.to_file(inner_point({area[i]}));
    text += fmt::format("{} {:.0f} m2 about ({:.1f}, {:.1f})", i > 0 ? "," : "", area_m2({area[i]}),
                        at.x(), at.y());
  }
  return text;
}

/// Says what of the survey area the boat cannot sail in: how much, and where the largest pieces
/// are.
void note_cut_off(Site& site) {
  const Area cut = subtract(site.survey_area, site.water);
  site.cut_off_m2 = area_m2(cut);
  if (site.cut_off_m2 < kWorthSaying) return;
  site.notes.push_back(fmt::format(
      "{:.0f} m2 of the survey area ({:.2f} %) lie outside the boat's safe water, in {}. They "
      "count in the coverage all the same",
      site.cut_off_m2, 100.0 * site.cut_off_m2 / area_m2(site.survey_area),
      pieces(cut, site.seafloor().frame)));
}

/// Says what of the water is too shoal to be surveyed with this vehicle.
void note_shoals(Site& site, const SurveyAreaOptions& bounds) {
  SurveyAreaOptions all = bounds;
  all.safe_depth_m = 0.0;
  const Area shoal = subtract(survey_area(site.seafloor(), all), site.survey_area);
  const double shoal_m2 = area_m2(shoal);
  if (shoal_m2 < kWorthSaying) return;
  site.notes.push_back(fmt::format(
      "{:.0f} m2 of water are shoaler than {:.2f} m (draft, squat and margin) and not part of the "
      "survey area, in {}. They do not count in the coverage",
      shoal_m2, bounds.safe_depth_m, pieces(shoal, site.seafloor().frame)));
}

/// The area with the name of its file in what is wrong with it.
Area limited_area(const Seafloor& seafloor, const SurveyAreaOptions& bounds,
                  const std::filesystem::path& file) {
  try {
    return survey_area(seafloor, bounds);
  } catch (const InvalidInput& e) {
    throw InvalidInput(fmt::format("--area '{}': {}", file.string(), e.what()));
  }
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
  site->survey_area = bounds.limit ? limited_area(site->seafloor(), bounds, options.area) : deep;
  note_shoals(*site, bounds);
  note_cut_off(*site);
  return site;
}

}  // namespace swathplan
