#include "apps/site_command.h"

#include <algorithm>

#include "planners/wording.h"

namespace swathplan {

OptionTable site_rows(SiteCommand& command) {
  return joined(
      {site_options(command.site), covered_options(command.covered), water_options(command.water)});
}

Provenance site_provenance(const std::string& name, const SiteCommand& command,
                           const Survey& survey, const std::string& input_hash) {
  Provenance provenance = provenance_of(name, command.site, input_hash);
  SiteCommand typed = command;
  record(provenance, covered_options(typed.covered));
  record(provenance, water_options(typed.water));
  record_scoring(provenance, typed.survey, survey);
  return provenance;
}

std::unique_ptr<Site> site_of(const SiteCommand& command, const Survey& survey,
                              TerminalWatch& watch) {
  auto site = load_site(command.site, survey.vehicle, Watch(watch));
  take_tide(*site, command.water, command.site);
  take_off_covered(*site, command.covered, survey, command.site.layers);
  watch.rest();
  return site;
}

FanAngles fan_where_none(const Survey& survey, const Site& site) {
  const double mean = depth_range(site.seafloor()).mean;
  if (survey.planning.rows.swath_by == SwathBy::footprint) {
    return fan_for_depth(survey.planning, mean);
  }
  const Angle half = widest_half_angle(survey.sonar, std::max(0.0, mean - survey.vehicle.draft_m));
  return {half, half};
}

}  // namespace swathplan
