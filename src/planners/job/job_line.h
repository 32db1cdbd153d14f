#pragma once

#include <vector>

#include "coverage/route/route.h"
#include "planners/rows/line_order.h"

namespace swathplan {

/// What is sailed in one piece: a survey line with its run-in and run-out, and the way that led to
/// it. What a waypoint says holds up to the next one; the last waypoint is the line's end.
struct JobLine {
  std::vector<Waypoint> points;  ///< at least two
  /// The join from the line before: it begins at that line's end and stops short of this line.
  /// Empty: to be found.
  std::vector<Waypoint> join_before = {};
};

/// The lines of a route in its order, each with its join, unless a boat that turns in
/// `turn_radius_m` cannot sail that as drawn. Lines that meet without a join are one.
[[nodiscard]] std::vector<JobLine> job_lines(const Route& route, double turn_radius_m);

/// What the logged part of a line is for: `patch` or `cross` where all of it is, else `line`.
[[nodiscard]] LegKind purpose(const JobLine& line);

/// The line as it is sailed the other way: the sides of its fans change, run-in and run-out too. It
/// has no join.
[[nodiscard]] JobLine backwards(const JobLine& line);

/// Lines in the opposite order, each sailed the other way, joins included. The first has no join.
[[nodiscard]] std::vector<JobLine> backwards(const std::vector<JobLine>& lines);

/// The line in pieces of the same sailing time, in order. The first keeps the join; a piece begins
/// where the one before ends, with an empty join. `pieces` >= 1.
[[nodiscard]] std::vector<JobLine> divided(const JobLine& line, int pieces);

/// Seconds that the waypoints take at their speeds.
[[nodiscard]] double sailing_s(const std::vector<Waypoint>& points);

/// The ends of the line and the courses there.
[[nodiscard]] LineEnds ends_of_line(const JobLine& line);

/// Sets the lines in the order and the direction given. Lines that followed each other keep their
/// joins, in either direction.
[[nodiscard]] std::vector<JobLine> arranged(const std::vector<JobLine>& lines,
                                            const std::vector<OrderedLine>& order);

}  // namespace swathplan
