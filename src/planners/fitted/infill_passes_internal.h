#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "planners/fitted/line_workshop.h"

namespace swathplan {

/// A straight pass over gaps.
struct InfillPass {
  Vec2 from = Vec2::Zero(), to = Vec2::Zero();
  double gain_m2 = 0.0;  ///< empty cells in its swath
};

/// Finds the straight pass that sweeps the most empty ground.
class EmptyGround {
 public:
  /// `least_gain_m` square metres of new cover per metre make a pass worth sailing.
  EmptyGround(const CoverageGrid& grid, LineWorkshop& shop, double least_gain_m,
              double smallest_m2);

  /// The pass with the most worth: its gain, less least_gain_m x (its length + `detour`). From then
  /// on its swath counts as covered. Empty: no pass is worth anything.
  [[nodiscard]] std::optional<InfillPass> take_best(
      const std::function<double(const InfillPass&)>& detour);

 private:
  struct Heading {
    Vec2 along, across, origin;
    std::size_t columns = 0, rows = 0;  ///< along, across
    std::vector<float> empty;           ///< square metres a bin
  };
  struct Row {
    double bound = 0.0;
    std::size_t heading = 0, row = 0;
  };
  [[nodiscard]] InfillPass best_on(const Heading& heading, std::size_t row) const;
  [[nodiscard]] double swath_gain(const Heading& heading, std::size_t column, std::size_t row,
                                  double width) const;
  void sweep(const InfillPass& pass);

  LineWorkshop& shop_;
  const std::vector<float>& width_;
  double sure_;  ///< share of the swath that a pass may count on
  double least_gain_;
  double bin_;
  std::vector<std::pair<Vec2, double>> empties_;  ///< centre, square metres
  std::vector<Heading> headings_;
  std::vector<Row> rows_;  ///< a heap by bound
};

}  // namespace swathplan
