#pragma once

#include <string>
#include <vector>

#include "coverage/score.h"

namespace swathplan::internal {

/// '96.6'; never rounded up to '100.0'.
[[nodiscard]] std::string percent_text(double percent);
/// Square metres with the digits that matter: '0.04', '3.4', '1,250'.
[[nodiscard]] std::string area_text(double square_metres);
/// 'between lines' for HolidayCause::between_lines and so on.
[[nodiscard]] std::string cause_text(HolidayCause cause);

/// How many gaps, how large, and why the largest is there.
[[nodiscard]] std::string gaps_text(const Score& score);
/// A plan in one or two sentences: coverage, length, gaps.
[[nodiscard]] std::string verdict(const Score& score);
/// Why the plan should not be sailed as it is: metres outside the water, too little water below the
/// keel, legs that cannot be steered, self-crossings.
[[nodiscard]] std::vector<std::string> warnings(const Score& score);
/// Which of several plans covers most and which is the shortest, in one sentence.
[[nodiscard]] std::string overall_verdict(const std::vector<std::string>& planners,
                                          const std::vector<const Score*>& scores);

}  // namespace swathplan::internal
