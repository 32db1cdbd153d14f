#include "coverage/score.h"

#include <fmt/core.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <bit>
#include <functional>

#include "coverage/tracing/ping_tracer.h"
#include "mesh/base/error.h"
#include "mesh/base/parallel.h"

namespace swathplan {

namespace {

// Pings of one task, and tasks of a thread between two counts. With fewer the threads would wait
// for one another; with more the pings in flight would take more than some megabytes a thread.
constexpr std::size_t kPingsPerBlock = 64;
constexpr std::size_t kBlocksPerThread = 24;

void check(const Route& route, const Sonar& sonar, const ScoreOptions& options) {
  if (const auto what = fault(route)) throw InvalidInput("the route cannot be scored: " + *what);
  if (sonar.beams < 2) {
    throw UsageError("beams", fmt::format("{}", sonar.beams), "must be at least 2");
  }
  if (!(sonar.max_range_m > 0)) {
    throw UsageError(
        fmt::format("range of the sonar = {} m; must be greater than 0", sonar.max_range_m));
  }
  if (!(options.swath_share > 0.0) || options.swath_share > 1.0) {
    throw UsageError(
        fmt::format("share of the swath = {}; must be above 0 and at most 1", options.swath_share));
  }
  if (options.threads < 0) {
    throw UsageError("threads", fmt::format("{}", options.threads),
                     "must be 0 (all cores) or more");
  }
}

// More threads than cores would only wait for one another.
int thread_count(const ScoreOptions& options) {
  const int cores = tbb::info::default_concurrency();
  return options.threads > 0 ? std::min(options.threads, cores) : cores;
}

// Each thread gets several bands, so that none waits long for another. One thread needs one band.
std::uint32_t bands_for(int threads) {
  return threads > 1 ? std::bit_ceil(static_cast<std::uint32_t>(threads)) * 4U : 1U;
}

// Counts over the cells of the area.
struct Tally {
  std::uint64_t cells = 0, hit = 0, hit_2 = 0, hit_5 = 0, footprint = 0;
  std::uint64_t logged_hit = 0, logged_2 = 0, logged_5 = 0, logged_footprint = 0, several = 0;
};

// Counts of one row in 32 bits and without branches, so that it becomes vector code.
SWATHPLAN_EVERY_CPU
void tally_row(const std::uint32_t* words, std::size_t n, std::uint32_t* counts) {
  std::uint32_t cells = 0, hit = 0, hit_2 = 0, hit_5 = 0, footprint = 0;
  std::uint32_t logged_hit = 0, logged_2 = 0, logged_5 = 0, logged_footprint = 0, several = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t w = (words[i] & CoverageGrid::kInArea) != 0 ? words[i] : 0U;
    const std::uint32_t count = w & CoverageGrid::kCountMask;
    const std::uint32_t logged = (w >> CoverageGrid::kLoggedShift) & 7U;
    cells += w != 0 ? 1U : 0U;
    hit += count >= 1 ? 1U : 0U;
    hit_2 += count >= 2 ? 1U : 0U;
    hit_5 += count >= 5 ? 1U : 0U;
    footprint += (w & CoverageGrid::kFootprint) != 0 ? 1U : 0U;
    logged_hit += logged >= 1 ? 1U : 0U;
    logged_2 += logged >= 2 ? 1U : 0U;
    logged_5 += logged >= 5 ? 1U : 0U;
    logged_footprint += (w & CoverageGrid::kLoggedFootprint) != 0 ? 1U : 0U;
    several += w >> CoverageGrid::kLegShift == CoverageGrid::kLegMask ? 1U : 0U;
  }
  const std::array<std::uint32_t, 10> all{
      cells,  hit, hit_2, hit_5, footprint, logged_hit, logged_2, logged_5, logged_footprint,
      several};
  std::copy(all.begin(), all.end(), counts);
}

using Sums = std::array<std::uint64_t, 10>;

Sums sums_of_rows(const CoverageGrid& grid, std::uint32_t first, std::uint32_t end, Sums sums) {
  std::array<std::uint32_t, 10> counts{};
  for (std::size_t row = first; row < end; ++row) {
    tally_row(grid.words().data() + row * grid.columns(), grid.columns(), counts.data());
    for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += counts[k];
  }
  return sums;
}

Tally tally(const CoverageGrid& grid) {
  constexpr std::uint32_t kRows = 64;
  std::vector<Sums> parts((grid.rows() + kRows - 1) / kRows);
  for_each_index(std::size_t{0}, parts.size(), [&](std::size_t part) {
    const auto first = static_cast<std::uint32_t>(part) * kRows;
    parts[part] = sums_of_rows(grid, first, std::min(first + kRows, grid.rows()), Sums{});
  });
  Sums s{};
  for (const Sums& part : parts) {
    std::transform(s.begin(), s.end(), part.begin(), s.begin(), std::plus<>());
  }
  return {s[0], s[1], s[2], s[3], s[4], s[5], s[6], s[7], s[8], s[9]};
}

void fill_figures(const Tally& t, bool footprint, Score& score) {
  const auto share = [&](std::uint64_t n) {
    return t.cells > 0 ? 100.0 * static_cast<double>(n) / static_cast<double>(t.cells) : 0.0;
  };
  score.cells = t.cells;
  score.all = {share(t.hit), share(t.hit_2), share(t.hit_5), {}};
  score.logged = {share(t.logged_hit), share(t.logged_2), share(t.logged_5), {}};
  if (footprint) {
    score.all.footprint_pct = share(t.footprint);
    score.logged.footprint_pct = share(t.logged_footprint);
  }
  score.several_legs_pct = share(t.several);
  score.overlap =
      t.hit > 0 ? static_cast<double>(score.soundings) / static_cast<double>(t.hit) - 1.0 : 0.0;
}

// Where a ping can see data at all.
Box2 within_reach(const Ground& ground, const Sonar& sonar, const TrackNoise& noise) {
  constexpr double kFarthest = 10.0;  // of a boat from its track, in standard deviations
  const double reach = sonar.max_range_m + kFarthest * noise.lateral_sigma_m;
  Box2 box = extent(*ground.seafloor);
  box.min.array() -= reach;
  box.max.array() += reach;
  return box;
}

// A batch of blocks of pings on their way through the scorer.
struct Batch {
  std::vector<std::vector<Ping>> pings;
  std::vector<BlockHits> hits;  // by the clock
  std::size_t blocks = 0;
};

// Traces a batch of blocks, then counts it, until the route is sailed.
class Scorer {
 public:
  Scorer(const Route& route, const Ground& ground, const Sonar& sonar, double draft_m,
         const ScoreOptions& options, tbb::task_arena& arena, CoverageGrid& grid)
      : options_(options),
        grid_(grid),
        walker_(route, sonar, options.pings, options.noise,
                within_reach(ground, sonar, options.noise)),
        arena_(arena),
        bands_{bands_for(arena_.max_concurrency())},
        tracers_([&ground, &sonar, draft_m, &grid, &options, bands = bands_] {
          return PingTracer(*ground.scene, sonar, draft_m, grid, bands, options.footprint,
                            options.swath_share);
        }),
        chain_(*ground.scene, sonar, draft_m, grid, bands_, false, options.swath_share) {
    const auto threads = static_cast<std::size_t>(arena_.max_concurrency());
    const std::size_t blocks = threads * kBlocksPerThread;
    for (Batch* batch : {&now_, &next_}) {
      batch->pings.resize(blocks);
      batch->hits.resize(blocks);
    }
    traces_.resize(blocks);
  }

