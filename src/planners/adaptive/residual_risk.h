#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "planners/adaptive/detection_curve.h"
#include "planners/adaptive/survey_track.h"

namespace swathplan {

/// The probability that a target in a cell was missed: the product of 1 - P over all looks.
struct ResidualRiskMap {
  int columns = 0, rows = 0;  ///< across and along the tracks
  double cell_m = 5.0;
  std::vector<double> risk;  ///< rows x columns, row by row; 1 where no look gave data
};

struct RiskMapOptions {
  double width_m = 0.0, length_m = 0.0;
  double cell_m = 5.0;   ///< > 0
  double scatter = 0.0;  ///< relative standard deviation of P from cell to cell and look to look
  std::uint64_t seed = 1;
};
/// The risk that the tracks leave over the area [0, width] x [0, length]. `truth` is the sonar's
/// true detection curve on both sides. @throws UsageError if an option breaks its rule.
[[nodiscard]] ResidualRiskMap residual_risk(std::span<const SurveyTrack> tracks,
                                            const DetectionCurve& truth,
                                            const RiskMapOptions& options);

/// The map without the cells that lie wholly within `margin_m` of its border.
[[nodiscard]] ResidualRiskMap without_border(const ResidualRiskMap& map, double margin_m);

/// Share of cells with no look at all, [0, 1].
[[nodiscard]] double uncovered_share(const ResidualRiskMap& map);
/// Risks of the cells that had a look.
[[nodiscard]] std::vector<double> looked_at(const ResidualRiskMap& map);
/// Counts in `bins` equal classes over [0, 1].
[[nodiscard]] std::vector<int> histogram(std::span<const double> values, int bins);

/// One Gaussian of a mixture.
struct MixtureComponent {
  double mean = 0.0, sigma = 0.0, share = 0.0;
};
/// Fits a mixture of `count` Gaussians, ascending by mean, by OpenCV's expectation maximisation of
/// at most 500 quantiles of the values. The fit finds one of several optima; `start` chooses where
/// it begins. The same values and start always give the same fit.
/// @throws InvalidInput if there are fewer values than ten per component.
[[nodiscard]] std::vector<MixtureComponent> fitted_mixture(std::span<const double> values,
                                                           int count, std::uint64_t start = 1);

/// Means of the rightmost component over several fits.
struct WorstComponent {
  double median = 0.0;                 ///< over the starts, with the number of components asked for
  double lowest = 0.0, highest = 0.0;  ///< over all fits
};
/// Fits from `starts` starts with `count` components. With `neighbours` it fits with one component
/// less (but two at least) and with one more as well. Where the means lie far apart the data do not
/// tell one optimum from another, and none may be quoted alone.
/// @throws InvalidInput if there are fewer values than ten per component.
[[nodiscard]] WorstComponent worst_component(std::span<const double> values, int count,
                                             int starts = 9, bool neighbours = true);

}  // namespace swathplan
