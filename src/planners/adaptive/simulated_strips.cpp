#include "planners/adaptive/simulated_strips.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mesh/base/error.h"
#include "mesh/base/random.h"

namespace swathplan {
namespace {

constexpr float kNothing = 0.1F;
constexpr float kObject = 1.0F;
constexpr int kColumns = 8;  // of an abstract cost map: an eighth of a strip each

// Columns beyond the strip take in the nadir gap of the neighbouring track.
CostMap side_map(const StripWorld& world, double from, double sign, const AccordionOptions& o) {
  const double step = o.spacing_m / kColumns;
  const int columns = kColumns + static_cast<int>(std::ceil(o.nadir_gap_m / step - 1e-9));
  CostMap map{1, columns, 0.0, step, {}};
  map.values.assign(static_cast<std::size_t>(columns), kNothing);
  const double range = sonar_range_m(o);
  const double low = sign > 0.0 ? from : from - range;
  auto at = std::lower_bound(world.objects_m.begin(), world.objects_m.end(), low);
  for (; at != world.objects_m.end() && *at <= low + range; ++at) {
    const int column = static_cast<int>(std::abs(*at - from) / map.step_m);
    map.values[static_cast<std::size_t>(std::min(column, columns - 1))] = kObject;
  }
  return map;
}

}  // namespace

StripWorld random_strips(double width_m, double spacing_m, double share, std::uint64_t seed) {
  if (!(share >= 0.0 && share <= 1.0)) {
    throw UsageError("p obj", fmt::format("{}", share), "must lie in [0, 1]");
  }
  const auto count = static_cast<std::size_t>(std::ceil(width_m / spacing_m - 1e-9));
  const auto chosen = static_cast<std::size_t>(std::lround(share * static_cast<double>(count)));
  std::vector<std::size_t> strips(count);
  std::iota(strips.begin(), strips.end(), std::size_t{0});
  SeededNumbers numbers(seed);
  StripWorld world;
  for (std::size_t i = 0; i < chosen; ++i) {
    std::swap(strips[i], strips[i + numbers.below(count - i)]);
    const double low = static_cast<double>(strips[i]) * spacing_m;
    const double high = std::min(low + spacing_m, width_m);
    world.objects_m.push_back(low + (high - low) * (0.125 + 0.75 * numbers.uniform()));
  }
  std::sort(world.objects_m.begin(), world.objects_m.end());
  return world;
}

AccordionObservation observe_world(const StripWorld& world, const AccordionOptions& options,
                                   const SurveyTrack& track) {
  return {side_map(world, track.across_m, -1.0, options),
          side_map(world, track.across_m, 1.0, options)};
}

AccordionMission sail(const StripWorld& world, const AccordionOptions& options) {
  AccordionMission mission{start_accordion(options)};
  while (const auto track = next_track(mission.state)) {
    mission.state =
        observe(std::move(mission.state), *track, observe_world(world, options, *track));
  }
  mission.objects = static_cast<int>(world.objects_m.size());
  for (const double x : world.objects_m) {
    if (mission.state.seen_from_below.covers({x, x}) &&
        mission.state.seen_from_above.covers({x, x})) {
      ++mission.objects_seen_twice;
    }
  }
  return mission;
}

AccordionGain gain(const AccordionState& state) {
  const AccordionOptions& o = state.options;
  const auto lawnmower = overlapping_lawnmower(o.width_m, o.spacing_m);
  const auto better = [](double ours, double theirs) { return 100.0 * (theirs - ours) / theirs; };
  return {better(state.sailed_m, mission_length_m(lawnmower, o.length_m)),
          better(length_until_m(state.sailed, o.length_m, o.width_m),
                 length_until_m(lawnmower, o.length_m, o.width_m))};
}

}  // namespace swathplan