  void run(Score& score) {
    if (walker_.by_the_clock()) {
      follow_the_clock(score);
    } else {
      for (read_pings(now_, score); now_.blocks > 0; read_pings(now_, score)) {
        trace(now_);
        count(now_, score);
      }
    }
    score.pinging = walker_.figures();
  }

 private:
  void read_pings(Batch& batch, Score& score) {
    batch.blocks = 0;
    while (batch.blocks < batch.pings.size() &&
           walker_.next(kPingsPerBlock, batch.pings[batch.blocks])) {
      score.pings += batch.pings[batch.blocks++].size();
    }
  }

  // The next ping hangs on the last one's soundings: rays are traced along the chain, by one
  // thread, while all others sort the batch before.
  void follow_the_clock(Score& score) {
    read_chain(now_, score);
    while (now_.blocks > 0) {
      arena_.execute([&] { run_both([&] { read_chain(next_, score); }, [&] { sort(now_); }); });
      count(now_, score);
      std::swap(now_, next_);
    }
  }

  void read_chain(Batch& batch, Score& score) {
    batch.blocks = 0;
    while (batch.blocks < batch.pings.size()) {
      BlockHits& hits = batch.hits[batch.blocks];
      hits.floats.clear();
      hits.starts.clear();
      const auto farthest = [&](const Ping& ping) {
        return static_cast<double>(chain_.trace_rays(ping, hits));
      };
      if (!walker_.next(kPingsPerBlock, batch.pings[batch.blocks], farthest)) break;
      score.pings += batch.pings[batch.blocks++].size();
    }
  }

