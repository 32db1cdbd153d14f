#include "planners/adaptive/quality_baselines.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "mesh/base/error.h"
#include "planners/adaptive/quality_swaths_internal.h"

namespace swathplan {
namespace {

// What is covered from the first uncovered swath on: bit i = swath `first + i`.
struct Frontier {
  int first = 0;
  std::uint64_t beyond = 0;
  auto operator<=>(const Frontier&) const = default;  // NOLINT(modernize-use-nullptr): its bug
};

struct Step {
  Frontier from;
  SurveyTrack track;
};
using Level = std::map<Frontier, Step>;

constexpr int kWindow = 64;  // swaths that a frontier can hold

// Swaths that a track covers, ascending, inside the area or not.
std::vector<int> swaths_of(const QualitySurveyOptions& o, const TrueQuality& truth,
                           const SurveyTrack& track) {
  std::vector<int> result;
  for (const bool back : {true, false}) {
    const bool port = back == (track.outbound == o.port_looks_back);
    const std::vector<char>& good = port ? truth.port : truth.starboard;
    for (int bin = 0; bin < static_cast<int>(good.size()); ++bin) {
      if (good[static_cast<std::size_t>(bin)])
        result.push_back(swath_at(o, track.across_m, back, bin));
    }
  }
  return result;
}

// The frontier after a track, if the track covers the first uncovered swath.
std::optional<Frontier> advanced(const Frontier& from, const std::vector<int>& swaths, int count) {
  if (std::find(swaths.begin(), swaths.end(), from.first) == swaths.end()) return std::nullopt;
  std::uint64_t beyond = from.beyond;
  for (const int s : swaths) {
    if (s >= from.first && s < count) beyond |= std::uint64_t{1} << (s - from.first);
  }
  const int run = std::countr_one(beyond);
  return Frontier{from.first + run, run == kWindow ? 0 : beyond >> run};
}

struct Option {
  SurveyTrack track;
  std::vector<int> swaths;
};

std::vector<Option> all_options(const QualitySurveyOptions& o, const TrueQuality& truth) {
  std::vector<Option> result;
  const bool same_sides = truth.port == truth.starboard;
  for (int i = 0; i <= swath_count(o); ++i) {
    for (const bool outbound : {true, false}) {
      if (!outbound && same_sides) continue;
      const SurveyTrack track{0, i * o.swath_m, outbound};
      result.push_back({track, swaths_of(o, truth, track)});
    }
  }
  return result;
}

Level expand(const Level& level, const std::vector<Option>& options, int count) {
  Level next;
  int farthest = 0;
  for (const auto& [frontier, step] : level) {
    for (const Option& option : options) {
      const auto to = advanced(frontier, option.swaths, count);
      if (!to) continue;
      next.try_emplace(*to, Step{frontier, option.track});
      farthest = std::max(farthest, to->first);
    }
  }
  // A frontier more than a window behind another has covered nothing that the other has not.
  std::erase_if(next, [&](const auto& entry) { return entry.first.first + kWindow <= farthest; });
  return next;
}

// Drops each frontier whose coverage lies inside that of another frontier of its level: it cannot
// lead to fewer tracks.
void drop_dominated(Level& level) {
  std::vector<Frontier> kept;
  for (auto at = level.rbegin(); at != level.rend(); ++at) {
    const Frontier& f = at->first;
    const bool dominated = std::any_of(kept.begin(), kept.end(), [&](const Frontier& k) {
      const int shift = k.first - f.first;
      const std::uint64_t rest = shift >= kWindow ? 0 : f.beyond >> shift;
      return (rest & ~k.beyond) == 0;
    });
    if (!dominated) kept.push_back(f);
  }
  std::erase_if(level, [&](const auto& entry) {
    return std::find(kept.begin(), kept.end(), entry.first) == kept.end();
  });
}

void note(QualitySurveyState& state, const SurveyTrack& track, const TrueQuality& truth) {
  for (const int s : swaths_of(state.options, truth, track)) {
    if (s >= 0 && s < static_cast<int>(state.covered.size())) {
      state.covered[static_cast<std::size_t>(s)] = 1;
    }
  }
  state.sailed.push_back(track);
}

}  // namespace

TrueQuality true_quality(const QualitySurveyOptions& o, double port_m, double starboard_m) {
  TrueQuality truth;
  for (int bin = 0; bin < range_bins(o); ++bin) {
    const double far = o.range_min_m + (bin + 1) * o.swath_m;
    truth.port.push_back(far <= port_m + 1e-9 ? 1 : 0);
    truth.starboard.push_back(far <= starboard_m + 1e-9 ? 1 : 0);
  }
  return truth;
}

QualityObservation observe_world(const TrueQuality& truth) {
  return {{truth.port.begin(), truth.port.end()}, {truth.starboard.begin(), truth.starboard.end()}};
}

QualitySurveyState sail(const QualitySurveyOptions& options, const TrueQuality& truth) {
  QualitySurveyState state = start_survey(options);
  const QualityObservation observation = observe_world(truth);
  while (const auto track = next_track(state)) {
    state = observe(std::move(state), *track, observation);
  }
  return state;
}

QualitySurveyState sail_preplanned(const QualitySurveyOptions& o, const TrueQuality& truth) {
  QualitySurveyState state = start_survey(o);
  const double apart = o.range_max_m - o.range_min_m;
  double edge = 0.0;
  int number = 0;
  while (edge < o.width_m) {
    const double first = edge + o.range_max_m;
    const bool single = o.width_m - edge <= apart;
    note(state, {number, first, number % 2 == 0}, truth);
    ++number;
    if (single) break;
    note(state, {number, first + apart, number % 2 == 0}, truth);
    ++number;
    edge += 3.0 * o.range_max_m - o.range_min_m;
  }
  return state;
}

bool optimum_known(const QualitySurveyOptions& o) {
  // A track that covers the first gap with its near side reaches this far beyond the gap.
  return std::lround(2.0 * o.range_max_m / o.swath_m) < kWindow;
}

std::vector<SurveyTrack> fewest_tracks(const QualitySurveyOptions& o, const TrueQuality& truth) {
  check(o);
  const int count = swath_count(o);
  if (!optimum_known(o)) {
    throw UsageError(
        fmt::format("swath = {} m; the exact optimum needs twice the largest range "
                    "within {} swaths, so take a wider swath",
                    o.swath_m, kWindow));
  }
  const auto options = all_options(o, truth);
  std::vector<Level> levels{Level{{Frontier{}, Step{}}}};
  while (levels.back().rbegin()->first.first < count) {
    Level next = expand(levels.back(), options, count);
    if (next.empty()) return {};
    drop_dominated(next);
    levels.push_back(std::move(next));
  }
  std::vector<SurveyTrack> tracks;
  Frontier at = levels.back().rbegin()->first;
  for (std::size_t i = levels.size() - 1; i > 0; --i) {
    const Step& step = levels[i].at(at);
    tracks.push_back(step.track);
    at = step.from;
  }
  std::reverse(tracks.begin(), tracks.end());
  for (std::size_t i = 0; i < tracks.size(); ++i) tracks[i].number = static_cast<int>(i);
  return tracks;
}

double travel_m(const std::vector<SurveyTrack>& tracks, double length_m) {
  if (tracks.empty()) return 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    sum += length_m;
    if (i == 0) continue;
    const double way_back = tracks[i].outbound == tracks[i - 1].outbound ? length_m : 0.0;
    sum += std::hypot(tracks[i].across_m - tracks[i - 1].across_m, way_back);
  }
  return sum;
}

}  // namespace swathplan
