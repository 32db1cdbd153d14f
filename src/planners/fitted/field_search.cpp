#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "planners/fitted/field_search_internal.h"
#include "planners/fronts/channel.h"
#include "planners/fronts/field_lines.h"
#include "planners/wording.h"

namespace swathplan {
namespace {

/// Walls that fronts start from, and what is tried on each.
constexpr std::size_t kFieldWalls = 3;
constexpr double kFieldSpacings[] = {0.9, 1.0, 1.12, 1.25};
constexpr double kFieldGap = 1.2;
constexpr LineAnglesOptions kFieldAngles{
    .overlap_m = 0.5, .widest_share = 1.0, .by_distance = false};
/// Field lines bend, and the outside of a bend is sounded thinly. With fewer pings a cell than
/// this, straight lines did better in all trials.
constexpr double kPingsACell = 2.0;
/// Numbers of lines along a channel, as shares of the swaths across it.
constexpr double kChannelShares[] = {0.75, 0.85, 0.95, 1.05, 1.2, 1.35};
/// Finalists along a channel are the best at these multiples of the price of an ideal length.
constexpr double kChannelPrices[] = {1.0, 0.375, 2.25};

struct TriedLines {
  Outcome outcome;
  std::vector<SurveyCurve> lines;
};

/// '3 lines along the banks', '3 to 6 lines along the banks'.
std::string describe(const std::vector<ChannelSection>& sections) {
  int fewest = sections.front().lines;
  int most = fewest;
  for (const ChannelSection& section : sections) {
    fewest = std::min(fewest, section.lines);
    most = std::max(most, section.lines);
  }
  const std::string lines = counted(static_cast<std::size_t>(most), "line");
  return fewest == most ? fmt::format("{} along the banks", lines)
                        : fmt::format("{} to {} along the banks", fewest, lines);
}

class CurvedSearch {
 public:
  CurvedSearch(LineWorkshop& shop, const SearchBudget& budget)
      : shop_(shop),
        budget_(budget),
        counted_(counted_share(shop.options())),
        passes_(coarse_cells() ? 60 : 200),
        width_(shop.width(kFieldGap)) {}

  [[nodiscard]] bool coarse_cells() const {
    return shop_.options().resolution_m >= kPingsACell * shop_.mean_ping_spacing_m();
  }

  /// Lines along fronts from the area's long walls.
  [[nodiscard]] std::vector<JudgedLines> from_walls() {
    // Walls are straight to a tenth of a lane: quays have steps and bollards.
    const double tolerance = 0.1 * lane_m(shop_.options());
    std::vector<TriedLines> tried;
    int number = 0;
    shop_.options().watch.phase("searching lines along fronts");
    for (const FieldWall& wall : long_walls(shop_.ground().survey_area, tolerance, kFieldWalls)) {
      ++number;
      for (const double spacing : kFieldSpacings) {
        if (over(tried)) break;
        add(field_lines(shop_.raster(), width_, shop_.lines_in(), wall, tolerance,
                        {.spacing = spacing * counted_, .smooth_passes = passes_}),
            fmt::format("field lines from wall {}, {:.2f} swaths apart", number, spacing), tried);
      }
    }
    const double price = shop_.price();
    std::stable_sort(tried.begin(), tried.end(), [&](const TriedLines& a, const TriedLines& b) {
      return worth(a.outcome, price) > worth(b.outcome, price);
    });
    if (tried.size() > budget_.curved_finalists) tried.resize(budget_.curved_finalists);
    return built_and_judged(tried);
  }

  /// Lines from end to end between the banks of a channel, or around a ring.
  [[nodiscard]] std::vector<JudgedLines> along_banks() {
    const auto banks = banks_of(shop_.raster(), shop_.ground().survey_area);
    if (!banks) return {};
    const BetweenBanks between = between_banks(shop_.raster(), width_, *banks);
    std::vector<TriedLines> tried;
    std::vector<std::vector<ChannelSection>> known;
    const auto add_lines = [&](const std::vector<ChannelSection>& sections) {
      if (std::find(known.begin(), known.end(), sections) != known.end()) return;
      known.push_back(sections);
      add(pieces_of(lines_between(shop_.raster(), *banks, between, sections, passes_),
                    shop_.raster(), width_, shop_.lines_in()),
          describe(sections), tried);
    };
    shop_.options().watch.phase("searching lines along banks");
    for (const double share : kChannelShares) {
      if (over(tried)) break;
      const double density = share / counted_;
      add_lines(sections_of(*banks, between, density));
      const double even = std::max(1.0, std::round(density * between.mean_swaths));
      add_lines({{0.0F, 1.0F, static_cast<int>(even)}});
    }
    std::vector<Outcome> outcomes;
    for (const TriedLines& t : tried) outcomes.push_back(t.outcome);
    std::vector<TriedLines> best;
    for (const std::size_t i :
         spread(outcomes, pareto_front(outcomes), multiplied(kChannelPrices, shop_.price()),
                budget_.curved_finalists)) {
      best.push_back(tried[i]);
    }
    return built_and_judged(best);
  }

 private:
  void add(std::vector<SurveyCurve> lines, const std::string& what,
           std::vector<TriedLines>& tried) {
    if (lines.empty()) return;
    Outcome outcome = shop_.estimate(lines, width_, kFieldAngles, budget_.coarse, what);
    tried.push_back({std::move(outcome), std::move(lines)});
    shop_.options().watch.tried(tried.size(), 0, brief(tried.back().outcome));
  }

  /// Whether the search is to end: with a candidate to keep.
  [[nodiscard]] bool over(const std::vector<TriedLines>& tried) const {
    return shop_.options().watch.ended() && !tried.empty();
  }

  [[nodiscard]] std::vector<JudgedLines> built_and_judged(const std::vector<TriedLines>& tried) {
    std::vector<JudgedLines> plans;
    for (const TriedLines& t : tried) {
      if (!plans.empty() && shop_.options().watch.ended()) break;
      plans.push_back({shop_.build(t.lines, width_, kFieldAngles), {}});
      plans.back().outcome = shop_.judge(plans.back().built.route, 1, t.outcome.what);
    }
    return plans;
  }

  LineWorkshop& shop_;
  const SearchBudget& budget_;
  double counted_;
  int passes_;
  const std::vector<float>& width_;
};

}  // namespace

std::vector<JudgedLines> search_curved_lines(LineWorkshop& shop, const SearchBudget& budget) {
  CurvedSearch search(shop, budget);
  std::vector<JudgedLines> plans;
  if (search.coarse_cells() || shop.options().lines == LineSource::field) {
    plans = search.from_walls();
  }
  for (JudgedLines& j : search.along_banks()) plans.push_back(std::move(j));
  return plans;
}

}  // namespace swathplan
