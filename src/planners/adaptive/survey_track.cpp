#include "planners/adaptive/survey_track.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "mesh/base/error.h"

namespace swathplan {
namespace {

constexpr std::array<std::pair<StartCorner, std::string_view>, 4> kCorners{{
    {StartCorner::south_west, "sw"},
    {StartCorner::south_east, "se"},
    {StartCorner::north_west, "nw"},
    {StartCorner::north_east, "ne"},
}};

// Path lengths are sums of a few lengths. A tenth of a micrometre is less than any of them.
constexpr double kNoDistance = 1e-7;

bool starts_east(StartCorner corner) {
  return corner == StartCorner::south_east || corner == StartCorner::north_east;
}
bool starts_north(StartCorner corner) {
  return corner == StartCorner::north_west || corner == StartCorner::north_east;
}

}  // namespace

void check_due(const SurveyTrack& track, const std::optional<SurveyTrack>& due) {
  if (due && track == *due) return;
  throw InvalidInput(fmt::format(
      "an observation for track {} at {} m, which was not given; {}", track.number, track.across_m,
      due ? fmt::format("track {} at {} m is due", due->number, due->across_m)
          : "the mission is complete"));
}

std::optional<StartCorner> start_corner(std::string_view text) {
  for (const auto& [corner, known] : kCorners) {
    if (known == text) return corner;
  }
  return std::nullopt;
}

std::string_view name(StartCorner corner) {
  for (const auto& [known, text] : kCorners) {
    if (known == corner) return text;
  }
  return "sw";
}

Vec2 box_point(const SurveyBox& box, double across_m, double along_m) {
  const Vec2 up(sin(box.azimuth), cos(box.azimuth));
  const Vec2 right(up.y(), -up.x());
  const double x = starts_east(box.start) ? box.width_m - across_m : across_m;
  const double y = starts_north(box.start) ? box.length_m - along_m : along_m;
  return box.corner + x * right + y * up;
}

bool port_looks_back(const SurveyBox& box, const SurveyTrack& track) {
  const bool mirrored = starts_east(box.start) != starts_north(box.start);
  return track.outbound != mirrored;
}

Route mission_route(const SurveyBox& box, std::span<const SurveyTrack> tracks,
                    const TrackRouteOptions& options) {
  Route route;
  for (const SurveyTrack& track : tracks) {
    Waypoint start;
    start.position = box_point(box, track.across_m, track.outbound ? 0.0 : box.length_m);
    start.line = track.number;
    start.fan = options.fan;
    start.speed_mps = options.speed_mps;
    route.waypoints.push_back(start);
    Waypoint end;
    end.position = box_point(box, track.across_m, track.outbound ? box.length_m : 0.0);
    end.kind = LegKind::transit;
    end.log = false;
    end.speed_mps = options.speed_mps;
    route.waypoints.push_back(end);
  }
  if (!route.waypoints.empty()) route.waypoints.back().kind = LegKind::end;
  return route;
}

double mission_length_m(std::span<const SurveyTrack> tracks, double length_m) {
  double across = 0.0;
  double sum = 0.0;
  bool far_end = false;
  for (const SurveyTrack& track : tracks) {
    const double sideways = track.across_m - across;
    // A track that starts at the end of the box where the last one did not end costs the way back.
    const double lengthways = far_end == track.outbound ? length_m : 0.0;
    sum += std::hypot(sideways, lengthways) + length_m;
    across = track.across_m;
    far_end = track.outbound;
  }
  return sum;
}

double length_until_m(std::span<const SurveyTrack> tracks, double length_m, double across_m) {
  double sum = 0.0;
  double across = 0.0;
  for (const SurveyTrack& track : tracks) {
    if (track.across_m >= across_m - kNoDistance) break;
    sum += std::abs(track.across_m - across) + length_m;
    across = track.across_m;
  }
  return sum + across_m - across;
}

}  // namespace swathplan
