#include "planners/passing/passing_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "coverage/standards/judged_gaps.h"
#include "planners/fitted/fewest_hours.h"
#include "planners/passing/gap_passes.h"
#include "planners/passing/paced_lines.h"
#include "planners/passing/spared_lines.h"
#include "planners/passing/sparse_lines.h"
#include "planners/wording.h"

namespace swathplan {
namespace {

/// Cells that lines for the fewest hours cover before passes are added, per cent of those in reach.
constexpr double kCoverBeforePasses = 98.0;
/// Sets of lines that are mended, and cells of the criterion that all of them may hold together.
constexpr std::size_t kMostSchemes = 6;
constexpr double kCellsOfSchemes = 3e5;
constexpr int kRounds = 6;
constexpr std::size_t kMostPasses = 2000;
/// In the first rounds a pass is only sailed for so many cells: what two gaps share comes first.
constexpr std::size_t kFewestCells[kRounds] = {8, 4, 2, 1, 1, 1};
constexpr double kEndShare = 0.01;
/// A round that leaves more than this share of what failed before is the last one.
constexpr double kLittleLess = 0.9;
/// After lines were spared, joins are new, and what they cut off is mended in so many rounds.
constexpr int kRoundsAfterSparing = 3;
constexpr int kSparings = 4;
constexpr double kWorthSparing = 0.005;
/// Where cells fail that no pass can mend, new joins may leave this share of them more.
constexpr double kMoreLeft = 0.05;
/// Where no pass holds against all of the unsteadiness, one is sailed that holds against a share.
constexpr double kSharesHeld[] = {0.5, 0.0};
constexpr int kRoundsOfShare = 2;
/// More lines are not put into a new order.
constexpr std::size_t kMostOrdered = 250;
/// Joins of what is left may fail in their turn.
constexpr int kUnjoinedRounds = 3;
/// Lines are slowed by this share where too few soundings fall in a cell.
constexpr double kSlower = 0.8;
/// Of either side of a swath no more than this is given up for a boat that is off its line.
constexpr double kMostRim = 0.2;

Unsteadiness unsteadiness(const PlanOptions& options) {
  return {std::max(kAsideM, 3.0 * options.noise.lateral_sigma_m),
          std::max(Angle::degrees(kOffCourseDeg), options.noise.heading_sigma * 3.0)};
}

PlanOptions adapted(const SurveyJudge& judge, PlanOptions options) {
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

std::size_t asked_cells(const SurveyJudge& judge) {
  std::size_t count = 0;
  for (const JudgedGrid& grid : judge.grids()) {
    count += static_cast<std::size_t>(
        std::count_if(grid.cells.begin(), grid.cells.end(), [](const auto& c) { return c.asked; }));
  }
  return count;
}

/// Cells that are out of reach, found out once.
class AskedCells {
 public:
  AskedCells(const SurveyJudge& judge, const PlanOptions& how)
      : reach_(judge.ground(), how.sonar, how.vehicle) {
    for (const JudgedGrid& grid : judge.grids()) {
      CellMask mask(grid.cells.size(), 0);
      for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = grid.cells[i].asked ? 1 : 0;
      in_reach_.emplace_back(mask.size(), std::uint8_t{0});
      asked_.push_back(std::move(mask));
    }
  }

  /// Takes back cells without soundings that are out of reach.
  void look(std::vector<JudgedGrid> grids) {
    std::vector<std::pair<std::size_t, std::size_t>> unseen;
    for (std::size_t g = 0; g < grids.size(); ++g) {
      for (std::size_t i = 0; i < asked_[g].size(); ++i) {
        JudgedCell& cell = grids[g].cells[i];
        cell.asked = asked_[g][i] != 0 && in_reach_[g][i] == 0 && cell.soundings == 0;
        if (cell.asked) unseen.emplace_back(g, i);
      }
    }
    const OutOfReach out = reach_.leave_out(grids);
    out_.hidden_m2 += out.hidden_m2;
    out_.unsteerable_m2 += out.unsteerable_m2;
    for (const auto& [g, i] : unseen) {
      if (grids[g].cells[i].asked) {
        in_reach_[g][i] = 1;
      } else {
        asked_[g][i] = 0;
        if (!first_) first_ = grids[g].centre(i);
      }
    }
  }
  /// What was taken back so far, and the first place of it.
  [[nodiscard]] const OutOfReach& out() const { return out_; }
  [[nodiscard]] const std::optional<Vec2>& first_out() const { return first_; }
  [[nodiscard]] const std::vector<CellMask>& asked() const { return asked_; }

 private:
  ReachSearch reach_;
  std::vector<CellMask> asked_, in_reach_;
  OutOfReach out_;
  std::optional<Vec2> first_;
};

/// One set of lines with what was done to it.
struct MendedLines {
  BuiltRoute built;
  std::string what;
  double lines_s = 0.0;  ///< of the lines alone
  double seconds = 0.0;
  std::size_t passes = 0, spared = 0;
  bool dense = true;
  std::vector<GapCell> left;  ///< cells that still fail
  std::size_t held_less = 0;  ///< passes that hold against less
};

/// Joins that cannot be steered.
std::size_t unjoined(const Route& route) {
  const std::vector<Leg> all = legs(route);
  return static_cast<std::size_t>(std::count_if(
      all.begin(), all.end(), [&](const Leg& l) { return !route.waypoints[l.first].feasible; }));
}

bool is_better(const MendedLines& a, const MendedLines& b) {
  const auto key = [](const MendedLines& m) {
    return std::tuple(!m.dense, m.left.size(), unjoined(m.built.route), m.seconds);
  };
  return key(a) < key(b);
}

/// Mends one set of lines until the criterion passes or nothing helps.
class LinesMender {
 public:
  LinesMender(const SurveyJudge& judge, const PlanOptions& how, LineWorkshop& shop,
              LineWorkshop& loose, AskedCells& asked, const Unsteadiness& unsteady)
      : judge_(judge),
        how_(how),
        shop_(shop),
        loose_(loose),
        asked_(asked),
        unsteady_(unsteady),
        shown_(judge, how, unsteady) {
    shown_.ask(asked.asked());
  }

  MendedLines run(LaidLines lines) {
    now_.built = {std::move(lines.built.route), {}};
    now_.what = std::move(lines.what);
    if (lines_asked(judge_.criterion()) > 1) open_for_two_lines(now_.built.route, judge_, how_);
    pace_lines(now_.built.route, judge_, how_, 1.0);
    now_.lines_s = sailing_s(now_.built.route);
    fill(0, kRounds);
    for (int k = 0; k < kSparings && !how_.watch.ended(); ++k) {
      const MendedLines before = now_;
      if (!spare()) break;
      fill(kRounds - kRoundsAfterSparing, kRounds);
      const std::size_t most =
          before.left.size() +
          static_cast<std::size_t>(kMoreLeft * static_cast<double>(before.left.size()));
      const bool good = (now_.dense || !before.dense) && now_.left.size() <= most &&
                        unjoined(now_.built.route) <= unjoined(before.built.route);
      const bool little = now_.seconds > (1.0 - kWorthSparing) * before.seconds;
      const bool fewer = now_.left.size() < before.left.size();
      if (!good || (little && !fewer)) {
        if (!good || now_.seconds >= before.seconds) now_ = before;
        break;
      }
    }
    // Last, since sparing looks at what holds against all.
    for (const double share : kSharesHeld) hold_less(share);
    return std::move(now_);
  }

 private:
  /// Rounds of passes over what fails. Keeps the round that left the fewest cells.
  void fill(int first, int end) {
    std::optional<MendedLines> best;
    for (int round = first;; ++round) {
      shown_.show(now_.built.route);
      now_.seconds = sailing_s(now_.built.route);
      if (round > 0) {
        asked_.look(shown_.grids());
        shown_.ask(asked_.asked());
      }
      const std::size_t before = now_.left.size();
      now_.left = failing(shown_.grids());
      now_.dense = shown_.dense();
      const bool little = round > first + 1 && static_cast<double>(now_.left.size()) >
                                                   kLittleLess * static_cast<double>(before);
      if (!best || is_better(now_, *best)) best = now_;
      if (round == end || (little && now_.dense) || how_.watch.ended()) break;
      bool changed = !now_.dense && slow_down();
      if (!now_.left.empty()) {
        changed = add_passes(now_.left, unsteady_, round, first == 0) || changed;
      }
      if (!changed && (now_.left.empty() || round + 1 >= end)) break;
    }
    if (is_better(*best, now_)) {
      now_ = std::move(*best);
      shown_.show(now_.built.route);
    }
  }

  bool add_passes(const std::vector<GapCell>& cells, const Unsteadiness& unsteady, int round,
                  bool in_new_order) {
    Itinerary itinerary(now_.built.route, shop_.joins());
    const auto k = static_cast<std::size_t>(round);
    const GapPasses added = insert_gap_passes(cells, shop_,
                                              {.unsteady = unsteady,
                                               .end_share = kEndShare,
                                               .fewest_cells = kFewestCells[k],
                                               .most_passes = kMostPasses,
                                               .barred = barred_},
                                              itinerary);
    if (added.passes == 0) return false;
    now_.passes += added.passes;
    now_.built = shop_.join(itinerary.runs());
    if (in_new_order) order_anew();
    give_up_unjoined();
    pace_lines(now_.built.route, judge_, how_, 1.0);
    return true;
  }

  /// Puts all lines and passes into a new order where that saves metres.
  void order_anew() {
    std::vector<std::vector<Waypoint>> lines;
    bool after_join = true;
    for (RouteStretch& s : stretches(now_.built.route)) {
      if (!s.join && !after_join && lines.back().back().position == s.points.front().position) {
        lines.back().pop_back();
        lines.back().insert(lines.back().end(), s.points.begin(), s.points.end());
      } else if (!s.join) {
        lines.push_back(std::move(s.points));
      }
      after_join = s.join;
    }
    if (lines.size() > kMostOrdered) return;
    std::vector<LineEnds> ends;
    for (const auto& line : lines) ends.push_back(ends_of(line));
    std::vector<std::vector<Waypoint>> ordered;
    for (const OrderedLine& next : line_order(ends, shop_.joins(), how_.start)) {
      ordered.push_back(next.backwards ? backwards(lines[next.line]) : lines[next.line]);
    }
    BuiltRoute built = shop_.join(ordered);
    const auto key = [](const Route& r) { return std::pair(unjoined(r), sailing_s(r)); };
    if (key(built.route) < key(now_.built.route)) now_.built = std::move(built);
  }

  /// Joins that cannot be steered may take something off their lines; passes next to those that
  /// cannot even then are taken out.
  void give_up_unjoined() {
    if (unjoined(now_.built.route) > 0) {
      std::vector<RouteStretch> kept = stretches(now_.built.route);
      std::erase_if(kept, [](const RouteStretch& s) {
        return s.join && std::any_of(s.points.begin(), s.points.end(),
                                     [](const Waypoint& w) { return !w.feasible; });
      });
      now_.built = loose_.join(Itinerary(std::move(kept), loose_.joins()).runs());
    }
    for (int k = 0; k < kUnjoinedRounds; ++k) {
      Itinerary itinerary(now_.built.route, shop_.joins());
      const std::vector<Vec2> gone = itinerary.give_up_unjoined();
      if (gone.empty()) return;
      barred_.insert(barred_.end(), gone.begin(), gone.end());
      now_.passes -= std::min(now_.passes, gone.size());
      now_.built = shop_.join(itinerary.runs());
    }
  }

  /// Where cells are left that no pass holds, passes over those that even a steadier boat misses.
  void hold_less(double share) {
    const Unsteadiness less{share * unsteady_.aside_m, unsteady_.heading * share};
    for (int round = 0; round < kRoundsOfShare && !now_.left.empty(); ++round) {
      if (how_.watch.ended()) return;
      ShownCells shown(judge_, how_, less);
      std::vector<Vec2> places;
      double deepest = 0.0;
      for (const GapCell& cell : now_.left) {
        places.push_back(cell.position);
        deepest = std::max(deepest, cell.depth_m);
      }
      shown.ask(masks_of(now_.left));
      shown.show(now_.built.route, places, 2.0 * deepest * tan(how_.sonar.max_opening / 2.0));
      const std::vector<GapCell> cells = failing(shown.grids());
      const std::size_t before = now_.passes;
      if (cells.empty() || !add_passes(cells, less, kRounds - 1, false)) return;
      now_.held_less += now_.passes - std::min(now_.passes, before);
      shown_.show(now_.built.route);
      now_.seconds = sailing_s(now_.built.route);
      now_.left = failing(shown_.grids());
    }
  }

  [[nodiscard]] std::vector<CellMask> masks_of(const std::vector<GapCell>& cells) const {
    std::vector<CellMask> masks;
    for (const JudgedGrid& grid : judge_.grids()) masks.emplace_back(grid.cells.size(), 0);
    for (const GapCell& cell : cells) masks[cell.grid][cell.index] = 1;
    return masks;
  }

  /// False if nothing could be spared.
  bool spare() {
    std::optional<SparedStretches> rest =
        spared(now_.built.route, shown_, std::max(how_.least_line_m, 1.0));
    if (!rest) return false;
    now_.spared += rest->lines;
    Itinerary itinerary(std::move(rest->stretches), shop_.joins());
    now_.built = shop_.join(itinerary.runs());
    order_anew();
    give_up_unjoined();
    pace_lines(now_.built.route, judge_, how_, 1.0);
    return true;
  }

  bool slow_down() {
    const double before = sailing_s(now_.built.route);
    pace_lines(now_.built.route, judge_, how_, kSlower);
    return sailing_s(now_.built.route) > before;
  }

  [[nodiscard]] std::vector<GapCell> failing(const std::vector<JudgedGrid>& grids) const {
    const int lines = lines_asked(judge_.criterion());
    std::vector<GapCell> cells;
    for (std::size_t g = 0; g < grids.size(); ++g) {
      const JudgedGrid& grid = grids[g];
      const CellMask gaps = gaps_in(judge_.criterion(), grid);
      const CellMask cubes = missed_cubes(judge_.criterion(), grid);
      for (std::size_t i = 0; i < gaps.size(); ++i) {
        if (gaps[i] == 0 && cubes[i] == 0) continue;
        cells.push_back({grid.centre(i), grid.cells[i].depth_m,
                         gaps[i] != 0 ? lines - grid.cells[i].lines : 1, g, i});
      }
    }
    return cells;
  }

  const SurveyJudge& judge_;
  const PlanOptions& how_;
  LineWorkshop& shop_;
  LineWorkshop& loose_;
  AskedCells& asked_;
  Unsteadiness unsteady_;
  ShownCells shown_;
  MendedLines now_;
  std::vector<Vec2> barred_;
};

class PassingPlan {
 public:
  PassingPlan(const SurveyJudge& judge, const PlanOptions& options)
      : judge_(judge),
        how_(adapted(judge, options)),
        shop_(judge.ground(), how_, 0.0),
        loose_(judge.ground(), how_),
        unsteady_(unsteadiness(options)) {}

  Plan run() {
    if (judge_.criterion().gap == GapRule::spread) {
      if (std::optional<SparsePlan> sparse = sparse_lines(judge_, shop_)) return of_sparse(*sparse);
    }
    const auto schemes = static_cast<std::size_t>(
        std::clamp(kCellsOfSchemes / static_cast<double>(asked_cells(judge_)), 1.0,
                   static_cast<double>(kMostSchemes)));
    AskedCells asked(judge_, how_);
    std::optional<MendedLines> best;
    std::size_t tried = 0;
    for (LaidLines& lines : lines_for_fewest_hours(judge_.ground(), how_, schemes)) {
      if (best && how_.watch.ended()) break;
      how_.watch.phase("passing the criterion");
      MendedLines mended =
          LinesMender(judge_, how_, shop_, loose_, asked, unsteady_).run(std::move(lines));
      ++tried;
      if (!best || is_better(mended, *best)) best = std::move(mended);
    }
    Plan plan;
    plan.route = shop_.with_smooth_joins(best->built).route;
    plan.notes = best->built.notes;
    plan.notes.push_back(fmt::format(
        "{} took {:.2f} h; {}, {} spared and slower lines for {} brought it to {:.2f} h, held "
        "against a boat {:g} m off its line and {:g} degrees off its course; the fewest hours of "
        "{} that were mended so",
        best->what, best->lines_s / 3600.0,
        counted(best->passes, "pass over what failed", "passes over what failed"),
        counted(best->spared, "line", "lines"), judge_.criterion().title,
        sailing_s(plan.route) / 3600.0, unsteady_.aside_m, unsteady_.heading.deg(),
        counted(tried, "set of lines", "sets of lines")));
    if (asked.first_out()) plan.notes.push_back(out_of_reach_note(asked));
    if (!best->left.empty()) plan.notes.push_back(left_note(*best));
    return plan;
  }

 private:
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

  [[nodiscard]] std::string out_of_reach_note(const AskedCells& asked) const {
    const Vec2 at = judge_.ground().seafloor->frame.to_file(*asked.first_out());
    return fmt::format(
        "no pass is laid for {:.1f} m2 that soundings which {} accepts cannot reach from safe "
        "water ({:.1f} m2 hidden, {:.1f} m2 from where the boat cannot be steered), the first "
        "about {:.1f},{:.1f}",
        asked.out().total_m2(), judge_.criterion().title, asked.out().hidden_m2,
        asked.out().unsteerable_m2, at.x(), at.y());
  }

  [[nodiscard]] std::string left_note(const MendedLines& best) const {
    const Frame& frame = judge_.ground().seafloor->frame;
    const Vec2 at = frame.to_file(best.left.front().position);
    const std::string less =
        best.held_less > 0
            ? fmt::format(", though {} hold{} against a steadier boat",
                          counted(best.held_less, "pass over them", "passes over them"),
                          best.held_less == 1 ? "s" : "")
            : "";
    return fmt::format(
        "{} of {} still fail{} for a boat that is off by so much, among them one about "
        "{:.1f},{:.1f}: no further pass over them has room{}; the verdict says what a steady boat "
        "leaves",
        counted(best.left.size(), "cell"), judge_.criterion().title,
        best.left.size() == 1 ? "s" : "", at.x(), at.y(), less);
  }

  const SurveyJudge& judge_;
  const PlanOptions how_;
  LineWorkshop shop_;   ///< its joins take nothing off lines, since all of a line is needed
  LineWorkshop loose_;  ///< its joins may, where there is no other
  Unsteadiness unsteady_;
};

}  // namespace

Plan plan_to_pass(const SurveyJudge& judge, const PlanOptions& options) {
  check(options);
  return PassingPlan(judge, options).run();
}

}  // namespace swathplan
