#pragma once

#include <string>
#include <vector>

#include "planners/job/job_line.h"
#include "planners/plan.h"
#include "planners/steering/connect.h"

namespace swathplan {

/// What a place must be like for a test, and what it is like on the seafloor as known.
struct PatchCondition {
  std::string what;    ///< "slope below the swath"
  std::string asks;    ///< "at most 2 degrees"
  std::string figure;  ///< "0.4 degrees"
  bool met = false;
};

/// One part of a patch test: roll, pitch, latency or yaw.
struct PatchTest {
  std::string name;
  std::string reason;      ///< why here, or why nowhere: one sentence without a full stop
  std::vector<int> lines;  ///< numbers of its passes in the route; some serve two tests
  std::vector<std::pair<Vec2, Vec2>> passes;  ///< their ends as sailed, local metres
  std::vector<double> speeds_mps;             ///< of the passes
  double depth_m = 0.0;                       ///< in the middle of the place
  std::vector<PatchCondition> conditions;
  [[nodiscard]] bool met() const;  ///< all conditions; false without any
};

/// The lines of a patch test in sailing order, and what they are for.
struct PatchTestPlan {
  std::vector<JobLine> lines;
  std::vector<PatchTest> tests;  ///< latency, pitch, roll, yaw
};

/// Finds places for a patch test on the seafloor as known and lays its lines:
/// - latency: a line up a slope or over an object, twice the same way at the vehicle's speed and at
///   half of it;
/// - pitch: the same line, both ways at the same speed;
/// - roll: a line on flat ground, both ways; the deeper the better;
/// - yaw: two parallel lines the same way, one on either side of a slope or object, which the outer
///   beams of both see.
/// Places are tried on a lattice over the water, in kPatchHeadings headings. A line is straight,
/// stays in the water and has room for the turns onto it. Where no place meets all conditions, the
/// best is taken and its conditions say so; a test without any ground for it has no lines.
[[nodiscard]] PatchTestPlan patch_test(const Ground& ground, const PlanOptions& options,
                                       const Connector& connector, int first_number);

inline constexpr int kPatchHeadings = 12;

}  // namespace swathplan
