#pragma once

#include <utility>

#include "mesh/survey_area.h"
#include "planners/plan.h"

namespace swathplan {

/// The shoalest depth that the test vessel may sail in, metres.
inline constexpr double kSafeDepthM = 0.8;

/// A seafloor with all that a planner needs. The survey area is the safe water. The boat may also
/// sail `run_out_m` beyond it, to turn there.
struct TestSite {
  explicit TestSite(Seafloor floor, double safe_depth_m = 0.0, double run_out_m = 0.0)
      : seafloor(std::move(floor)), depths(seafloor) {
    ground.seafloor = &seafloor;
    ground.depths = &depths;
    ground.survey_area =
        survey_area(seafloor, {.limit = {}, .no_go = {}, .safe_depth_m = safe_depth_m});
    ground.water = run_out_m > 0.0 ? offset(ground.survey_area, run_out_m) : ground.survey_area;
  }
  TestSite(const TestSite&) = delete;  // the ground points into the site
  TestSite& operator=(const TestSite&) = delete;

  Seafloor seafloor;
  DepthQuery depths;
  Ground ground;
};

/// Options of a planner: the scoring cell and the number of depth bands.
inline PlanOptions row_options(double resolution_m, int bands) {
  PlanOptions options;
  options.resolution_m = resolution_m;
  options.bands.count = bands;
  return options;
}

}  // namespace swathplan
