#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "planners/adaptive/detection_curve.h"
#include "planners/adaptive/survey_track.h"

namespace swathplan {

/// Probability of having missed a target that lies in a cell: the product over all looks of 1 - P.
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
/// What the tracks leave behind over the area [0, width] x [0, length] when the sonar really does
/// as `truth` says, on both sides. @throws UsageError if an option breaks its rule.
[[nodiscard]] ResidualRiskMap residual_risk(std::span<const SurveyTrack> tracks,
                                            const DetectionCurve& truth,
                                            const RiskMapOptions& options);

/// The map without `margin_m` along its border, as far as whole cells go.
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
/// A mixture of `count` Gaussians (expectation maximisation, OpenCV's), ascending by mean, fitted
/// to at most 500 quantiles of the values and started from them: same values, same fit.
/// @throws InvalidInput if there are fewer values than ten per component.
[[nodiscard]] std::vector<MixtureComponent> fitted_mixture(std::span<const double> values,
                                                           int count);

}  // namespace swathplan
