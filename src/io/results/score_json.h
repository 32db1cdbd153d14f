#pragma once

#include <filesystem>
#include <string>

#include "coverage/judging/judged_survey.h"
#include "coverage/score.h"
#include "io/results/provenance.h"

namespace swathplan {

/// A survey that was judged, and the frame that its places lie in.
struct JudgedIn {
  const JudgedSurvey* survey = nullptr;  ///< null: it was not judged
  const Frame* frame = nullptr;
};

/// Every figure of the score and the provenance. The name of a figure ends in its unit. `planner`
/// names what made the route. A figure that does not exist is null, such as the smallest turn
/// radius of a straight route. What a criterion says stands last, as `criterion`. The same score
/// gives the same bytes.
[[nodiscard]] std::string score_json(const std::string& planner, const Score& score,
                                     const Provenance& provenance, const JudgedIn& judged = {});

/// Writes score_json() to a file.
/// @throws InvalidInput if the file cannot be written.
void write_score_json(const std::filesystem::path& path, const std::string& planner,
                      const Score& score, const Provenance& provenance,
                      const JudgedIn& judged = {});

}  // namespace swathplan
