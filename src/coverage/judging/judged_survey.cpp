#include "coverage/judging/judged_survey.h"

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>

#include "coverage/judging/criterion_grids.h"
#include "coverage/judging/judged_soundings.h"
#include "mesh/base/error.h"
#include "mesh/base/parallel.h"

namespace swathplan {

namespace {

constexpr std::size_t kPingsPerJudgingBlock = 64;
constexpr std::size_t kBlocksPerJudgingThread = 16;
// Data a little coarser than the cells, as 0.5000001 m, is no reason to refuse.
constexpr double kSpacingShare = 1.01;

void check_data(const Criterion& criterion, const std::vector<JudgedGrid>& grids,
                const Seafloor& seafloor) {
  const double spacing = data_spacing_m(seafloor);
  for (const JudgedGrid& grid : grids) {
    if (spacing <= kSpacingShare * grid.cell_m) continue;
    throw UsageError(
        "criteria", std::string(criterion.name),
        fmt::format("it judges cells of {:g} m and the seafloor is known by points {:.3g} m apart: "
                    "give finer data or another criterion, or say <smooth seafloor> where the "
                    "ground between them is known to be smooth",
                    grid.cell_m, spacing));
  }
}

UncertaintyRaster empty_raster(const CoverageGrid& grid) {
  UncertaintyRaster raster;
  raster.cell_m = grid.resolution_m();
  raster.origin = grid.origin();
  raster.columns = grid.columns();
  raster.rows = grid.rows();
  raster.tvu_m.assign(grid.words().size(), JudgedCell::kNone);
  raster.thu_m = raster.tvu_share = raster.tvu_m;
  return raster;
}

// The cell of a square grid that a point falls in; empty outside.
template <class Grid>
std::optional<std::size_t> cell_at(const Grid& grid, const Vec2& p) {
  const Vec2 at = (p - grid.origin) / grid.cell_m;
  if (!(at.x() >= 0.0 && at.y() >= 0.0 && at.x() < grid.columns && at.y() < grid.rows)) return {};
  return static_cast<std::size_t>(at.y()) * grid.columns + static_cast<std::size_t>(at.x());
}

// How many times over the strikes asked for the cube is met: the fewer of both ways.
float strikes(float pings, float beams) { return std::min(pings, beams); }

// One grid while soundings come in.
struct FillingGrid {
  JudgedGrid* grid;
  std::vector<std::uint32_t> first_line;  // with an accepted sounding; 0: none

  explicit FillingGrid(JudgedGrid& g) : grid(&g), first_line(g.cells.size(), 0) {}

  // False outside the area.
  bool add(const JudgedSounding& s) {
    const std::optional<std::size_t> i = cell_at(*grid, s.position);
    if (!i) return false;
    JudgedCell& cell = grid->cells[*i];
    constexpr std::uint16_t kFull = 65535;
    cell.soundings = static_cast<std::uint16_t>(cell.soundings + (cell.soundings < kFull ? 1 : 0));
    cell.tvu_m = std::min(cell.tvu_m, s.tvu_m);
    cell.thu_m = std::min(cell.thu_m, s.thu_m);
    if (!s.accepted) return cell.asked;
    cell.accepted = static_cast<std::uint16_t>(cell.accepted + (cell.accepted < kFull ? 1 : 0));
    if (strikes(s.feature_pings, s.feature_beams) >
        strikes(cell.feature_pings, cell.feature_beams)) {
      cell.feature_pings = s.feature_pings;
      cell.feature_beams = s.feature_beams;
    }
    std::uint32_t& first = first_line[*i];
    if (first == 0) first = s.line;
    cell.lines = std::max<std::uint8_t>(cell.lines, first == s.line ? 1 : 2);
    return cell.asked;
  }
};

// Soundings come in ping by ping, in the order of the route, whatever the threads did.
class Filling {
 public:
  Filling(std::vector<JudgedGrid>& grids, JudgedSurvey& result) : result_(result) {
    for (JudgedGrid& grid : grids) grids_.emplace_back(grid);
  }

  void add(const JudgedSounding& s) {
    bool asked = false;
    for (FillingGrid& grid : grids_) asked = grid.add(s) || asked;
    if (const auto i = cell_at(result_.raster, s.position)) {
      result_.raster.tvu_m[*i] = std::min(result_.raster.tvu_m[*i], s.tvu_m);
      result_.raster.thu_m[*i] = std::min(result_.raster.thu_m[*i], s.thu_m);
      result_.raster.tvu_share[*i] = std::min(result_.raster.tvu_share[*i], s.tvu_share);
    }
    if (!asked) return;
    ++result_.soundings;
    result_.accepted += s.accepted ? 1 : 0;
    const auto bin = static_cast<std::size_t>(static_cast<double>(s.tvu_share) / kTvuBin);
    ++result_.tvu_histogram[std::min(bin, kTvuBins - 1)];
  }

 private:
  JudgedSurvey& result_;
  std::vector<FillingGrid> grids_;
};

// A batch of blocks of pings on their way to the grids.
struct JudgingBatch {
  std::vector<TracedPings> blocks;
  std::vector<std::vector<JudgedSounding>> soundings;
  std::size_t count = 0;  // of the blocks in use
};

// One thread traces pings, since by the clock each hangs on the one before, while all others make
// soundings of the batch before.
class SurveyTrace {
 public:
  SurveyTrace(TracedPingReader& reader, tbb::task_arena& arena,
              tbb::enumerable_thread_specific<SoundingMaker>& makers)
      : reader_(reader), arena_(arena), makers_(makers) {
    const std::size_t blocks =
        kBlocksPerJudgingThread * static_cast<std::size_t>(arena.max_concurrency());
    for (JudgingBatch* batch : {&now_, &next_}) {
      batch->blocks.resize(blocks);
      batch->soundings.resize(blocks);
    }
  }

