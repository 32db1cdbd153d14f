#pragma once

#include <optional>

#include "planners/adaptive/accordion.h"

namespace swathplan {

/// Where the bounded rule lays the first track, metres across.
[[nodiscard]] double bounded_start(const AccordionState& state);
/// Where it lays a track back for objects behind; empty where none is needed. Metres across.
[[nodiscard]] std::optional<double> bounded_loop_back(const AccordionState& state);
/// Where it lays the next track ahead, metres across. The area must not be done.
[[nodiscard]] double bounded_step(const AccordionState& state);

}  // namespace swathplan
