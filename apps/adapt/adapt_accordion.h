#pragma once

#include <optional>
#include <string>

#include "apps/adapt/adapt_common.h"
#include "planners/adaptive/accordion_scan.h"

// What the modes of `adapt accordion` share.
namespace swathplan {

struct AccordionCommand {
  SiteOptions site;
  BoxOptions box;
  AdaptOutput output;
  AccordionOptions planner{.width_m = 1000.0, .length_m = 500.0};
  std::string rule = "basic";
  std::optional<double> threshold, clearance_m;
  double p_obj = 0.2;
  int objects = 12;
  SideScanSonar sonar;
  CostMapOptions cost;
  bool no_gap_filler = false;
  int missions = 100;
  double pixel_m = 0.1, row_m = 0.2;
};

/// Costs of abstract worlds are 0.1 and 1.
inline constexpr double kWorldThreshold = 0.5;

/// @throws UsageError if the name is none.
[[nodiscard]] AccordionRule accordion_rule(const std::string& name);
/// Checked options; threshold and clearance are those given, where they are not asked for.
[[nodiscard]] AccordionOptions accordion_of(const AccordionCommand& command,
                                            double default_threshold,
                                            double default_clearance = 0.0);

/// Monte Carlo over alpha and p_obj.
void study_accordion(const AccordionCommand& command);

}  // namespace swathplan
