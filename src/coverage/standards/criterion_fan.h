#pragma once

#include <optional>

#include "coverage/standards/area_rate.h"
#include "coverage/standards/criteria.h"
#include "coverage/standards/uncertainty.h"

namespace swathplan {

/// The widest half-angle, up to `widest`, within which all soundings of level ground are accepted
/// by a criterion: TVU and THU within its limits and, where it asks for cubes, beams no farther
/// apart than its strikes allow. `depth_m` is below the sonar, which hangs `draft_m` below the
/// water. Empty if not even the beam straight down is accepted.
/// To a hundredth of a degree. @throws UsageError for a depth, draft or angle out of range.
[[nodiscard]] std::optional<Angle> accepted_half_angle(const Criterion& criterion,
                                                       const UncertaintyModel& model,
                                                       const Sonar& sonar, double depth_m,
                                                       double draft_m, double speed_mps,
                                                       Angle widest);

/// What the criterion makes of a question over level ground: its cell, its soundings, its strikes
/// along the course, and the fan that it accepts. Empty if it accepts none.
[[nodiscard]] std::optional<RateQuestion> asked_by(const Criterion& criterion,
                                                   const UncertaintyModel& model,
                                                   const RateQuestion& question, double depth_m,
                                                   double draft_m);

/// Depths between which a sonar is used, metres below it.
struct SonarDepths {
  double shoalest_m = 0.0, deepest_m = 0.0;
};

/// The sonar with a coverage curve that ends where soundings stop being accepted, and where its own
/// curve ends: what a planner may count on. Angles of the curve never rise with depth, so where a
/// criterion lets the fan open again deeper down, as S-44 Order 1a does at 40 m, it stays narrow.
/// Depths that are not above 0 count as the shoalest that is; where nothing is accepted the curve
/// ends at 0 degrees.
[[nodiscard]] Sonar narrowed_to(const Criterion& criterion, const UncertaintyModel& model,
                                const Sonar& sonar, const SonarDepths& depths, double draft_m,
                                double speed_mps);

}  // namespace swathplan
