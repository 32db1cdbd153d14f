// Plans the synthetic saddle with back-and-forth and scores the route.
#include <cstdio>

#include "coverage/score.h"
#include "mesh/survey_area.h"
#include "mesh/synthetic.h"
#include "planners/rows/back_and_forth.h"

int main() {
  const swathplan::Seafloor seafloor = swathplan::saddle();
  const swathplan::DepthQuery depths(seafloor);
  const swathplan::RayScene scene(seafloor, swathplan::Nodata::wall);
  const swathplan::Area area = swathplan::survey_area(seafloor, {});
  const swathplan::Ground ground{&seafloor, &depths, area, area, &scene};
  const swathplan::PlanOptions how{.sonar = {}, .vehicle = {}, .resolution_m = 0.5};
  const swathplan::Plan plan = swathplan::plan_back_and_forth(ground, how);
  const auto scored =
      swathplan::score(plan.route, ground, how.sonar, how.vehicle, {.resolution_m = 0.5});
  std::printf("%.1f %% of %.0f m2\n", scored.score.all.hit_pct, scored.score.survey_area_m2);
  return scored.score.all.hit_pct > 10.0 ? 0 : 1;
}
