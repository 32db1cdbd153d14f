#pragma once

#include "mesh/survey_area.h"
#include "mesh/synthetic.h"
#include "planners/plan.h"

namespace swathplan::test {

/// Two basins, 25 m wide, north of a mole's root: a U that is open to the north.
struct TwoBasins {
  TwoBasins() : seafloor(flat(60.0, 60.0, 6.0)), depths(seafloor), scene(seafloor, Nodata::wall) {
    const Ring mole{{25.0, 30.0}, {35.0, 30.0}, {35.0, 61.0}, {25.0, 61.0}};
    ground.seafloor = &seafloor;
    ground.depths = &depths;
    ground.scene = &scene;
    ground.survey_area = ground.water =
        survey_area(seafloor, {.limit = {}, .no_go = {{mole, {}}}, .safe_depth_m = 0.0});
    options.resolution_m = 0.25;
  }
  Seafloor seafloor;
  DepthQuery depths;
  RayScene scene;
  Ground ground;
  PlanOptions options;
};

}  // namespace swathplan::test
