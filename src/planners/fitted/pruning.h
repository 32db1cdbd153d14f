#pragma once

#include <cstddef>

#include "planners/fitted/sounded_stretches.h"

namespace swathplan {

struct PruneOptions {
  double goal_pct = 100.0;        ///< so many cells stay covered, per cent
  double seconds_of_point = 0.0;  ///< no change that saves less for each point of coverage lost
  double detour_s = 0.0;          ///< a join that cannot be steered costs so much more
};

/// A route without what brings the least for its time.
struct PrunedRoute {
  BuiltRoute built;
  std::size_t dropped = 0;  ///< lines and infill passes
  std::size_t trimmed = 0;  ///< ends of lines that were shortened
};

/// Drops lines and shortens the ends of lines, the least coverage lost for each second saved first,
/// as long as the goal holds. What each stretch of line alone covers is counted on the scoring
/// cells. Both ends beside a join are shortened together, for one alone would save no way. No line
/// gets shorter than the options' least line; what turns have made shorter is dropped first. Where
/// nothing pays, the route stays empty. For plans that are judged by hits of logged lines.
[[nodiscard]] PrunedRoute pruned(const SoundedLines& lines, const LineWorkshop& shop,
                                 const PruneOptions& options);

}  // namespace swathplan
