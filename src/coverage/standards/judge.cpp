#include "coverage/standards/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "coverage/standards/judged_gaps.h"
#include "mesh/base/error.h"

namespace swathplan {

namespace {

// Shares are of whole cells: what rounding leaves of 95 % of them.
constexpr double kShareDust = 1e-9;
// S-44 below 100 % coverage: depths no farther apart than these.
constexpr double kMeanDepths = 3.0;
constexpr double kLeastSpreadM = 25.0;

// Counts one rule over all grids.
class RuleTally {
 public:
  explicit RuleTally(const JudgeOptions& options) : options_(options) {}

  // `about`: the cells that the rule is about; `failing`: of them, those where it fails.
  void add(const JudgedGrid& grid, const CellMask& about, const CellMask& failing) {
    const double cell = grid.cell_m * grid.cell_m;
    for (std::size_t i = 0; i < about.size(); ++i) {
      about_m2_ += about[i] != 0 ? cell : 0.0;
      failing_m2_ += failing[i] != 0 ? cell : 0.0;
    }
    const std::vector<FailingPlace> places = places_of(failing, grid);
    count_ += places.size();
    where_.insert(where_.end(), places.begin(), places.end());
    std::stable_sort(where_.begin(), where_.end(),
                     [](const auto& a, const auto& b) { return a.area_m2 > b.area_m2; });
    where_.resize(std::min(where_.size(), options_.list_at_most));
  }

  [[nodiscard]] double about_m2() const { return about_m2_; }
  [[nodiscard]] double pct() const {
    return about_m2_ > 0.0 ? 100.0 * (about_m2_ - failing_m2_) / about_m2_ : 0.0;
  }
  [[nodiscard]] bool any() const { return about_m2_ > 0.0; }
  [[nodiscard]] bool reaches(double share_pct) const {
    return any() && pct() >= share_pct - kShareDust;
  }

  [[nodiscard]] JudgedRule rule(std::string name, std::string asks) const {
    JudgedRule rule;
    rule.name = std::move(name);
    rule.asks = std::move(asks);
    rule.figure_pct = pct();
    rule.failing_m2 = failing_m2_;
    rule.failing_places = count_;
    rule.where = where_;
    return rule;
  }

