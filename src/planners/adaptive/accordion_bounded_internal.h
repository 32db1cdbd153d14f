#pragma once

#include <optional>

#include "planners/adaptive/accordion.h"

namespace swathplan {

/// Where the bounded rule lays the first track, a track back for objects behind, and the next
/// track ahead. All in metres across. `bounded_step` needs an area that is not done.
[[nodiscard]] double bounded_start(const AccordionState& state);
[[nodiscard]] std::optional<double> bounded_loop_back(const AccordionState& state);
[[nodiscard]] double bounded_step(const AccordionState& state);

}  // namespace swathplan
