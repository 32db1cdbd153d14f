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

}  // namespace swathplan