 private:
  const JudgeOptions& options_;
  double about_m2_ = 0.0, failing_m2_ = 0.0;
  std::size_t count_ = 0;
  std::vector<FailingPlace> where_;
};

template <class Test>
CellMask cells_where(const JudgedGrid& grid, Test test) {
  CellMask mask(grid.cells.size(), 0);
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = test(grid.cells[i]) ? 1 : 0;
  return mask;
}

using Grids = std::span<const JudgedGrid>;

// Asks `good` of every asked cell that `about` admits.
template <class About, class Good>
RuleTally share_of(Grids grids, const JudgeOptions& options, About about, Good good) {
  RuleTally tally(options);
  for (const JudgedGrid& grid : grids) {
    tally.add(grid, cells_where(grid, [&](const auto& c) { return c.asked && about(c); }),
              cells_where(grid, [&](const auto& c) { return c.asked && about(c) && !good(c); }));
  }
  return tally;
}

bool seen(const JudgedCell& cell) { return cell.soundings > 0; }

JudgedRule density_rule(const DensityRule& rule, Grids grids, const JudgeOptions& options) {
  const RuleTally tally = share_of(
      grids, options, [](const auto& c) { return c.accepted > 0; },
      [&](const auto& c) { return c.accepted >= rule.soundings; });
  JudgedRule result = tally.rule(
      "density", fmt::format("at least {} soundings in {:g} % of the cells that hold any",
                             rule.soundings, rule.share_pct));
  result.pass = tally.reaches(rule.share_pct);
  result.figure = tally.any() ? fmt::format("{:.2f} % of cells", tally.pct()) : "no sounding";
  return result;
}

JudgedRule limit_rule(const Criterion& criterion, bool vertical, Grids grids,
                      const JudgeOptions& options) {
  double worst = 0.0;
  const RuleTally tally = share_of(grids, options, seen, [&](const JudgedCell& c) {
    const double limit =
        vertical ? tvu_limit_m(criterion, c.depth_m) : thu_limit_m(criterion, c.depth_m);
    const double share = (vertical ? c.tvu_m : c.thu_m) / limit;
    worst = std::max(worst, share);
    return share <= 1.0;
  });
  JudgedRule result =
      tally.rule(vertical ? "vertical uncertainty" : "horizontal uncertainty",
                 fmt::format("{} within its limit in {:g} % of the cells that hold soundings",
                             vertical ? "TVU" : "THU", criterion.within_pct));
  result.pass = tally.reaches(criterion.within_pct);
  result.figure = tally.any() ? fmt::format("{:.2f} % of cells, at most {:.2f} of the limit",
                                            tally.pct(), worst)
                              : "no sounding";
  return result;
}

// A cube may lie unseen where cells that hold soundings would show too few of it, side by side over
// its whole size.
JudgedRule feature_rule(const Criterion& criterion, Grids grids, const JudgeOptions& options) {
  const FeatureRule& rule = *criterion.features;
  RuleTally tally(options);
  double shown = 0.0;
  for (const JudgedGrid& grid : grids) {
    const CellMask about =
        cells_where(grid, [](const auto& c) { return c.asked && c.accepted > 0; });
    const CellMask poor = cells_where(grid, [&](const JudgedCell& c) {
      return c.asked && c.accepted > 0 &&
             (c.feature_pings < static_cast<float>(rule.pings) ||
              c.feature_beams < static_cast<float>(rule.beams));
    });
    const auto left =
        std::count(poor.begin(), poor.end(), 0) - std::count(about.begin(), about.end(), 0);
    shown += static_cast<double>(left) * grid.cell_m * grid.cell_m;
    tally.add(grid, about, missed_cubes(criterion, grid));
  }
  const std::string size =
      std::isinf(rule.shoal_m)
          ? fmt::format("{:g} m", rule.cube_m)
          : fmt::format("{:g} m to {:g} m depth, then {:g} % of the depth", rule.cube_m,
                        rule.shoal_m, 100.0 * rule.share_of_depth);
  JudgedRule result =
      tally.rule("features", fmt::format("{} pings and {} beams on a cube of {} ({})", rule.pings,
                                         rule.beams, size, rule.source));
  result.pass = tally.reaches(100.0);
  if (tally.any()) result.figure_pct = 100.0 * shown / tally.about_m2();
  result.figure = tally.any()
                      ? fmt::format("{:.2f} % of cells, {} places where a cube may be missed",
                                    result.figure_pct, result.failing_places)
                      : "no sounding";
  return result;
}

// Ground that too few lines saw, as the criterion defines a gap.
JudgedRule coverage_rule(const Criterion& criterion, Grids grids, const JudgeOptions& options) {
  const int lines = lines_asked(criterion);
  RuleTally tally(options);
  double covered = 0.0;
  for (const JudgedGrid& grid : grids) {
    const CellMask asked = cells_where(grid, [](const auto& c) { return c.asked; });
    const CellMask lacking =
        cells_where(grid, [&](const auto& c) { return c.asked && c.lines < lines; });
    covered += static_cast<double>(std::count(lacking.begin(), lacking.end(), 0) -
                                   std::count(asked.begin(), asked.end(), 0)) *
               grid.cell_m * grid.cell_m;
    tally.add(grid, asked, gaps_in(criterion, grid));
  }
  JudgedRule result = tally.rule("coverage", std::string(criterion.coverage_text));
  result.pass = tally.reaches(100.0);
  result.figure_pct = 100.0 * covered / tally.about_m2();
  result.figure = fmt::format("{:.2f} % of cells{}, {} gap{}", result.figure_pct,
                              lines > 1 ? " by two lines" : "", result.failing_places,
                              result.failing_places == 1 ? "" : "s");
  return result;
}

double mean_depth_m(Grids grids) {
  double area = 0.0;
  double volume = 0.0;
  for (const JudgedGrid& grid : grids) {
    for (const JudgedCell& cell : grid.cells) {
      if (!cell.asked) continue;
      area += grid.cell_m * grid.cell_m;
      volume += grid.cell_m * grid.cell_m * cell.depth_m;
    }
  }
  return volume / area;
}

// Soundings are no farther apart than allowed where no ground is farther than half of that from
// one.
JudgedRule spread_rule(const Criterion& criterion, Grids grids, const JudgeOptions& options) {
  const double apart = depths_apart_m(mean_depth_m(grids));
  RuleTally spread(options);
  RuleTally share(options);
  double farthest = 0.0;
  for (const JudgedGrid& grid : grids) {
    const CellMask asked = cells_where(grid, [](const auto& c) { return c.asked; });
    const std::vector<float> distance =
        distance_in_cells(cells_where(grid, [](const auto& c) { return c.accepted > 0; }), grid);
    CellMask far(asked.size(), 0);
    for (std::size_t i = 0; i < far.size(); ++i) {
      if (asked[i] == 0) continue;
      const double metres = distance[i] * grid.cell_m;
      farthest = std::max(farthest, metres);
      far[i] = metres > 0.5 * apart ? 1 : 0;
    }
    spread.add(grid, asked, far);
    share.add(grid, asked,
              cells_where(grid, [](const auto& c) { return c.asked && c.accepted == 0; }));
  }
  const bool near_enough = spread.reaches(100.0);
  JudgedRule result =
      (near_enough ? share : spread)
          .rule("coverage", fmt::format("{} (here {:.1f} m)", criterion.coverage_text, apart));
  result.figure_pct = share.pct();
  result.pass = near_enough && share.reaches(share_asked_pct(criterion));
  result.figure = std::isinf(farthest)
                      ? "no sounding"
                      : fmt::format("{:.2f} % of cells, depths {:.1f} m apart at most",
                                    result.figure_pct, 2.0 * farthest);
  return result;
}

}  // namespace

Verdict judge(const Criterion& criterion, Grids grids, const JudgeOptions& options) {
  Verdict verdict;
  verdict.criterion = criterion.name;
  verdict.title = criterion.title;
  verdict.judged_m2 =
      share_of(
          grids, options, [](const auto&) { return true; }, [](const auto&) { return true; })
          .about_m2();
  if (!(verdict.judged_m2 > 0.0)) {
    throw InvalidInput(fmt::format(
        "{} cannot be judged: no cell of its grid lies in the survey area; give a larger area",
        criterion.title));
  }
  verdict.rules.push_back(criterion.gap == GapRule::spread
                              ? spread_rule(criterion, grids, options)
                              : coverage_rule(criterion, grids, options));
  if (criterion.density) {
    verdict.rules.push_back(density_rule(*criterion.density, grids, options));
  }
  if (criterion.features) verdict.rules.push_back(feature_rule(criterion, grids, options));
  verdict.rules.push_back(limit_rule(criterion, true, grids, options));
  verdict.rules.push_back(limit_rule(criterion, false, grids, options));
  verdict.pass = std::all_of(verdict.rules.begin(), verdict.rules.end(),
                             [](const JudgedRule& rule) { return rule.pass; });
  return verdict;
}

double depths_apart_m(double mean_depth_m) {
  return std::max(kMeanDepths * mean_depth_m, kLeastSpreadM);
}

std::string sentence(const Verdict& verdict) {
  if (verdict.pass) return fmt::format("predicted to pass {}", verdict.title);
  std::string why;
  for (const JudgedRule& rule : verdict.rules) {
    if (rule.pass) continue;
    why += fmt::format("{}{} ({}; asked: {})", why.empty() ? "" : "; ", rule.name, rule.figure,
                       rule.asks);
  }
  return fmt::format("predicted to fail {}: {}", verdict.title, why);
}

}  // namespace swathplan
