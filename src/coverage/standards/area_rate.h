#pragma once

#include <functional>
#include <optional>
#include <span>

#include "coverage/route/ping_clock.h"

namespace swathplan {

/// What is asked of a fan over level ground. The sonar gives beams, their spacing, the largest ping
/// rate, range, coverage curve and fans a cycle.
struct RateQuestion {
  Sonar sonar;
  Angle max_half_angle = Angle::degrees(65);  ///< (0, 90) degrees
  double cell_m = 1.0;                        ///< > 0
  std::optional<double> ping_spacing_m = {};  ///< largest along the course; empty: a cell
  double soundings = 5.0;                     ///< wanted a cell at the swath's edge, > 0
  double max_speed_mps = 4.0;                 ///< > 0
  double least_speed_mps = 0.0;               ///< the boat steers no slower, >= 0
  double sound_speed_mps = 1500.0;            ///< > 0
};

/// What holds the speed down.
enum class RateLimit {
  vehicle,       ///< its own largest speed
  ping_spacing,  ///< a ping in each cell along the course, or nearer where that is asked
  soundings      ///< the soundings wanted a cell
};

/// How fast a fan surveys.
struct AreaRate {
  Angle half_angle;
  double beam_spacing_m = 0.0;   ///< between neighbouring beams at the swath's edge
  double ping_interval_s = 0.0;  ///< between pings
  double speed_mps = 0.0;        ///< largest
  double rate_m2ps = 0.0;        ///< swath width x speed
  RateLimit limit = RateLimit::vehicle;
};

/// Metres between neighbouring beams at the edge of a fan over level ground.
[[nodiscard]] double edge_beam_spacing_m(const Sonar& sonar, double depth_m, Angle half_angle);

/// The rate of a fan `depth_m` above level ground. Empty where it does not serve: its beams stand
/// farther apart than a cell or beyond the sonar's range, or it asks for less than the least speed.
/// @throws UsageError for a question, depth or angle out of range.
[[nodiscard]] std::optional<AreaRate> area_rate(const RateQuestion& question, double depth_m,
                                                Angle half_angle);

/// The fan with the largest rate; empty where no fan serves.
/// Guarantees: no half-angle up to the largest has a rate higher by more than a millionth.
[[nodiscard]] std::optional<AreaRate> best_area_rate(const RateQuestion& question, double depth_m);

/// Ground of one depth below the sonar.
struct DepthArea {
  double depth_m = 0.0, area_m2 = 0.0;
};

/// The fewest hours that the ground can be surveyed in: each place by its best fan, lines at the
/// largest speed, no turn, no overlap.
struct LeastHours {
  double hours = 0.0;
  double area_m2 = 0.0;                                  ///< that the hours are of
  double unreachable_m2 = 0.0;                           ///< where no fan serves
  double deepest_m = 0.0, shoalest_unreachable_m = 0.0;  ///< depths below the sonar; 0: none
};
/// Places without depth below the sonar add nothing. Depths within kDepthBin of one another are
/// taken together, by their mean. O(places).
[[nodiscard]] LeastHours least_hours(const RateQuestion& question,
                                     std::span<const DepthArea> places);
/// What is asked at a depth below the sonar; empty where no fan serves.
using QuestionAt = std::function<std::optional<RateQuestion>(double depth_m)>;
/// The same where the question hangs on the depth. `between_m`: ground that may stay unseen between
/// neighbouring swaths, metres across the lines.
[[nodiscard]] LeastHours least_hours(const QuestionAt& question_at,
                                     std::span<const DepthArea> places, double between_m = 0.0);
inline constexpr double kDepthBin = 0.005;  ///< share of the depth

}  // namespace swathplan
