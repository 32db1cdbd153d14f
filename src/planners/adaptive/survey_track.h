#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "coverage/route/route.h"

namespace swathplan {

/// A straight line that an adaptive planner asks for, in the frame of its box. It lies `across_m`
/// metres from the start corner and runs along the box's whole length.
struct SurveyTrack {
  int number = 0;         ///< from 0, in the order of sailing
  double across_m = 0.0;  ///< may lie outside [0, width] where a planner says so
  bool outbound = true;   ///< away from the start corner's side
  bool operator==(const SurveyTrack&) const = default;
};

/// Checks that an observation belongs to the track that is due (empty: the mission is complete).
/// @throws InvalidInput if `track` is another one; the message names both.
void check_due(const SurveyTrack& track, const std::optional<SurveyTrack>& due);

/// The corner of the box (seen with `along` up, as north on a map) where the mission starts.
enum class StartCorner { south_west, south_east, north_west, north_east };
/// 'sw', 'se', 'nw' or 'ne'; empty for anything else.
[[nodiscard]] std::optional<StartCorner> start_corner(std::string_view name);
[[nodiscard]] std::string_view name(StartCorner corner);

/// A rectangle to be surveyed. Before the choice of the corner, its tracks run along `azimuth`
/// and follow each other to the right of it.
struct SurveyBox {
  Vec2 corner = Vec2::Zero();  ///< the box's 'south-west' corner, local metres
  Angle azimuth;               ///< of the tracks, clockwise from north
  double width_m = 0.0;        ///< across the tracks
  double length_m = 0.0;       ///< along the tracks
  StartCorner start = StartCorner::south_west;
};

/// Local metres of a point `across` metres from the start corner and `along` metres up the first
/// track.
[[nodiscard]] Vec2 box_point(const SurveyBox& box, double across_m, double along_m);
/// Whether the vehicle's port side looks at smaller `across_m` on this track.
[[nodiscard]] bool port_looks_back(const SurveyBox& box, const SurveyTrack& track);

/// What the route of a mission says besides positions.
struct TrackRouteOptions {
  FanAngles fan{Angle::degrees(80), Angle::degrees(80)};
  double speed_mps = 1.5;
};
/// The tracks in their order, joined by straight transits with the sonar off. No track: an empty
/// route.
[[nodiscard]] Route mission_route(const SurveyBox& box, std::span<const SurveyTrack> tracks,
                                  const TrackRouteOptions& options = {});

/// Metres of tracks and connectors from the start corner's edge (`across_m` = 0) on; `length_m` is
/// that of one track. The same as length_m(mission_route(...)) when the first track lies at 0.
[[nodiscard]] double mission_length_m(std::span<const SurveyTrack> tracks, double length_m);
/// Metres sailed until the path first reaches `across_m`. Where the path ends short of it, the
/// missing metres across are added. Spatial periods of the accordion are measured like this.
[[nodiscard]] double length_until_m(std::span<const SurveyTrack> tracks, double length_m,
                                    double across_m);

}  // namespace swathplan
