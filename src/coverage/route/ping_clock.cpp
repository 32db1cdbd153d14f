#include "coverage/route/ping_clock.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "mesh/base/error.h"

namespace swathplan {

namespace {

double shortest_cycle_s(const Sonar& sonar) { return 1.0 / sonar.max_ping_rate_hz; }

double sound_cycle_s(const PingTiming& timing, double range_m) {
  return 2.0 * range_m / (kListeningShare * timing.sound_speed_mps);
}

bool above_zero(double value) { return value > 0.0 && std::isfinite(value); }

}  // namespace

double ping_interval_s(const Sonar& sonar, const PingTiming& timing, double range_m) {
  const double cycle = std::max(shortest_cycle_s(sonar), sound_cycle_s(timing, range_m));
  return timing.thinning * (sonar.dual_swath ? 0.5 * cycle : cycle);
}

double most_cycles_hz(const PingTiming& timing, double range_m) {
  return 1.0 / sound_cycle_s(timing, range_m);
}

bool sound_binds(const Sonar& sonar, const PingTiming& timing, double range_m) {
  return sound_cycle_s(timing, range_m) > shortest_cycle_s(sonar);
}

double ping_spacing_m(const Sonar& sonar, const PingTiming& timing, double depth_m,
                      Angle half_angle, double speed_mps) {
  if (timing.spacing_m) return timing.thinning * *timing.spacing_m;
  const double range = std::min(std::max(depth_m, 0.0) / cos(half_angle), sonar.max_range_m);
  return speed_mps * ping_interval_s(sonar, timing, range);
}

void check(const Sonar& sonar, const PingTiming& timing) {
  if (timing.spacing_m && !above_zero(*timing.spacing_m)) {
    throw UsageError("ping spacing", fmt::format("{} m", *timing.spacing_m),
                     "must be greater than 0");
  }
  if (!above_zero(timing.sound_speed_mps)) {
    throw UsageError("sound speed", fmt::format("{} m/s", timing.sound_speed_mps),
                     "must be greater than 0");
  }
  if (!above_zero(sonar.max_ping_rate_hz)) {
    throw UsageError("ping rate", fmt::format("{} Hz", sonar.max_ping_rate_hz),
                     "must be greater than 0");
  }
  if (!(timing.thinning >= 1.0) || !std::isfinite(timing.thinning)) {
    throw UsageError(fmt::format("thinning of pings = {}; must be 1 or more", timing.thinning));
  }
}

}  // namespace swathplan
