#include "planners/passing/passing_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "coverage/standards/judged_gaps.h"
#include "planners/fitted/fewest_hours.h"
#include "planners/passing/paced_lines.h"
#include "planners/passing/sparse_lines.h"
#include "planners/passing/steady_cells.h"
#include "planners/wording.h"

namespace swathplan {
namespace {

/// Cells that lines for the fewest hours cover before passes are added, per cent of those in reach.
constexpr double kCoverBeforePasses = 98.0;
constexpr int kRounds = 5;
constexpr std::size_t kMostPasses = 600;
/// In the first rounds a pass is only sailed for so many cells: what two gaps share comes first.
constexpr std::size_t kFewestCells[] = {6, 3, 1, 1, 1};
constexpr double kEndShares[] = {0.2, 0.2, 0.12, 0.05, 0.0};
/// Joins of what is left may fail in their turn.
constexpr int kUnjoinedRounds = 3;
/// Lines are slowed by this share where too few soundings fall in a cell.
constexpr double kSlower = 0.8;
/// Of either side of a swath no more than this is given up for a boat that is off its line.
constexpr double kMostRim = 0.2;
/// Density is looked at with thinned pings, so a little more than asked is wanted of it.
constexpr double kDensityReservePct = 0.3;

class PassingPlan {
 public:
  PassingPlan(const SurveyJudge& judge, const PlanOptions& options)
      : judge_(judge),
        how_(adapted(judge, options)),
        shop_(judge.ground(), how_),
        reach_(judge.ground(), how_.sonar, how_.vehicle) {
    unsteady_ = unsteadiness(options);
  }

  Plan run() {
    if (judge_.criterion().gap == GapRule::spread) {
      if (std::optional<SparsePlan> sparse = sparse_lines(judge_, shop_)) return of_sparse(*sparse);
    }
    Plan plan = plan_fewest_hours(judge_.ground(), how_);
    const std::string base = plan.choices.empty() ? "" : plan.choices[plan.chosen].what;
    built_ = {std::move(plan.route), {}};
    if (lines_asked(judge_.criterion()) > 1) {
      open_for_two_lines(built_.route, judge_, how_);
    }
    pace_lines(built_.route, judge_, how_, 1.0);
    const double hours = sailing_s(built_.route) / 3600.0;
    for (int round = 0; round < kRounds && !how_.watch.ended(); ++round) {
      how_.watch.phase("passing the criterion");
      if (!mend(round)) break;
    }
    plan.route = shop_.with_smooth_joins(built_).route;
    plan.notes = built_.notes;
    plan.choices.clear();
    plan.chosen_why.clear();
    plan.notes.push_back(fmt::format(
        "{} took {:.2f} h; {} and slower lines for {} brought it to {:.2f} h, held against a boat "
        "{:g} m off its line and {:g} degrees off its course",
        base, hours, counted(passes_, "pass over what failed", "passes over what failed"),
        judge_.criterion().title, sailing_s(plan.route) / 3600.0, unsteady_.aside_m,
        unsteady_.heading.deg()));
    if (cells_left_ > 0) plan.notes.push_back(left_note());
    return plan;
  }

 private:
  static Unsteadiness unsteadiness(const PlanOptions& options) {
    return {std::max(kAsideM, 3.0 * options.noise.lateral_sigma_m),
            std::max(Angle::degrees(kOffCourseDeg), options.noise.heading_sigma * 3.0)};
  }

  static PlanOptions adapted(const SurveyJudge& judge, PlanOptions options) {
    // Lines do not count on the rim of their swaths that a boat off its line would miss.
    const double mean = depth_range(*judge.ground().seafloor).mean;
    const double half =
        std::max(mean - options.vehicle.draft_m, 0.1) * tan(options.sonar.max_opening / 2.0);
    options.lines_margin =
        std::max(options.lines_margin, std::min(unsteadiness(options).aside_m / half, kMostRim));
    const Criterion& criterion = judge.criterion();
    options.criterion = &criterion;
    options.uncertainty = &judge.uncertainty();
    options.resolution_m = cell_m(criterion, depth_range(*judge.ground().seafloor).mean);
    options.soundings = criterion.density ? criterion.density->soundings : 1.0;
    options.goal = {};
    options.goal.coverage_pct = kCoverBeforePasses;
    options.noise = {};
    return options;
  }

  Plan of_sparse(SparsePlan& sparse) {
    Plan plan;
    plan.route = shop_.with_smooth_joins(std::move(sparse.built)).route;
    plan.notes = std::move(sparse.built.notes);
    plan.notes.push_back(fmt::format(
        "straight lines for {}: a swath and {:.0f} % of the distance that depths may lie apart "
        "between them, {:.2f} h",
        judge_.criterion().title, 100.0 * sparse.spacing_share, sailing_s(plan.route) / 3600.0));
    return plan;
  }

