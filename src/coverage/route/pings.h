#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "coverage/route/route.h"

namespace swathplan {

/// Where the boat is when it pings, and how its fan hangs. Ideal tracking unless noise is given.
struct Ping {
  Vec2 position = Vec2::Zero();  ///< local metres
  Vec2 course = Vec2::UnitY();   ///< unit vector; the fan plane stands at right angles to it
  Angle roll;                    ///< starboard side down positive
  double heave_m = 0.0;          ///< up positive
  FanAngles fan;
  std::uint32_t leg = 0;  ///< index into legs(route)
  bool log = true;
};

/// Departures from ideal tracking, seeded: Gaussian (first-order Gauss-Markov over distance, so
/// that a boat wanders), stationary from the first ping. Each departure draws its own numbers, so
/// that switching one on leaves the others as they were.
struct TrackNoise {
  double lateral_sigma_m = 0.0;
  Angle heading_sigma, roll_sigma;
  double heave_sigma_m = 0.0;
  double correlation_length_m = 20.0;  ///< distance over which errors forget themselves
  std::uint64_t seed = 1;
  [[nodiscard]] bool any() const {
    return lateral_sigma_m > 0 || heading_sigma.rad() > 0 || roll_sigma.rad() > 0 ||
           heave_sigma_m > 0;
  }
};

/// Walks along the route and yields its pings in order, a block at a time, so that a long route
/// needs little memory. One ping each `spacing_m` of path from the first waypoint, on through
/// waypoints without restart; the course is that of the segment being sailed; a ping on a waypoint
/// belongs to the next segment; legs with the sonar off give none (but the count runs on).
/// A waypoint counts as reached kPathDust before it, so that rounding neither drops the last ping
/// nor moves one to the wrong segment. Keeps a reference: the route must outlive it.
class PingWalker {
 public:
  static constexpr double kPathDust = 1e-6;  ///< metres of path
  /// @throws UsageError for a spacing or correlation length that is not > 0, or a negative sigma.
  PingWalker(const Route& route, double spacing_m, const TrackNoise& noise);
  /// Fills `block` with up to `count` next pings; false when none is left.
  bool next(std::size_t count, std::vector<Ping>& block);
  /// Share of the route's length walked so far, [0, 1].
  [[nodiscard]] double progress() const;

 private:
  void step_noise();
  void push(std::vector<Ping>& block) const;

  const Route* route_;
  double spacing_;
  TrackNoise noise_;
  std::vector<std::uint32_t> leg_of_segment_;
  std::size_t segment_ = 0;
  std::uint64_t index_ = 0;
  double segment_start_ = 0.0, segment_length_ = 0.0, total_ = 0.0;
  std::mt19937_64 random_;
  std::array<double, 4> noise_state_{};  // lateral, heading, roll, heave in units of their sigmas
};

}  // namespace swathplan
