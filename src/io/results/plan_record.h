#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "coverage/route/ping_clock.h"
#include "coverage/route/violations.h"
#include "coverage/water/leg_water.h"
#include "io/charts/hazards.h"
#include "planners/job/whole_job.h"
#include "planners/plan.h"

namespace swathplan {

/// A depth region as a plan used it; its id is its place in PlanRecord::regions.
struct PlanRegion {
  int band = 0;
  std::size_t faces = 0;
  double area_m2 = 0.0;
  double min_depth_m = 0.0, mean_depth_m = 0.0, max_depth_m = 0.0;
  FanAngles fan;  ///< half-angles at the region's mean depth
  Area outline;   ///< local metres
};

/// A gate as a plan used it; local metres.
struct PlanGate {
  std::pair<Vec2, Vec2> edge;
  std::uint32_t region_a = 0, region_b = 0;
  Angle slope;
};

/// A stretch that must not be sailed as it is drawn.
struct PlanViolation {
  Violation violation;
  std::string leg;  ///< kind of the leg that it begins in
  std::string reason;
};
[[nodiscard]] std::vector<PlanViolation> plan_violations(const Route& route, const Vehicle& vehicle,
                                                         const Area& water, const Area& land = {});

/// What is told of a plan: plan.json and the report are both written from it, so they agree.
struct PlanRecord {
  std::string planner;  ///< name that programs know it by
  std::string label;    ///< ... and that people read
  std::vector<double> band_limits_m;
  std::vector<PlanRegion> regions;
  std::vector<PlanGate> gates;
  std::vector<std::pair<Vec2, Vec2>> blocked_edges;  ///< local metres
  Sonar sonar;
  Vehicle vehicle;
  PingTiming pings;              ///< that it was scored by
  std::vector<Outcome> choices;  ///< that the planner had, and which it took and why
  std::size_t chosen = 0;
  std::string chosen_why;
  std::optional<Angle> heading;  ///< of straight lines in the frame, where all share one
  Angle grid_north;              ///< true azimuth of the frame's north
  std::vector<PlanViolation> violations;
  std::vector<LegWater> water;         ///< of the route's legs, at the tide of the time
  Hazards hazards;                     ///< that the boat keeps off
  std::vector<std::string> notes;      ///< one sentence each, for people
  std::optional<JobSummary> job;       ///< where more than the main scheme was asked for
  std::vector<std::string> job_files;  ///< routes of its sorties, where it is divided
};

/// The record of a plan for this sonar and vehicle in safe `water`, beside known `land`; planner
/// and label are left empty.
[[nodiscard]] PlanRecord plan_record(const Plan& plan, const Sonar& sonar, const Vehicle& vehicle,
                                     const Area& water, const Area& land = {});

}  // namespace swathplan
