#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "planners/fitted/line_workshop.h"

namespace swathplan {

/// How a set of straight lines is made.
struct StraightCandidate {
  double azimuth_deg = 0.0;
  int lines = 1;
  double gap = 1.2;  ///< of W, in scoring cells
  double percentile = 0.15;
  double phase = 0.5;
  std::optional<double> end_rows = {};  ///< see StraightLinesOptions
  double inset_m = 0.05;
  double overlap_m = 0.4;
  double widest_share = 1.0;
  bool by_distance = false;
  bool operator==(const StraightCandidate&) const = default;
};

struct JudgedCandidate {
  StraightCandidate candidate;
  Outcome outcome;
  BuiltRoute built;  ///< of finalists
};

[[nodiscard]] std::vector<SurveyCurve> lines_of(const StraightCandidate& candidate,
                                                LineWorkshop& shop);
[[nodiscard]] BuiltRoute build(const StraightCandidate& candidate, LineWorkshop& shop);
/// The swath that a candidate's rows are spaced by, and how its fans open.
[[nodiscard]] const std::vector<float>& width_of(const StraightCandidate& candidate,
                                                 LineWorkshop& shop);
[[nodiscard]] LineAnglesOptions angles_of(const StraightCandidate& candidate);
[[nodiscard]] std::string describe(const StraightCandidate& candidate, Angle grid_north);

/// How much the simulator may be asked.
struct SearchBudget {
  int candidates = 100;
  int coarse = 1;             ///< see LineWorkshop::score
  bool steered = true;        ///< candidates are joined by ways that the vehicle can steer
  std::size_t finalists = 8;  ///< that are built and scored in full at the end
  /// Points of coverage an ideal length that finalists' rows are mixed for, block by block.
  std::vector<double> block_prices = {5.0, 9.0, 12.0};
  std::size_t curved_finalists = 3;  ///< of lines that bend, for each way to lay them
};

/// Tries straight lines in many directions and numbers, then varies those that nothing beats, until
/// the budget is spent. Of those that nothing beats some short and some dense ones are mixed block
/// by block. Returns the finalists of both, judged with the exact scorer.
[[nodiscard]] std::vector<JudgedCandidate> search_straight_lines(LineWorkshop& shop,
                                                                 const SearchBudget& budget);

}  // namespace swathplan
