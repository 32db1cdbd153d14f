#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "planners/fitted/line_workshop.h"

namespace swathplan {

/// A short stretch of a line, and what it sounds.
struct SoundedPiece {
  std::size_t begin = 0, end = 0;  ///< waypoints of the line
  double metres = 0.0, seconds = 0.0;
  /// Counting cells, each once, and its soundings.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> cells;
};

/// A survey line or infill pass of a route. Its last waypoint is its end.
struct SoundedLine {
  std::vector<Waypoint> points;
  std::vector<SoundedPiece> pieces;
  std::vector<Waypoint> join;  ///< from the line before, as RouteStretch has it; may be empty
};

struct SoundedLines {
  std::vector<SoundedLine> lines;  ///< as they are sailed
  std::size_t counting = 0;        ///< cells of the area
  ScoredRoute scored;              ///< of the same route; legs are divided into pieces
};

/// Scores the route on the true cells and says what each piece of its logged lines sounded. No
/// lines for a route that begins or ends with a join.
[[nodiscard]] SoundedLines sounded_stretches(const Route& route, LineWorkshop& shop);

}  // namespace swathplan
