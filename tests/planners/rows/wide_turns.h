#pragma once

#include "mesh/synthetic.h"
#include "planners/test_site.h"

namespace swathplan {

/// Flat ground with run-out on every side, and a vessel that turns wider than two rows are apart.
struct WideTurns {
  TestSite site{flat(600.0, 400.0, 10.0), kSafeDepthM};
  PlanOptions how = row_options(0.10, 1);
  WideTurns() {
    site.ground.survey_area = offset(site.ground.water, -80.0);
    how.vehicle.turn_radius_m = 25.0;
  }
};

}  // namespace swathplan
