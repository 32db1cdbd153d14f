#pragma once

#include <optional>
#include <string>
#include <vector>

#include "coverage/route/route.h"
#include "io/route/read_route.h"

namespace swathplan {

/// A point of a route of another program and what holds from it to the next one.
struct ForeignPoint {
  Vec2 place = Vec2::Zero();  ///< longitude and latitude, or the coordinates of the seafloor's file
  LegKind kind = LegKind::line;
  std::optional<int> line;
  std::optional<double> speed_mps;
};

/// What a reader of such a file found.
struct ForeignRoute {
  bool in_degrees = true;
  bool names_kinds = false;  ///< the kinds are those of the file
  std::vector<std::vector<ForeignPoint>> parts;
  std::vector<std::string> notes;  ///< what of the file was left out
};

/// Places it in the frame and joins its parts by straight transits with the sonar off. No such
/// format holds fans: that of `defaults` is taken. Only lines, cross lines and infill are logged.
/// @throws InvalidInput that names `file`, for fewer than two points, degrees that are none,
/// degrees
///   without a CRS in `frame`, or without a fan in `defaults`.
[[nodiscard]] ImportedRoute placed(ForeignRoute route, const std::string& file, const Frame& frame,
                                   const RouteDefaults& defaults);

/// Joins lines to one route in their order; straight transits with the sonar off bridge the gaps.
/// Returns the gaps' number. No line may be empty.
std::size_t join_lines(const std::vector<std::vector<Waypoint>>& lines, Route& route);
/// The note on so many gaps.
[[nodiscard]] std::string gaps_note(std::size_t gaps);

/// The numbers of lines that names of waypoints such as 'line 3 start' and 'line 3 end' tell.
void number_lines(const std::vector<std::string>& names, std::vector<ForeignPoint>& points);
/// A number in [-1e9, 1e9]. Empty if the text is no whole number.
[[nodiscard]] std::optional<int> whole_number(std::string_view text);

}  // namespace swathplan
