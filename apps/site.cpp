#include "apps/site.h"

#include "io/area_import.h"
#include "mesh/survey_area.h"

namespace swathplan {

std::unique_ptr<Site> load_site(const SiteOptions& options, const Vehicle& vehicle) {
  auto site = std::make_unique<Site>();
  site->imported = import_seafloor(options.file, import_options(options));
  site->depths = std::make_unique<DepthQuery>(site->seafloor());
  const Frame& frame = site->seafloor().frame;
  SurveyAreaOptions bounds;
  bounds.safe_depth_m = safe_depth_m(vehicle);
  if (!options.no_go.empty()) site->no_go = bounds.no_go = import_area(options.no_go, frame);
  site->water = survey_area(site->seafloor(), bounds);
  if (!options.area.empty()) {
    bounds.limit = import_area(options.area, frame, extent(site->seafloor()));
  }
  site->survey_area = bounds.limit ? survey_area(site->seafloor(), bounds) : site->water;
  return site;
}

}  // namespace swathplan
