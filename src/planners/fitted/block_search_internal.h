#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "planners/fitted/straight_search_internal.h"
#include "planners/fronts/row_blocks.h"

namespace swathplan {

/// Straight rows. Their direction and number may differ from block to block.
struct BlockedRows {
  std::vector<SurveyCurve> lines;
  StraightCandidate base;  ///< the rows have its swaths and fans
  Outcome outcome;         ///< estimated, see LineWorkshop::estimate
};

/// Lays the rows of a candidate anew, block by block, the largest block first. In each block it
/// tries one row more and one less, in the candidate's direction and across it. If the options give
/// the heading, only that direction is tried.
class BlockSearch {
 public:
  BlockSearch(const StraightCandidate& base, int coarse, LineWorkshop& shop);

  /// False where rows run to and fro over the whole area: there is nothing to mix.
  [[nodiscard]] bool has_blocks() const { return blocks_.lines.size() > 1; }
  /// The best rows that one round over the blocks finds: the most coverage, less `price` points for
  /// each ideal length. Empty: the base's rows are as good, or the rows were returned before. Rows
  /// that were judged for one price are not judged again for the next.
  [[nodiscard]] std::optional<BlockedRows> best_for(double price);

  /// Of the rows judged so far: those between two outcomes that lie farthest above the straight
  /// line from one to the other. Their length differs by kApart from both. Empty: there are none.
  [[nodiscard]] std::optional<BlockedRows> best_between(const Outcome& shorter,
                                                        const Outcome& longer);

  static constexpr double kApart = 0.01;  ///< share of a length
  static constexpr std::size_t kMostBlocks = 6;
  static constexpr double kLeastShare = 0.04;  ///< of the area; smaller blocks are not laid anew

 private:
  using Choice = std::vector<std::size_t>;  ///< which of its layouts each block takes
  [[nodiscard]] std::vector<std::size_t> largest() const;
  void add_layouts(std::size_t block);
  [[nodiscard]] std::vector<SurveyCurve> lines_for(const Choice& choice) const;
  [[nodiscard]] const Outcome& outcome_of(const Choice& choice);
  /// The rows, unless they were returned before.
  [[nodiscard]] std::optional<BlockedRows> taken(const Choice& choice);

  StraightCandidate base_;
  int coarse_;
  LineWorkshop& shop_;
  RowBlocks blocks_;
  std::vector<std::vector<std::vector<SurveyCurve>>> layouts_;  ///< of each block, the base's first
  std::map<Choice, Outcome> judged_;
  std::set<Choice> taken_;
};

}  // namespace swathplan
