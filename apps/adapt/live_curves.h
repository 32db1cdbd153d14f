#pragma once

#include <nlohmann/json.hpp>

#include "planners/adaptive/track_spacing.h"

namespace swathplan {

/// The detection curves of a message of the live protocol (docs/live.md): of both sides, or of
/// each.
/// @throws nlohmann::json::exception or what the library throws, where they are no curves.
[[nodiscard]] SideCurves observed_curves(const nlohmann::json& message);

}  // namespace swathplan
