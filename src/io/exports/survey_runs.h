#pragma once

#include <string>
#include <vector>

#include "coverage/route/route.h"

namespace swathplan {

/// A survey line of a route from its first to its last waypoint, without run-in and run-out.
struct SurveyRun {
  std::size_t first, last;  ///< waypoint indices, first < last
  /// The line's number, made unique: a second stretch of line 3 is '3_2'. 'X' stands before that of
  /// a cross-line, 'P' before that of a line of the patch test.
  std::string name;
};

/// The maximal stretches of a route that are sailed as one line, cross line or infill pass, in the
/// order of sailing. Lines without a number are numbered from one above the largest.
[[nodiscard]] std::vector<SurveyRun> survey_runs(const Route& route);

/// A name for each waypoint: 'line 3 start' or 'line 3 end', 'cross-line X7 start', 'patch line P8
/// end'. Where one line ends and the next one
/// begins, a comma joins both names. Any other waypoint has its number, from 1.
[[nodiscard]] std::vector<std::string> waypoint_names(const Route& route);

/// Names of at most six characters, no two alike, for receivers that show no more: 'S3' and 'E3'
/// where line 3 starts and ends, 'E3S4' where one ends and the next one begins, else the number.
[[nodiscard]] std::vector<std::string> short_waypoint_names(const Route& route);

}  // namespace swathplan
