#pragma once

#include <vector>

#include "mesh/synthetic.h"
#include "planners/job/job_line.h"
#include "planners/job/job_ways.h"
#include "planners/rows/route_builder.h"
#include "planners/test_site.h"

namespace swathplan {

/// Open flat water of 600 x 400 m, 20 m deep, with lines that run north at even eastings.
struct JobSite {
  explicit JobSite(Seafloor floor = flat(600, 400, 20))
      : site(std::move(floor)),
        connector(connector_for(site.ground, how)),
        ways(site.ground, how) {}

  [[nodiscard]] JobLine northward(double x, int number, double from_y = 100.0,
                                  double to_y = 300.0) const {
    return {line_waypoints({{x, from_y}, {x, to_y}}, number, fan, how), {}};
  }
  /// Back and forth at this spacing, each with its join, as a planner hands them out.
  [[nodiscard]] Route rows(int count, double spacing_m = 25.0) const {
    RouteBuilder builder(site.ground, how, connector);
    for (int k = 0; k < count; ++k) {
      const JobLine line = northward(50.0 + spacing_m * k, k + 1);
      builder.add_line(k % 2 == 0 ? line.points : backwards(line).points);
    }
    return builder.finish();
  }

  TestSite site;
  PlanOptions how = row_options(0.10, 1);
  FanAngles fan{Angle::degrees(30), Angle::degrees(35)};
  Connector connector;
  JobWays ways;
};

}  // namespace swathplan
