#pragma once

#include <string>
#include <vector>

#include "coverage/score.h"

namespace swathplan::internal {

/// '96.6'; never rounded up to '100.0'.
[[nodiscard]] std::string percent_text(double percent);
/// Square metres with as many digits as they deserve: '0.04', '3.4', '1,250'.
[[nodiscard]] std::string area_text(double square_metres);
/// 'between lines' for HolidayCause::between_lines and so on.
[[nodiscard]] std::string cause_text(HolidayCause cause);

/// How many gaps, how large, and why the largest is there.
[[nodiscard]] std::string gaps_text(const Score& score);
/// What a plan is worth in one or two sentences: coverage, length, gaps.
[[nodiscard]] std::string verdict(const Score& score);
/// What speaks against sailing it: metres outside the water, grounding, legs that cannot
/// be steered, self-crossings.
[[nodiscard]] std::vector<std::string> warnings(const Score& score);
/// The best and the shortest of several plans, in one sentence.
[[nodiscard]] std::string overall_verdict(const std::vector<std::string>& planners,
                                          const std::vector<const Score*>& scores);

}  // namespace swathplan::internal
