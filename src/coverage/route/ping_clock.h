#pragma once

#include <optional>

#include "coverage/route/sonar.h"

namespace swathplan {

/// When a sonar pings.
struct PingTiming {
  /// One ping each so many metres of path. Empty: by the clock, as fast as sonar and sound allow.
  std::optional<double> spacing_m = 0.10;
  double sound_speed_mps = 1500.0;
  /// Only each so many-th of a ping is sailed, >= 1: simulations of a search leave some out.
  double thinning = 1.0;
};

/// The share of a ping's cycle that is left for listening; the rest is the sonar's own work.
inline constexpr double kListeningShare = 0.9;

/// Seconds from a ping to the next one. The sonar waits for its farthest sounding at `range_m`
/// (slant): T = max(1 / largest ping rate, 2 range / (0.9 sound speed)). A sonar with two fans a
/// cycle pings twice in T. Of `timing` the spacing plays no part.
[[nodiscard]] double ping_interval_s(const Sonar& sonar, const PingTiming& timing, double range_m);

/// Cycles a second that sound allows at most to a range (slant) and back.
[[nodiscard]] double most_cycles_hz(const PingTiming& timing, double range_m);

/// Whether the way of the sound sets the interval, and not the sonar's largest ping rate.
[[nodiscard]] bool sound_binds(const Sonar& sonar, const PingTiming& timing, double range_m);

/// Metres between two pings over level ground `depth_m` below the sonar, sailed at `speed_mps` with
/// a fan of `half_angle` to its wider side.
[[nodiscard]] double ping_spacing_m(const Sonar& sonar, const PingTiming& timing, double depth_m,
                                    Angle half_angle, double speed_mps);

/// @throws UsageError that names what cannot be: a spacing, sound speed or ping rate that is not
///   above 0, a thinning below 1.
void check(const Sonar& sonar, const PingTiming& timing);

}  // namespace swathplan
