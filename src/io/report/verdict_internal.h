#pragma once

#include <string>
#include <vector>

#include "coverage/judging/judged_survey.h"
#include "coverage/score.h"

namespace swathplan::internal {

/// A plan as far as it is compared: its name, score, and what the criterion says (null: nothing).
struct ComparedPlan {
  std::string name;
  const Score* score = nullptr;
  const JudgedSurvey* judged = nullptr;
};

/// '96.6'; never rounded up to '100.0'.
[[nodiscard]] std::string percent_text(double percent);
/// Square metres with the digits that matter: '0.04', '3.4', '1,250'.
[[nodiscard]] std::string area_text(double square_metres);
/// '57 min', '3 h 30 min'.
[[nodiscard]] std::string time_text(double seconds);
/// '640 m', '6.6 km'.
[[nodiscard]] std::string length_text(double metres);
/// 'between lines' for HolidayCause::between_lines and so on.
[[nodiscard]] std::string cause_text(HolidayCause cause);

/// Gaps of fewer cells are speckle: the next ping or beam falls beside them.
inline constexpr std::size_t kSpeckleCells = 4;
/// How many gaps, how large, and why the largest is there. Speckle is named apart.
[[nodiscard]] std::string gaps_text(const Score& score);
/// The plan in a surveyor's words: hours, length, coverage that counts, density, whether it is
/// predicted to pass, and the least hours.
[[nodiscard]] std::string verdict(const ComparedPlan& plan);
/// Why the plan should not be sailed as it is: metres outside the water, too little water below the
/// keel, legs that cannot be steered.
[[nodiscard]] std::vector<std::string> warnings(const Score& score);

/// The plan to sail (of one or more): one without warnings before others; one that is predicted to
/// pass before others; of several that pass the one with the fewest hours; else as planners pick:
/// of those that reach the goal of coverage the one with the fewest hours (hours_to_pick_by), and
/// where none does the one that covers most.
[[nodiscard]] std::size_t best_plan(const std::vector<ComparedPlan>& plans);
/// Which of several plans is the best, and why, in one sentence; empty for a single one.
[[nodiscard]] std::string overall_verdict(const std::vector<ComparedPlan>& plans);

}  // namespace swathplan::internal
