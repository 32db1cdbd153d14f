#pragma once

#include <memory>
#include <string>

#include "apps/planning.h"
#include "apps/site.h"
#include "apps/survey.h"
#include "apps/watch/terminal_watch.h"

namespace swathplan {

/// What every command that plans or scores over a site takes.
struct SiteCommand {
  SiteOptions site;
  CoveredChoice covered;
  WaterChoice water;
  SurveyOptions survey;
  OutputOptions output;
};

/// The rows of the site and of what is known of it. A command adds its own and those of scoring.
[[nodiscard]] OptionTable site_rows(SiteCommand& command);

/// What made an output, with the rows of the site and of scoring; a command records its own.
[[nodiscard]] Provenance site_provenance(const std::string& name, const SiteCommand& command,
                                         const Survey& survey, const std::string& input_hash);

/// The site with its tide and without what was surveyed before.
/// @throws InvalidInput, UsageError as load_site, take_tide and take_off_covered do.
[[nodiscard]] std::unique_ptr<Site> site_of(const SiteCommand& command, const Survey& survey,
                                            TerminalWatch& watch);

/// The fan of a route that holds none: as wide as the sonar sees at the mean depth, or the one that
/// sweeps W there.
[[nodiscard]] FanAngles fan_where_none(const Survey& survey, const Site& site);

}  // namespace swathplan