  /// Returns the logged pings.
  std::uint64_t run(const TakeSoundings& take, const ScoreOptions& scoring) {
    std::uint64_t soundings = 0;
    read(now_);
    while (now_.count > 0) {
      arena_.execute([&] { run_both([&] { read(next_); }, [&] { make(now_); }); });
      for (std::size_t b = 0; b < now_.count; ++b) {
        soundings += now_.soundings[b].size();
        take(now_.soundings[b]);
      }
      if (scoring.progress) scoring.progress(reader_.progress(), soundings);
      std::swap(now_, next_);
    }
    return pings_;
  }

 private:
  void read(JudgingBatch& batch) {
    batch.count = 0;
    while (batch.count < batch.blocks.size() &&
           reader_.next(kPingsPerJudgingBlock, batch.blocks[batch.count])) {
      for (const Ping& ping : batch.blocks[batch.count].pings) pings_ += ping.log ? 1 : 0;
      ++batch.count;
    }
  }

  void make(JudgingBatch& batch) {
    for_each_index(std::size_t{0}, batch.count, [&](std::size_t b) {
      batch.soundings[b].clear();
      makers_.local().append(batch.blocks[b], batch.soundings[b]);
    });
  }

  TracedPingReader& reader_;
  tbb::task_arena& arena_;
  tbb::enumerable_thread_specific<SoundingMaker>& makers_;
  JudgingBatch now_, next_;
  std::uint64_t pings_ = 0;
};

int judging_threads(const ScoreOptions& scoring) {
  const int cores = tbb::info::default_concurrency();
  return scoring.threads > 0 ? std::min(scoring.threads, cores) : cores;
}

}  // namespace

SurveyJudge::SurveyJudge(const Ground& ground, const Criterion& criterion,
                         const UncertaintyBudget& budget, const JudgingOptions& options)
    : ground_(ground),
      criterion_(&criterion),
      model_(budget),
      options_(options),
      grids_(criterion_grids(criterion, ground)) {
  if (!options.smooth_seafloor) check_data(criterion, grids_, *ground.seafloor);
}

std::uint64_t SurveyJudge::trace(const Route& route, const Sonar& sonar, const Vehicle& vehicle,
                                 const ScoreOptions& scoring, const CoverageGrid& cells,
                                 const TakeSoundings& take) const {
  tbb::task_arena arena(judging_threads(scoring));
  TracedPingReader reader(route, *ground_.scene, sonar, vehicle.draft_m, scoring, cells);
  tbb::enumerable_thread_specific<SoundingMaker> makers([&] {
    return SoundingMaker(sonar, vehicle.draft_m, scoring.swath_share, *criterion_, model_);
  });
  return SurveyTrace(reader, arena, makers).run(take, scoring);
}

void SurveyJudge::sound(const Route& route, const Sonar& sonar, const Vehicle& vehicle,
                        const ScoreOptions& scoring, const TakeSoundings& take) const {
  if (const auto what = fault(route)) throw InvalidInput("the route cannot be sounded: " + *what);
  check(sonar, scoring.pings);
  // Soundings are not sorted into these cells, so one is enough.
  const double all = extent(ground_.survey_area).size().maxCoeff();
  trace(route, sonar, vehicle, scoring, CoverageGrid(ground_.survey_area, all), take);
}

std::vector<JudgedGrid> SurveyJudge::traced(const Route& route, const Sonar& sonar,
                                            const Vehicle& vehicle, const ScoreOptions& scoring,
                                            JudgedSurvey& result) const {
  if (const auto what = fault(route)) throw InvalidInput("the route cannot be judged: " + *what);
  check(sonar, scoring.pings);
  tbb::task_arena arena(judging_threads(scoring));
  const CoverageGrid cells =
      arena.execute([&] { return CoverageGrid(ground_.survey_area, scoring.resolution_m); });
  result.raster = empty_raster(cells);
  std::vector<JudgedGrid> grids = grids_;
  Filling filling(grids, result);
  result.pings = trace(route, sonar, vehicle, scoring, cells, [&](const auto& soundings) {
    for (const JudgedSounding& s : soundings) filling.add(s);
  });
  return grids;
}

std::vector<JudgedGrid> SurveyJudge::filled(const Route& route, const Sonar& sonar,
                                            const Vehicle& vehicle,
                                            const ScoreOptions& scoring) const {
  JudgedSurvey result;
  return traced(route, sonar, vehicle, scoring, result);
}

JudgedSurvey SurveyJudge::judge(const Route& route, const Sonar& sonar, const Vehicle& vehicle,
                                const ScoreOptions& scoring) const {
  JudgedSurvey result;
  std::vector<JudgedGrid> grids = traced(route, sonar, vehicle, scoring, result);
  tbb::task_arena arena(judging_threads(scoring));
  const ReachSearch reach(ground_, sonar, vehicle);
  result.out_of_reach = arena.execute([&] { return reach.leave_out(grids); });
  result.verdict = swathplan::judge(*criterion_, grids, options_.rules);
  return result;
}

}  // namespace swathplan
