#pragma once

#include "apps/command_line.h"

// Each planner with simulate, study and live below it.
namespace swathplan {

[[nodiscard]] Command adapt_accordion_command();
[[nodiscard]] Command adapt_spacing_command();
[[nodiscard]] Command adapt_quality_command();

}  // namespace swathplan
