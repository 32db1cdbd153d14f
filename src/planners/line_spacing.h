#pragma once

#include <optional>
#include <string>
#include <vector>

#include "planners/plan.h"

namespace swathplan {

/// The depths of a block, each of the same share of its area, ascending, metres.
[[nodiscard]] std::vector<double> block_depths(const Area& block, const DepthQuery& depths);

/// The depth that stands for a block; 0 for a block without depths.
[[nodiscard]] double depth_of(const std::vector<double>& block, const BlockDepth& which);

/// How the lines of a block lie, and what they are laid by.
struct BlockLines {
  FanAngles fan;
  double spacing_m = 0.0;  ///< between lines; 0 where the fan meets no ground
  double swath_m = 0.0;    ///< that the fan sweeps at the block's depth
  double depth_m = 0.0;    ///< of the block, below the sonar
};

/// Lines of a block by its depth: the fan is `opening_angle`, or the widest that the sonar has and
/// that still meets the ground; the spacing is `row_spacing.spacing_m`, or the swath less the
/// overlap: 2 d tan(half-angle) (1 - overlap), with d below the sonar.
[[nodiscard]] BlockLines lines_of_block(const std::vector<double>& depths,
                                        const PlanOptions& options);

/// What the fan is to sweep where it opens by the depth below: the spacing and the overlap, metres.
[[nodiscard]] double wanted_swath_m(const BlockLines& lines, const PlanOptions& options);

/// How far apart the lines lie and why, as one sentence without a full stop.
[[nodiscard]] std::string spacing_note(const BlockLines& lines, const PlanOptions& options);

/// How far apart neighbouring lines of the survey area lie by and large: what the sonar's fan
/// sweeps at the mean depth, but no more than W. Empty where nothing is known of depths.
[[nodiscard]] std::optional<double> usual_lane_m(const Ground& ground, const PlanOptions& options);

/// @throws UsageError for a spacing where lines lie W apart.
void check_spacing(const RowSpacing& rows);

/// No planner lays more parallel lines than this over a block.
inline constexpr double kMostRows = 20000.0;
/// @throws UsageError where lines so far apart would be more than kMostRows.
void check_rows(const Area& block, double spacing_m);

}  // namespace swathplan
