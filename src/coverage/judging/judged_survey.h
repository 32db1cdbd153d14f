#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "coverage/ground.h"
#include "coverage/judging/judged_soundings.h"
#include "coverage/judging/out_of_reach.h"
#include "coverage/score.h"
#include "coverage/standards/judge.h"
#include "coverage/standards/uncertainty.h"

namespace swathplan {

/// The smallest uncertainty of each cell of a scoring grid; row 0 is the southernmost.
struct UncertaintyRaster {
  double cell_m = 1.0;
  Vec2 origin = Vec2::Zero();  ///< lower-left corner, local metres
  std::uint32_t columns = 0, rows = 0;
  std::vector<float> tvu_m, thu_m;  ///< infinite where no sounding of a logged line fell
  std::vector<float> tvu_share;     ///< smallest share of the TVU's limit
};

/// Soundings by the share of their TVU in its limit: from 0, each bin kTvuBin wide, the last one
/// open.
inline constexpr std::size_t kTvuBins = 21;
inline constexpr double kTvuBin = 0.1;

/// A survey as a criterion sees it before it is sailed.
struct JudgedSurvey {
  Verdict verdict;
  UncertaintyRaster raster;
  std::array<std::uint64_t, kTvuBins> tvu_histogram{};
  std::uint64_t pings = 0, soundings = 0;  ///< of logged lines; soundings that fell in the area
  std::uint64_t accepted = 0;              ///< of them, with TVU and THU within the limits
  OutOfReach out_of_reach;                 ///< of the area; it is not judged
};

struct JudgingOptions {
  /// The ground between the points of the seafloor's data is known to be smooth: it may be judged
  /// on finer cells than they show.
  bool smooth_seafloor = false;
  JudgeOptions rules;
};

/// Takes soundings as they come in.
using TakeSoundings = std::function<void(std::span<const JudgedSounding>)>;

/// Judges routes over one ground by one criterion; what costs nothing but ground is made once.
class SurveyJudge {
 public:
  /// Keeps what `ground` points to, and the criterion.
  /// @throws UsageError if the budget lacks a deviation, if the criterion's cells are finer than
  /// the
  ///   seafloor's data and smooth_seafloor is not set, or if there are too many of them.
  SurveyJudge(const Ground& ground, const Criterion& criterion, const UncertaintyBudget& budget,
              const JudgingOptions& options = {});

  /// Traces the logged pings of the route and judges their soundings, on the criterion's own grids.
  /// `scoring` says how pings fall, with which tracking errors, and on which cells the raster lies.
  /// Guarantees: the same result for any number of threads.
  /// @throws InvalidInput for a route that is not valid or an area without a cell.
  [[nodiscard]] JudgedSurvey judge(const Route& route, const Sonar& sonar, const Vehicle& vehicle,
                                   const ScoreOptions& scoring) const;
  /// The same up to the cells: nothing is left out of them or judged yet.
  [[nodiscard]] std::vector<JudgedGrid> filled(const Route& route, const Sonar& sonar,
                                               const Vehicle& vehicle,
                                               const ScoreOptions& scoring) const;
  /// Traces the logged pings alone: `take` is given their soundings in the order of the route, some
  /// at a time, by the calling thread. @throws InvalidInput for a route that is not valid.
  void sound(const Route& route, const Sonar& sonar, const Vehicle& vehicle,
             const ScoreOptions& scoring, const TakeSoundings& take) const;

  [[nodiscard]] const Ground& ground() const { return ground_; }
  [[nodiscard]] const Criterion& criterion() const { return *criterion_; }
  [[nodiscard]] const UncertaintyModel& uncertainty() const { return model_; }
  /// The criterion's grids (criterion_grids.h), without soundings.
  [[nodiscard]] const std::vector<JudgedGrid>& grids() const { return grids_; }

 private:
  [[nodiscard]] std::vector<JudgedGrid> traced(const Route& route, const Sonar& sonar,
                                               const Vehicle& vehicle, const ScoreOptions& scoring,
                                               JudgedSurvey& result) const;
  /// Returns the logged pings.
  std::uint64_t trace(const Route& route, const Sonar& sonar, const Vehicle& vehicle,
                      const ScoreOptions& scoring, const CoverageGrid& cells,
                      const TakeSoundings& take) const;

  Ground ground_;
  const Criterion* criterion_;
  UncertaintyModel model_;
  JudgingOptions options_;
  std::vector<JudgedGrid> grids_;  ///< without soundings
};

}  // namespace swathplan
