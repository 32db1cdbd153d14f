#pragma once

#include <string>
#include <vector>

#include "planners/job/job_line.h"
#include "planners/plan.h"
#include "planners/steering/connect.h"

namespace swathplan {

struct CrossLineOptions {
  double share = 0.05;   ///< length of cross-lines / length of the main scheme, (0, 1]
  int first_number = 1;  ///< of the cross-lines
};

/// Straight cross-lines, and what they were chosen by.
struct CrossLines {
  std::vector<JobLine> lines;
  double share = 0.0;             ///< as laid
  std::size_t depth_tenths = 0;   ///< tenths of the main scheme, by depth, that are crossed
  double median_slope_deg = 0.0;  ///< of the ground at the crossings
  double site_slope_deg = 0.0;    ///< of the ground below the main scheme, its median
};

/// Lays cross-lines over the lines of a main scheme. A cross-line is worth what it crosses: a
/// crossing counts where it is within kRightAngleDeg of a right angle, more on gentle ground than
/// on steep, and less the more crossings its line and its tenth of the depths have already. The
/// line that is worth most for its length and its turn comes first, until they have the share; the
/// last one is cut to it. None is longer than a third of them all, nor shorter than the options'
/// least line, and a boat can turn onto each. `main`: lines of the main scheme; others do not
/// count. Nothing where no straight line crosses any of them so: the share is then less than was
/// asked for.
[[nodiscard]] CrossLines cross_lines(const std::vector<JobLine>& main, const Ground& ground,
                                     const PlanOptions& options, const Connector& connector,
                                     const CrossLineOptions& how);

/// @throws UsageError for a share that is not above 0 and at most 1.
void check(const CrossLineOptions& how);

}  // namespace swathplan
