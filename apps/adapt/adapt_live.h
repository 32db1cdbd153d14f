#pragma once

#include <functional>
#include <istream>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <string>

#include "planners/adaptive/survey_track.h"

namespace swathplan {

/// A planner behind the live protocol (docs/live.md). `observe` takes the message that holds the
/// observation of the track that is due and throws where it is not good; the mission then stands
/// as it stood.
struct LivePlanner {
  std::string name;
  std::function<std::optional<SurveyTrack>()> next;
  std::function<void(const SurveyTrack&, const nlohmann::json&)> observe;
  std::function<nlohmann::ordered_json()> figures;  ///< added to the answer 'done'
};

/// Gives the first track, then answers each line of `in` with one line on `out` until the input
/// ends. Returns the tracks that were sailed.
std::vector<SurveyTrack> run_live(std::istream& in, std::ostream& out, const SurveyBox& box,
                                  const Frame& frame, const LivePlanner& planner);

}  // namespace swathplan
