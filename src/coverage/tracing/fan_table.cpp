#include "coverage/tracing/fan_table.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "coverage/tracing/ray_scene_internal.h"

namespace swathplan {

namespace {

// How far out from nadir beams of this side count, radians.
double counted(Angle side, double swath_share) {
  return side.rad() > 0.0 ? std::atan(swath_share * tan(side)) : side.rad();
}

std::vector<double> counted_angles(const Sonar& sonar, const FanAngles& fan, double swath_share) {
  std::vector<double> angles = beam_angles_rad(sonar, fan);
  if (swath_share < 1.0) {
    const double port = counted(fan.port, swath_share);
    const double starboard = counted(fan.starboard, swath_share);
    std::erase_if(angles, [&](double a) { return a < -port || a > starboard; });
  }
  return angles;
}

}  // namespace

FanTable::FanTable(const Sonar& sonar, const FanAngles& fan_angles, double swath_share)
    : fan(fan_angles) {
  const std::vector<double> angles = counted_angles(sonar, fan_angles, swath_share);
  beams = angles.size();
  padded = (beams + kPacket - 1) / kPacket * kPacket;
  sine.assign(padded, 0.0F);
  cosine.assign(padded, 1.0F);
  step.assign(padded, 0.0F);
  for (std::size_t i = 0; i < beams; ++i) {
    sine[i] = static_cast<float>(std::sin(angles[i]));
    cosine[i] = static_cast<float>(std::cos(angles[i]));
    if (i > 0) step[i] = static_cast<float>(angles[i] - angles[i - 1]);
  }
  if (beams > 1) step[0] = step[1];
  // Without a curve the rays end at the sonar's range by themselves.
  reach.assign(padded, std::numeric_limits<float>::max());
  for (std::size_t i = 0; i < beams && !sonar.coverage_curve.empty(); ++i) {
    reach[i] = static_cast<float>(reach_m(sonar, Angle::radians(angles[i])));
  }
  next_step.assign(padded, 0.0F);
  for (std::size_t i = 0; i < beams; ++i) next_step[i] = step[std::min(i + 1, beams - 1)];
}

const FanTable& FanTableCache::get(const FanAngles& fan) {
  if (last_ < tables_.size() && tables_[last_].fan == fan) return tables_[last_];
  for (last_ = 0; last_ < tables_.size(); ++last_) {
    if (tables_[last_].fan == fan) return tables_[last_];
  }
  if (tables_.size() < kKept) {
    tables_.emplace_back(*sonar_, fan, swath_share_);
    last_ = tables_.size() - 1;
  } else {
    last_ = oldest_;
    oldest_ = (oldest_ + 1) % kKept;
    tables_[last_] = FanTable(*sonar_, fan, swath_share_);
  }
  return tables_[last_];
}

}  // namespace swathplan
