#pragma once

#include <nlohmann/json.hpp>

#include "coverage/score.h"

namespace swathplan {

/// Every figure of a score under the names of score.json.
[[nodiscard]] nlohmann::ordered_json score_figures(const Score& score);

}  // namespace swathplan
