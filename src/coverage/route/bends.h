#pragma once

#include "mesh/plane/polygons.h"

namespace swathplan {

/// How the course changes at a waypoint.
struct CourseChange {
  double before_m = 0.0, after_m = 0.0;  ///< lengths of the segments beside it
  double angle_rad = 0.0;                ///< to port positive
};
/// At b, on the way from a to c.
[[nodiscard]] CourseChange course_change(const Vec2& a, const Vec2& b, const Vec2& c);

/// A larger change of course at one waypoint, degrees, is a corner, for curves are written in
/// smaller steps ...
inline constexpr double kCornerDeg = 15.0;
/// ... but for tight curves that were thinned: chords of at most this many metres ...
inline constexpr double kLongestChordM = 4.0;
/// ... whose arc passes the waypoint no farther off than this, metres: a little more than exported
/// paths leave out.
inline constexpr double kCornerMissM = 0.12;

/// Whether the course changes as no curve of `turn_radius_m` is written: a corner, which cannot be
/// sailed as drawn at any length of its legs.
[[nodiscard]] bool is_corner(const CourseChange& change, double turn_radius_m);

/// The turn radius that the waypoint asks for, metres: 0 at a corner; else that of the arc which
/// touches both segments and begins in the middle of the shorter one. On a curve of even waypoints
/// this is the curve's radius. Infinite where the course stays.
[[nodiscard]] double bend_radius_m(const CourseChange& change, double turn_radius_m);

/// The path that a turn of `turn_radius_m` needs for the change of course, but no more than half of
/// each segment beside it, metres.
[[nodiscard]] double turn_path_m(const CourseChange& change, double turn_radius_m);

}  // namespace swathplan