  void sort(Batch& batch) {
    for_each_index(std::size_t{0}, batch.blocks, [&](std::size_t b) {
      tracers_.local().sort_soundings(batch.pings[b], batch.hits[b], traces_[b]);
    });
  }

  void trace(const Batch& batch) {
    arena_.execute([&] {
      for_each_index(std::size_t{0}, batch.blocks,
                     [&](std::size_t b) { tracers_.local().trace(batch.pings[b], traces_[b]); });
    });
  }

  void count(const Batch& batch, Score& score) {
    std::vector<std::uint64_t> soundings(bands_.count, 0);
    arena_.execute([&] {
      for_each_index(std::uint32_t{0}, bands_.count, [&](std::uint32_t band) {
        soundings[band] = count_band({traces_.data(), batch.blocks}, bands_, band, grid_);
      });
    });
    for (const std::uint64_t n : soundings) score.soundings += n;
    for (std::size_t b = 0; b < batch.blocks; ++b) score.rays += traces_[b].rays;
    if (options_.logged_cells) hand_out(batch);
    if (options_.progress) options_.progress(walker_.progress(), score.rays);
  }

  void hand_out(const Batch& batch) const {
    for (std::size_t b = 0; b < batch.blocks; ++b) {
      for (const std::vector<CellRun>& runs : traces_[b].runs) {
        for (const CellRun& run : runs) {
          if (!run.log) continue;
          options_.logged_cells(run.leg, std::span(traces_[b].cells).subspan(run.first, run.count));
        }
      }
    }
  }

  const ScoreOptions& options_;
  CoverageGrid& grid_;
  PingWalker walker_;
  tbb::task_arena& arena_;
  Bands bands_;
  tbb::enumerable_thread_specific<PingTracer> tracers_;
  PingTracer chain_;
  Batch now_, next_;
  std::vector<BlockTrace> traces_;
};

}  // namespace

ScoredRoute score(const Route& route, const Ground& ground, const Sonar& sonar,
                  const Vehicle& vehicle, const ScoreOptions& options) {
  check(route, sonar, options);
  tbb::task_arena arena(thread_count(options));
  ScoredRoute result = arena.execute([&] {
    return ScoredRoute{{}, CoverageGrid(ground.survey_area, options.resolution_m, ground.lattice)};
  });
  Score& figures = result.score;
  figures.survey_area_m2 = area_m2(ground.survey_area);
  figures.footprint_width_m = footprint_width_m(sonar, options.resolution_m);
  Scorer(route, ground, sonar, vehicle.draft_m, options, arena, result.grid).run(figures);
  arena.execute([&] {
    fill_figures(tally(result.grid), options.footprint, figures);
    figures.logged_counts = options.logged_counts;
    figures.holidays = find_holidays(result.grid, {.smallest_m2 = options.holiday_m2,
                                                   .logged_only = options.logged_counts,
                                                   .outline_corners = options.outline_corners});
  });
  figures.route = route_figures(route, vehicle, ground.water, *ground.depths,
                                figures.survey_area_m2, figures.footprint_width_m);
  return result;
}

}  // namespace swathplan
