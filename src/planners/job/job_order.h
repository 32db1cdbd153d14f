#pragma once

#include <optional>
#include <vector>

#include "planners/job/job_line.h"
#include "planners/job/job_ways.h"

namespace swathplan {

/// From where to where lines are to be put in an order; empty where that does not matter.
struct JobEnds {
  std::optional<JobLine> after;  ///< the line that is sailed before
  std::optional<Vec2> out;       ///< ... or the berth that the boat comes from
  std::optional<Vec2> home;      ///< the berth that it returns to
};

/// The given order, sailed forwards or backwards, whichever takes less time by the estimate.
[[nodiscard]] std::vector<JobLine> in_given_order(const std::vector<JobLine>& lines,
                                                  const JobWays& ways, const JobEnds& ends);

/// The order that the estimate finds best (line_order), which may keep stretches of the given one.
/// More than kMostOrdered lines stay as they are given.
[[nodiscard]] std::vector<JobLine> in_best_order(const std::vector<JobLine>& lines,
                                                 const JobWays& ways, const JobEnds& ends);
inline constexpr std::size_t kMostOrdered = 1500;

/// Seconds by the estimate, lines included; joins that the lines have count as they are.
[[nodiscard]] double estimated_s(const std::vector<JobLine>& lines, const JobWays& ways,
                                 const JobEnds& ends);

/// Seconds of the join from a line to the next one, as it is or by the estimate.
[[nodiscard]] double join_before_s(const JobLine& before, const JobLine& line, const JobWays& ways);

}  // namespace swathplan
