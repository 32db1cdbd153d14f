#include "coverage/score.h"

#include <fmt/core.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>

#include "coverage/ping_tracer_internal.h"
#include "mesh/error.h"

namespace swathplan {

namespace {

// Pings of one task, and tasks between two counts: enough that the threads seldom wait for one
// another, few enough that the pings in flight stay under some megabytes a thread.
constexpr std::size_t kPingsPerBlock = 64;
constexpr std::size_t kBlocksPerThread = 16;

void check(const Route& route, const Sonar& sonar, const ScoreOptions& options) {
  if (const auto what = fault(route)) throw InvalidInput("the route cannot be scored: " + *what);
  if (sonar.beams < 2) {
    throw UsageError(fmt::format("beams = {}; must be at least 2", sonar.beams));
  }
  if (!(sonar.max_range_m > 0)) {
    throw UsageError(
        fmt::format("range of the sonar = {} m; must be greater than 0", sonar.max_range_m));
  }
  if (options.threads < 0) {
    throw UsageError(fmt::format("threads = {}; must be 0 (all cores) or more", options.threads));
  }
}

// More threads than cores only wait for one another.
int thread_count(const ScoreOptions& options) {
  const int cores = tbb::info::default_concurrency();
  return options.threads > 0 ? std::min(options.threads, cores) : cores;
}

// Counts over the cells of the area.
struct Tally {
  std::uint64_t cells = 0, hit = 0, hit_2 = 0, hit_5 = 0, footprint = 0;
  std::uint64_t logged_hit = 0, logged_2 = 0, logged_5 = 0, logged_footprint = 0, several = 0;
};

Tally tally(const CoverageGrid& grid) {
  Tally t;
  for (std::size_t i = 0; i < grid.words().size(); ++i) {
    if (!grid.counts(i)) continue;
    ++t.cells;
    const std::uint32_t n = grid.soundings(i);
    t.hit += n >= 1;
    t.hit_2 += n >= 2;
    t.hit_5 += n >= 5;
    const std::uint32_t logged = grid.logged_soundings(i);
    t.logged_hit += logged >= 1;
    t.logged_2 += logged >= 2;
    t.logged_5 += logged >= 5;
    t.footprint += grid.footprint(i);
    t.logged_footprint += grid.logged_footprint(i);
    t.several += grid.several_legs(i);
  }
  return t;
}

void fill_figures(const Tally& t, Score& score) {
  const auto share = [&](std::uint64_t n) {
    return t.cells > 0 ? 100.0 * static_cast<double>(n) / static_cast<double>(t.cells) : 0.0;
  };
  score.cells = t.cells;
  score.all = {share(t.hit), share(t.hit_2), share(t.hit_5), share(t.footprint)};
  score.logged = {share(t.logged_hit), share(t.logged_2), share(t.logged_5),
                  share(t.logged_footprint)};
  score.several_legs_pct = share(t.several);
  score.overlap =
      t.hit > 0 ? static_cast<double>(score.soundings) / static_cast<double>(t.hit) - 1.0 : 0.0;
}

// Trace a batch of blocks, then count it, until the route is sailed.
class Scorer {
 public:
  Scorer(const Route& route, const ScoringGround& ground, const Sonar& sonar, double draft_m,
         const ScoreOptions& options, CoverageGrid& grid)
      : options_(options),
        grid_(grid),
        walker_(route, options.ping_spacing_m, options.noise),
        arena_(thread_count(options)),
        tracers_([&ground, &sonar, draft_m, &grid, footprint = options.footprint] {
          return PingTracer(*ground.scene, sonar, draft_m, grid, footprint);
        }) {
    const auto threads = static_cast<std::size_t>(arena_.max_concurrency());
    pings_.resize(threads * kBlocksPerThread);
    traces_.resize(pings_.size());
  }

  void run(Score& score) {
    for (std::size_t blocks = read_pings(score); blocks > 0; blocks = read_pings(score)) {
      trace(blocks);
      for (std::size_t b = 0; b < blocks; ++b) score.rays += traces_[b].rays;
      score.soundings += count(blocks);
      if (options_.progress) options_.progress(walker_.progress(), score.rays);
    }
  }

 private:
  std::size_t read_pings(Score& score) {
    std::size_t blocks = 0;
    while (blocks < pings_.size() && walker_.next(kPingsPerBlock, pings_[blocks])) {
      score.pings += pings_[blocks++].size();
    }
    return blocks;
  }

  void trace(std::size_t blocks) {
    arena_.execute([&] {
      tbb::parallel_for(std::size_t{0}, blocks,
                        [&](std::size_t b) { tracers_.local().trace(pings_[b], traces_[b]); });
    });
  }

  std::uint64_t count(std::size_t blocks) {
    std::array<std::uint64_t, kBands> soundings{};
    arena_.execute([&] {
      tbb::parallel_for(std::uint32_t{0}, kBands, [&](std::uint32_t band) {
        soundings[band] = count_band({traces_.data(), blocks}, band, grid_);
      });
    });
    std::uint64_t sum = 0;
    for (const std::uint64_t n : soundings) sum += n;
    return sum;
  }

  const ScoreOptions& options_;
  CoverageGrid& grid_;
  PingWalker walker_;
  tbb::task_arena arena_;
  tbb::enumerable_thread_specific<PingTracer> tracers_;
  std::vector<std::vector<Ping>> pings_;
  std::vector<BlockTrace> traces_;
};

}  // namespace

ScoredRoute score(const Route& route, const ScoringGround& ground, const Sonar& sonar,
                  const Vehicle& vehicle, const ScoreOptions& options) {
  check(route, sonar, options);
  ScoredRoute result{{}, CoverageGrid(ground.survey_area, options.resolution_m)};
  Score& figures = result.score;
  figures.survey_area_m2 = area_m2(ground.survey_area);
  figures.footprint_width_m = footprint_width_m(sonar, options.resolution_m);
  Scorer(route, ground, sonar, vehicle.draft_m, options, result.grid).run(figures);
  fill_figures(tally(result.grid), figures);
  figures.route = route_figures(route, vehicle, ground.water, *ground.depths,
                                figures.survey_area_m2, figures.footprint_width_m);
  figures.holidays = find_holidays(result.grid, {.smallest_m2 = options.holiday_m2});
  return result;
}

}  // namespace swathplan
