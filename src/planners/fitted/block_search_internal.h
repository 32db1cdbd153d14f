#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "planners/fitted/straight_search_internal.h"
#include "planners/fronts/row_blocks.h"

namespace swathplan {

/// Straight rows whose direction and number differ from block to block.
struct BlockedRows {
  std::vector<SurveyCurve> lines;
  StraightCandidate base;  ///< whose swaths and fans they have
  Outcome outcome;         ///< estimated, see LineWorkshop::estimate
};

/// Lays the rows of a candidate anew in one of its blocks after the other, the largest first: in
/// its direction and, unless the options give the heading, across it; with one row more and less.
class BlockSearch {
 public:
  BlockSearch(const StraightCandidate& base, int coarse, LineWorkshop& shop);

  /// False where rows run to and fro over the whole area: there is nothing to mix.
  [[nodiscard]] bool has_blocks() const { return blocks_.lines.size() > 1; }
  /// The rows with the most coverage less `price` points for each ideal length that one round
  /// over the blocks finds. Empty: the base's are as good, or the rows were returned before. What
  /// was judged for one price is not judged again for the next.
  [[nodiscard]] std::optional<BlockedRows> best_for(double price);

  /// Of the rows judged so far whose lengths lie between those of two outcomes, and kApart off
  /// both, those farthest above the chord from one to the other. Empty: there are none.
  [[nodiscard]] std::optional<BlockedRows> best_between(const Outcome& shorter,
                                                        const Outcome& longer);

  static constexpr double kApart = 0.01;  ///< share of a length
  static constexpr std::size_t kMostBlocks = 6;
  static constexpr double kLeastShare = 0.04;  ///< of the area, of a block that is laid anew

 private:
  using Choice = std::vector<std::size_t>;  ///< which of its layouts each block takes
  [[nodiscard]] std::vector<std::size_t> largest() const;
  void add_layouts(std::size_t block);
  [[nodiscard]] std::vector<SurveyCurve> lines_for(const Choice& choice) const;
  [[nodiscard]] const Outcome& outcome_of(const Choice& choice);
  /// The rows, unless they were handed out before.
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
