#include "planners/adaptive/spacing_missions.h"

#include <cmath>

#include "mesh/base/random.h"

namespace swathplan {

DetectionCurve observe_world(const SpacingWorld& world, const SurveyTrack& track) {
  if (world.trials <= 0) return world.truth;
  DetectionCounts counts;
  counts.step_m = world.bin_m;
  SeededNumbers numbers(mixed_seed(world.seed, 7, static_cast<std::uint64_t>(track.number)));
  // Bins reach past the sonar's real range, or the estimate could not find its end.
  const int bins = static_cast<int>(std::ceil(1.5 * world.truth.range_m.back() / world.bin_m));
  for (int i = 0; i < bins; ++i) {
    std::int64_t found = 0;
    for (int k = 0; k < world.trials; ++k) {
      const double range = (i + numbers.uniform()) * world.bin_m;
      if (numbers.uniform() < detection(world.truth, range)) ++found;
    }
    counts.trials.push_back(world.trials);
    counts.detections.push_back(found);
  }
  return estimated_curve(counts);
}

SpacingMission sail(const TrackSpacingOptions& options, const SpacingWorld& world) {
  SpacingMission mission{start_spacing(options), {}};
  while (const auto track = next_track(mission.state)) {
    mission.state = observe(std::move(mission.state), *track, observe_world(world, *track));
  }
  mission.risk = residual_risk(mission.state.sailed, world.truth,
                               {.width_m = options.width_m,
                                .length_m = options.length_m,
                                .scatter = world.scatter,
                                .seed = world.seed});
  return mission;
}

}  // namespace swathplan
