#pragma once

#include <optional>
#include <vector>

#include "coverage/route/ping_clock.h"
#include "coverage/route/route.h"
#include "coverage/route/sonar.h"
#include "mesh/seafloor.h"

namespace swathplan::internal {

/// How far to one side the outermost beam of a fan reaches: metres over ground, and slant range.
struct SwathEdge {
  double across_m = 0.0, range_m = 0.0;
};

/// Where the beam at `angle` from nadir meets the seafloor, from `position` and `draft_m` below the
/// water line, towards the unit vector `side`. It ends at the last depth before ground without
/// data, and where the sonar reaches no farther. Zero where there is no depth below the boat.
[[nodiscard]] SwathEdge swath_edge(const DepthQuery& depths, const Sonar& sonar, double draft_m,
                                   const Vec2& position, const Vec2& side, Angle angle);

/// The ground that the fan sweeps along a leg: its port edge on, its starboard edge back. A station
/// stands each `step_m` of path and at the leg's ends. Empty where the sonar is off.
[[nodiscard]] Ring swath_outline(const Route& route, const Leg& leg, const DepthQuery& depths,
                                 const Sonar& sonar, double draft_m, double step_m);

/// What passes below the boat while it sails.
struct AlongTrack {
  double seconds = 0.0;
  std::optional<double> depth_m;         ///< empty where there is no seafloor
  std::optional<double> ping_spacing_m;  ///< empty with the sonar off, or no seafloor
};

/// About `count` even steps of time along the route. The spacing of pings follows from the farther
/// edge of the swath, by the clock that the timing gives.
[[nodiscard]] std::vector<AlongTrack> along_track(const Route& route, const DepthQuery& depths,
                                                  const Sonar& sonar, double draft_m,
                                                  const PingTiming& timing, std::size_t count);

}  // namespace swathplan::internal
