#pragma once

#include <vector>

#include "planners/fitted/straight_search_internal.h"

namespace swathplan {

/// A plan and its outcome from the exact scorer.
struct JudgedLines {
  BuiltRoute built;
  Outcome outcome;
};

/// The best few plans of lines that bend: along fronts from the area's long walls (where cells are
/// coarse enough, or the options ask for them), and along both banks of a channel or a ring.
[[nodiscard]] std::vector<JudgedLines> search_curved_lines(LineWorkshop& shop,
                                                           const SearchBudget& budget);

}  // namespace swathplan
