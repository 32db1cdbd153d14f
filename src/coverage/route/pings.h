#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <random>
#include <vector>

#include "coverage/route/ping_clock.h"
#include "coverage/route/route.h"
#include "coverage/route/sonar.h"
#include "mesh/plane/box.h"

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
  double speed_mps = 0.0;  ///< of the row that is sailed
  double path_m = 0.0;     ///< sailed so far
};

/// Departures from ideal tracking. Each is a first-order Gauss-Markov process over distance, so the
/// boat wanders. Its spread is the same from the first ping on. Each departure draws its own
/// numbers, so that switching one on leaves the others as they were. The seed fixes them all.
struct TrackNoise {
  double lateral_sigma_m = 0.0;
  Angle heading_sigma, roll_sigma;
  double heave_sigma_m = 0.0;
  /// Steady departures, in addition: the whole route lies so far to starboard and is sailed so far
  /// clockwise of its courses.
  double lateral_offset_m = 0.0;
  Angle heading_offset;
  double correlation_length_m = 20.0;  ///< distance over which errors fall to 1/e of their effect
  std::uint64_t seed = 1;
  [[nodiscard]] bool any() const {
    return lateral_sigma_m > 0 || heading_sigma.rad() > 0 || roll_sigma.rad() > 0 ||
           heave_sigma_m > 0 || lateral_offset_m != 0.0 || heading_offset.rad() != 0.0;
  }
};

/// Slant range of the farthest sounding of a ping, metres; 0 for a ping without one.
using FarthestSounding = std::function<double(const Ping&)>;

/// What a walk along a route found of its pings. Legs with the sonar off do not count.
struct PingFigures {
  std::uint64_t intervals = 0;  ///< from a ping to the next one
  double mean_spacing_m = 0.0;  ///< path between them
  double largest_spacing_m = 0.0;
  /// Intervals that the way of the sound sets; the others follow the sonar's largest ping rate.
  std::uint64_t sound_bound = 0;
  double longest_range_m = 0.0;  ///< of all soundings, where pings go by the clock
  double beyond_data_m = 0.0;    ///< path without pings, since it lies beyond their reach of data
};

/// Walks along the route and gives its pings in order, a block at a time, so that a long route
/// needs little memory. The course is that of the segment being sailed; a ping on a waypoint
/// belongs to the next segment. Legs with the sonar off give no pings, but the count runs on.
/// With a fixed spacing the first ping stands on the first waypoint, and one follows each so many
/// metres of path; the count does not restart at waypoints. By the clock the next ping is due when
/// the boat has been under way, at the speed of the rows that it sails, for ping_interval_s() of
/// this ping's farthest sounding. A ping without a sounding counts with the range of the last one
/// that had one. A waypoint counts as reached kPathDust before it, so that rounding neither drops
/// the last ping nor moves one to the wrong segment.
/// The walker keeps references: route and sonar must outlive it.
class PingWalker {
 public:
  static constexpr double kPathDust = 1e-6;  ///< metres of path
  /// @throws UsageError for a timing that cannot be, a correlation length that is not > 0, or a
  ///   negative sigma.
  /// `reach`: pings elsewhere can sound nothing, so that whole stretches beyond it are skipped;
  /// empty: none are. A stray waypoint would else cost billions of pings.
  PingWalker(const Route& route, const Sonar& sonar, const PingTiming& timing,
             const TrackNoise& noise, const std::optional<Box2>& reach = {});
  /// Fills `block` with the next pings, at most `count`. False when none is left. By the clock
  /// `farthest` is asked once for each ping, in order, since the next ping depends on it. With a
  /// fixed spacing it is not asked and may be empty.
  bool next(std::size_t count, std::vector<Ping>& block, const FarthestSounding& farthest = {});
  [[nodiscard]] bool by_the_clock() const { return !timing_.spacing_m; }
  /// Share of the route's length walked so far, [0, 1].
  [[nodiscard]] double progress() const;
  [[nodiscard]] PingFigures figures() const;

 private:
  void step_noise(double sailed_m);
  bool push(std::vector<Ping>& block) const;
  bool skip_to_reach();
  void enter_next_segment();
  [[nodiscard]] double advance(const std::vector<Ping>& block, bool pinged,
                               const FarthestSounding& farthest);
  [[nodiscard]] double after_seconds(double seconds);

  const Route* route_;
  const Sonar* sonar_;
  PingTiming timing_;
  TrackNoise noise_;
  std::optional<Box2> reach_;
  std::vector<std::uint32_t> leg_of_segment_;
  std::size_t segment_ = 0;
  std::uint64_t index_ = 0;
  double at_ = 0.0;  // path of the next ping, metres
  double segment_start_ = 0.0, segment_length_ = 0.0, total_ = 0.0;
  double range_ = 0.0;  // of the last ping that had a sounding
  double sum_of_spacings_ = 0.0;
  PingFigures figures_;
  std::mt19937_64 random_;
  std::array<double, 4> noise_state_{};  // lateral, heading, roll, heave in units of their sigmas
};

}  // namespace swathplan