  /// One round: finds what fails and adds passes over it. False when nothing fails or helps.
  bool mend(int round) {
    std::vector<JudgedGrid> grids = steady_cells(judge_, built_.route, how_, unsteady_);
    if (grids.empty()) return false;
    for (std::size_t g = 0; g < asked_.size(); ++g) {
      for (std::size_t i = 0; i < asked_[g].size(); ++i) {
        // What was out of reach stays so, unless it was seen.
        JudgedCell& cell = grids[g].cells[i];
        if (asked_[g][i] == 0 && cell.soundings == 0) cell.asked = false;
      }
    }
    static_cast<void>(reach_.leave_out(grids));
    asked_.clear();
    for (const JudgedGrid& grid : grids) {
      CellMask mask(grid.cells.size(), 0);
      for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = grid.cells[i].asked ? 1 : 0;
      asked_.push_back(std::move(mask));
    }
    const bool slower = slow_down(grids);
    const std::vector<GapCell> cells = failing(grids);
    cells_left_ = cells.size();
    if (cells.empty()) return slower;
    Itinerary itinerary(built_.route, shop_.joins());
    const auto k = static_cast<std::size_t>(round);
    const GapPasses added = insert_gap_passes(cells, shop_,
                                              {.unsteady = unsteady_,
                                               .end_share = kEndShares[k],
                                               .fewest_cells = kFewestCells[k],
                                               .most_passes = kMostPasses,
                                               .barred = barred_},
                                              itinerary);
    if (added.passes == 0) return slower || round + 1 < kRounds;
    passes_ += added.passes;
    cells_left_ = added.cells_left;
    built_ = shop_.join(itinerary.runs());
    give_up_unjoined();
    pace_lines(built_.route, judge_, how_, 1.0);
    return true;
  }

  /// Takes out passes next to joins that cannot be steered.
  void give_up_unjoined() {
    for (int k = 0; k < kUnjoinedRounds; ++k) {
      Itinerary itinerary(built_.route, shop_.joins());
      const std::vector<Vec2> gone = itinerary.give_up_unjoined();
      if (gone.empty()) return;
      barred_.insert(barred_.end(), gone.begin(), gone.end());
      passes_ -= std::min(passes_, gone.size());
      built_ = shop_.join(itinerary.runs());
    }
  }

  /// True if lines were slowed since too few soundings fall in the cells.
  bool slow_down(const std::vector<JudgedGrid>& grids) {
    if (!judge_.criterion().density) return false;
    const DensityRule& rule = *judge_.criterion().density;
    double about = 0.0;
    double dense = 0.0;
    for (const JudgedGrid& grid : grids) {
      for (const JudgedCell& cell : grid.cells) {
        if (!cell.asked || cell.accepted == 0) continue;
        about += grid.cell_m * grid.cell_m;
        dense += cell.accepted >= rule.soundings ? grid.cell_m * grid.cell_m : 0.0;
      }
    }
    if (100.0 * dense >= (rule.share_pct + kDensityReservePct) * about) return false;
    const double before = sailing_s(built_.route);
    pace_lines(built_.route, judge_, how_, kSlower);
    return sailing_s(built_.route) > before;
  }

  [[nodiscard]] std::vector<GapCell> failing(const std::vector<JudgedGrid>& grids) {
    const int lines = lines_asked(judge_.criterion());
    std::vector<GapCell> cells;
    for (const JudgedGrid& grid : grids) {
      const CellMask gaps = gaps_in(judge_.criterion(), grid);
      const CellMask cubes = missed_cubes(judge_.criterion(), grid);
      for (std::size_t i = 0; i < gaps.size(); ++i) {
        if (gaps[i] == 0 && cubes[i] == 0) continue;
        cells.push_back({grid.centre(i), grid.cells[i].depth_m,
                         gaps[i] != 0 ? lines - grid.cells[i].lines : 1});
      }
    }
    if (!cells.empty()) worst_ = cells.front().position;
    return cells;
  }

  [[nodiscard]] std::string left_note() const {
    const Frame& frame = judge_.ground().seafloor->frame;
    const Vec2 at = frame.to_file(worst_);
    return fmt::format(
        "{} of {} still fail for a boat that is off by so much, among them one about "
        "{:.1f},{:.1f}: "
        "no further pass over them has room; the verdict says what a steady boat leaves",
        counted(cells_left_, "cell"), judge_.criterion().title, at.x(), at.y());
  }

  const SurveyJudge& judge_;
  const PlanOptions how_;
  LineWorkshop shop_;
  ReachSearch reach_;
  Unsteadiness unsteady_;
  BuiltRoute built_;
  std::vector<CellMask> asked_;
  std::vector<Vec2> barred_;
  std::size_t passes_ = 0, cells_left_ = 0;
  Vec2 worst_ = Vec2::Zero();
};

}  // namespace

Plan plan_to_pass(const SurveyJudge& judge, const PlanOptions& options) {
  check(options);
  return PassingPlan(judge, options).run();
}

}  // namespace swathplan
