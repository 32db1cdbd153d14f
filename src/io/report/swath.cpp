#include <algorithm>
#include <cmath>
#include <functional>

#include "io/report/swath_internal.h"

namespace swathplan::internal {
namespace {

constexpr int kMarchSteps = 24;  // over the width that level ground would give
constexpr int kMostSteps = 400;  // a beam that runs down a slope goes farther than that width
constexpr int kBisections = 12;

/// Where the boat is while it sails a segment, and which way.
struct Station {
  Vec2 position, course;
};

Vec2 port_of(const Vec2& course) { return {-course.y(), course.x()}; }

/// Calls visit(station, waypoint) each `step` of what `cost` counts, and at the leg's end.
void walk(const Route& route, const Leg& leg, double step,
          const std::function<double(const Waypoint&, double)>& cost,
          const std::function<void(const Station&, const Waypoint&)>& visit) {
  double due = 0.0;
  Station last;
  for (std::size_t i = leg.first; i < leg.last; ++i) {
    const Waypoint& w = route.waypoints[i];
    const Vec2 way = route.waypoints[i + 1].position - w.position;
    const double length = way.norm();
    if (!(length > 0.0)) continue;
    const Vec2 course = way / length;
    const double total = cost(w, length);
    for (; due < total; due += step) visit({w.position + due / total * way, course}, w);
    due -= total;
    last = {route.waypoints[i + 1].position, course};
    if (i + 1 == leg.last) visit(last, w);
  }
}

}  // namespace

SwathEdge swath_edge(const DepthQuery& depths, const Sonar& sonar, double draft_m,
                     const Vec2& position, const Vec2& side, Angle angle) {
  const std::optional<double> below = depths.depth(position);
  if (!below || *below <= draft_m) return {};
  const double tangent = std::max(tan(angle), 1e-6), sine = std::max(std::sin(angle.rad()), 1e-6);
  const double level = (*below - draft_m) * tangent;
  const double farthest = reach_m(sonar, angle) * sine;
  // Above 0: the beam is still in the water. Empty: no ground there.
  const auto water_below = [&](double across) -> std::optional<double> {
    const std::optional<double> depth = depths.depth(position + across * side);
    if (!depth) return std::nullopt;
    return *depth - draft_m - across / tangent;
  };
  const double step = std::max(level / kMarchSteps, 1e-3);
  double low = 0.0;
  for (int i = 0; i < kMostSteps && low < farthest; ++i) {
    const double high = std::min(low + step, farthest);
    const std::optional<double> water = water_below(high);
    if (!water) break;
    if (*water <= 0.0) {
      double a = low, b = high;
      for (int k = 0; k < kBisections; ++k) {
        const double middle = 0.5 * (a + b);
        (water_below(middle).value_or(0.0) > 0.0 ? a : b) = middle;
      }
      return {b, b / sine};
    }
    low = high;
  }
  return {low, std::max(low / sine, *below - draft_m)};
}

Ring swath_outline(const Route& route, const Leg& leg, const DepthQuery& depths, const Sonar& sonar,
                   double draft_m, double step_m) {
  Ring port, starboard;
  walk(
      route, leg, step_m, [](const Waypoint&, double length) { return length; },
      [&](const Station& at, const Waypoint& w) {
        if (!w.fan) return;
        const Vec2 left = port_of(at.course);
        const auto reach = [&](const Vec2& side, Angle angle) {
          return swath_edge(depths, sonar, draft_m, at.position, side, angle).across_m;
        };
        port.push_back(at.position + reach(left, w.fan->port) * left);
        starboard.push_back(at.position - reach(-left, w.fan->starboard) * left);
      });
  port.insert(port.end(), starboard.rbegin(), starboard.rend());
  return port;
}

std::vector<AlongTrack> along_track(const Route& route, const DepthQuery& depths,
                                    const Sonar& sonar, double draft_m, const PingTiming& timing,
                                    std::size_t count) {
  const auto seconds = [](const Waypoint& w, double length) { return length / w.speed_mps; };
  double total = 0.0;
  for (std::size_t i = 0; i + 1 < route.waypoints.size(); ++i) {
    const Waypoint& w = route.waypoints[i];
    total += seconds(w, (route.waypoints[i + 1].position - w.position).norm());
  }
  const double step = std::max(total / static_cast<double>(count), 1e-3);
  std::vector<AlongTrack> out;
  const auto add = [&](const Station& at, const Waypoint& w) {
    AlongTrack& now = out.emplace_back();
    now.seconds = std::min(static_cast<double>(out.size() - 1) * step, total);
    now.depth_m = depths.depth(at.position);
    if (!w.fan || !now.depth_m) return;
    const Vec2 left = port_of(at.course);
    const double range =
        std::max(swath_edge(depths, sonar, draft_m, at.position, left, w.fan->port).range_m,
                 swath_edge(depths, sonar, draft_m, at.position, -left, w.fan->starboard).range_m);
    now.ping_spacing_m =
        timing.spacing_m.value_or(w.speed_mps * ping_interval_s(sonar, timing, range));
  };
  walk(route, {0, route.waypoints.size() - 1}, step, seconds, add);
  return out;
}

}  // namespace swathplan::internal
