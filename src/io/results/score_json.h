#pragma once

#include <filesystem>
#include <string>

#include "coverage/score.h"
#include "io/results/provenance.h"

namespace swathplan {

/// Every figure of the score and the provenance. The name of a figure ends in its unit. `planner`
/// names what made the route. A figure that does not exist is null, such as the smallest turn
/// radius of a straight route. The same score gives the same bytes.
[[nodiscard]] std::string score_json(const std::string& planner, const Score& score,
                                     const Provenance& provenance);

/// Writes score_json() to a file.
/// @throws InvalidInput if the file cannot be written.
void write_score_json(const std::filesystem::path& path, const std::string& planner,
                      const Score& score, const Provenance& provenance);

}  // namespace swathplan
