#pragma once

#include "planners/plan.h"

namespace swathplan {

/// Multi-depth back-and-forth (MDB&F). Each depth region has parallel lines of its own, along its
/// best direction (or `heading`). With SwathBy::footprint they lie W apart, with one opening angle
/// from the region's mean depth; with SwathBy::fan they are laid as those of back-and-forth, by the
/// region's depth. No line is shorter than `least_line_m`. The next region is always the one with
/// the nearest end of a line. The ways between lines and regions stay in the water, ping, and are
/// not logged.
/// @throws UsageError for options out of range or bands that hold no part of the area.
[[nodiscard]] Plan plan_multi_depth(const Ground& ground, const PlanOptions& options);

}  // namespace swathplan
