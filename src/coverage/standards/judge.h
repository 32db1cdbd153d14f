#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "coverage/standards/criteria.h"
#include "mesh/base/frame.h"

namespace swathplan {

/// What a survey is predicted to leave in one cell of a criterion's grid.
struct JudgedCell {
  static constexpr float kNone = std::numeric_limits<float>::infinity();
  bool asked = false;           ///< of the area and of the grid's depths: it is judged
  std::uint8_t lines = 0;       ///< different lines with an accepted sounding; 2: two or more
  std::uint16_t soundings = 0;  ///< of logged lines; saturates
  std::uint16_t accepted = 0;   ///< of them, with TVU and THU within the limits
  float depth_m = 0.0F;
  float tvu_m = kNone, thu_m = kNone;                ///< smallest of all soundings
  float feature_pings = 0.0F, feature_beams = 0.0F;  ///< on a cube here, by the best pass
};

/// A grid of one cell size. Row 0 is the southernmost.
struct JudgedGrid {
  double cell_m = 1.0;
  Vec2 origin = Vec2::Zero();  ///< lower-left corner, local metres
  std::uint32_t columns = 0, rows = 0;
  std::vector<JudgedCell> cells;  ///< row by row

  [[nodiscard]] Vec2 centre(std::size_t i) const {
    const std::size_t row = i / columns;
    return origin +
           cell_m * Vec2(static_cast<double>(i % columns) + 0.5, static_cast<double>(row) + 0.5);
  }
};

/// Cells next to one another where a rule fails.
struct FailingPlace {
  Vec2 position = Vec2::Zero();  ///< centre of the cell nearest to their mean, local metres
  double area_m2 = 0.0;
};

/// One rule of a criterion, judged.
struct JudgedRule {
  std::string name;
  std::string asks;         ///< and its source, where that is not the standard
  double figure_pct = 0.0;  ///< of the cells that the rule is about
  std::string figure;       ///< the same in words
  bool pass = false;
  double failing_m2 = 0.0;
  std::size_t failing_places = 0;
  std::vector<FailingPlace> where;  ///< the largest of them
};

struct Verdict {
  std::string criterion, title;
  bool pass = false;
  std::vector<JudgedRule> rules;
  double judged_m2 = 0.0;
};

struct JudgeOptions {
  std::size_t list_at_most = 20;  ///< places a rule
};

/// Judges a survey by a criterion, on the criterion's own cells: one grid for each cell size that
/// the depths ask for. Cells that are not asked for count as covered.
/// Guarantees: (1) the verdict passes if and only if each rule does; (2) a rule that fails names at
/// least one place, unless it is about cells with soundings and there is none; one that passes may
/// name some, for a share of the cells may fail.
/// O(cells). @throws InvalidInput if no cell is asked for.
[[nodiscard]] Verdict judge(const Criterion& criterion, std::span<const JudgedGrid> grids,
                            const JudgeOptions& options = {});

/// How far apart depths may lie where a criterion does not ask for all of the ground
/// (GapRule::spread), metres.
[[nodiscard]] double depths_apart_m(double mean_depth_m);

/// "predicted to pass IHO S-44 Special Order", or to fail, and by which rules.
[[nodiscard]] std::string sentence(const Verdict& verdict);

}  // namespace swathplan
