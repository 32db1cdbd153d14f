#pragma once

#include <vector>

#include "planners/job/job_order.h"

namespace swathplan {

/// Lines that one boat sails from berth to berth.
using SortieLines = std::vector<JobLine>;

/// The lines with those that take longer than `longest_s` divided into pieces of the same time that
/// do not.
[[nodiscard]] std::vector<JobLine> in_pieces(const std::vector<JobLine>& lines, double longest_s);

/// Cuts lines, in their order, into sorties from the berth and back. Each takes no longer than
/// `longest_s` by the estimate; together they take the least time. Lines stay whole where they fit
/// into a sortie and no more than kWorthDividing of the time can be saved by dividing them.
/// Method: shortest path over the places where the order may be cut.
/// @throws UsageError if a sortie is too short for the way to a line and back.
[[nodiscard]] std::vector<SortieLines> cut_into_sorties(const std::vector<JobLine>& lines,
                                                        const JobWays& ways, const Vec2& berth,
                                                        double longest_s);

/// Cuts lines, in their order, into a part for each of several boats, so that the longest part is
/// as short as can be by the estimate. Lines are divided as in cut_into_sorties. `weights` scale
/// the boats' times, where an estimate is known to be off; empty: none are. No part is empty unless
/// there are fewer lines than boats.
[[nodiscard]] std::vector<SortieLines> cut_for_boats(const std::vector<JobLine>& lines,
                                                     const JobWays& ways, const Vec2& berth,
                                                     int boats,
                                                     const std::vector<double>& weights = {});

inline constexpr double kWorthDividing = 0.01;

}  // namespace swathplan
