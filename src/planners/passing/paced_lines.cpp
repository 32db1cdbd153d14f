#include "planners/passing/paced_lines.h"

#include <algorithm>
#include <cmath>

#include "coverage/standards/criterion_fan.h"
#include "planners/fronts/rate_width.h"

namespace swathplan {
namespace {

constexpr double kPaceStep = 0.1;
constexpr double kDepthEachM = 2.0;
/// Pings a little closer than asked: the ground is rarely as deep as the chart's cell says.
constexpr double kPaceReserve = 0.95;
constexpr double kShoalestBelow = 0.1;

/// Least and most water below the sonar along a leg.
SonarDepths depths_along(const Route& route, const Leg& leg, const SurveyJudge& judge,
                         const PlanOptions& options) {
  SonarDepths depths{std::numeric_limits<double>::infinity(), 0.0};
  for (std::size_t i = leg.first; i < leg.last; ++i) {
    const Vec2& from = route.waypoints[i].position;
    const Vec2 way = route.waypoints[i + 1].position - from;
    const int steps = std::max(1, static_cast<int>(way.norm() / kDepthEachM));
    for (int k = 0; k <= steps; ++k) {
      const auto depth = judge.ground().depths->depth(from + way * (k / double(steps)));
      if (!depth) continue;
      const double below = std::max(*depth - options.vehicle.draft_m, kShoalestBelow);
      depths.shoalest_m = std::min(depths.shoalest_m, below);
      depths.deepest_m = std::max(depths.deepest_m, below);
    }
  }
  if (depths.deepest_m == 0.0) return {};
  return depths;
}

/// Seconds between pings of a fan, as far as the sonar's curve lets it see.
double interval_s(const FanAngles& fan, double below, const PlanOptions& options) {
  const Angle wider = std::max(fan.port, fan.starboard);
  const double range = std::min(below / cos(wider), options.sonar.max_range_m);
  return ping_interval_s(options.sonar, options.pings, range);
}

}  // namespace

void pace_lines(Route& route, const SurveyJudge& judge, const PlanOptions& options, double pace) {
  const RateQuestion plain = rate_question(options);
  for (const Leg& leg : legs(route)) {
    const Waypoint& first = route.waypoints[leg.first];
    if (!first.log || !first.fan) continue;
    const double below = depths_along(route, leg, judge, options).deepest_m;
    if (!(below > 0.0)) continue;
    const auto asked =
        asked_by(judge.criterion(), judge.uncertainty(), plain, below, options.vehicle.draft_m);
    for (std::size_t i = leg.first; i < leg.last; ++i) {
      Waypoint& w = route.waypoints[i];
      double speed = pace * w.speed_mps;
      if (asked && asked->ping_spacing_m && w.fan) {
        const double apart = kPaceReserve * *asked->ping_spacing_m;
        speed = std::min(speed, apart / interval_s(*w.fan, below, options));
      }
      speed = std::floor(speed / kPaceStep + 1e-6) * kPaceStep;
      w.speed_mps = std::clamp(speed, options.least_speed_mps, options.vehicle.speed_mps);
    }
  }
}

void open_for_two_lines(Route& route, const SurveyJudge& judge, const PlanOptions& options) {
  for (const Leg& leg : legs(route)) {
    if (!route.waypoints[leg.first].log || !route.waypoints[leg.first].fan) continue;
    const double below = depths_along(route, leg, judge, options).shoalest_m;
    if (!(below > 0.0)) continue;
    const auto half = accepted_half_angle(judge.criterion(), judge.uncertainty(), options.sonar,
                                          below, options.vehicle.draft_m, options.vehicle.speed_mps,
                                          options.sonar.max_opening / 2);
    if (!half || !(half->deg() >= 1.0)) continue;
    const Angle whole = Angle::degrees(std::floor(half->deg() + 1e-6));
    for (std::size_t i = leg.first; i < leg.last; ++i) {
      route.waypoints[i].fan = FanAngles{whole, whole};
    }
  }
}

double sailing_s(const Route& route) {
  double seconds = 0.0;
  for (std::size_t i = 0; i + 1 < route.waypoints.size(); ++i) {
    const Waypoint& w = route.waypoints[i];
    seconds += (route.waypoints[i + 1].position - w.position).norm() / w.speed_mps;
  }
  return seconds;
}

}  // namespace swathplan
