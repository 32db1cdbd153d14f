#include <algorithm>
#include <boost/container_hash/hash.hpp>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "planners/fitted/block_search_internal.h"
#include "planners/fitted/straight_search_internal.h"
#include "planners/fronts/fitted_straight.h"
#include "planners/rows/survey_lines.h"

namespace swathplan {
namespace {

constexpr double kDirectionStepDeg = 15.0;
/// Numbers of lines that are tried first, as shares of the number that W asks for.
constexpr double kLineShares[] = {1.0, 0.85, 0.7, 1.15};
/// The direction with the least metres of line is the yardstick. Directions that ask for more than
/// this many times as much are left out.
constexpr double kLongest = 1.3;
/// Plans with less coverage than this are not varied, %, where others reach it and no length or
/// time is set.
constexpr double kLeastUsefulPct = 70.0;

std::vector<double> directions(const LineWorkshop& shop) {
  if (shop.options().heading) return {shop.options().heading->deg()};
  std::vector<double> list;
  for (double deg = 0.0; deg < 180.0; deg += kDirectionStepDeg) list.push_back(deg);
  const double best = best_azimuth(shop.ground().survey_area, lane_m(shop.options())).deg();
  if (std::fmod(best, kDirectionStepDeg) > 1e-6) list.push_back(best);
  return list;
}

/// The lengths of two finalists with the same rows differ by at least this share.
constexpr double kApart = 0.01;

/// Finalists are the best at these multiples of the price of an ideal length: all-round, short,
/// dense.
constexpr double kFinalistPrices[] = {1.0, 2.25, 0.375};
/// Blocks are compared on cells coarser than those of candidates by this factor. The order of plans
/// stays the same, for half the work.
constexpr int kBlockCoarser = 1;
/// Another plan is searched between two plans whose lengths differ by this factor.
constexpr double kStraightGap = 1.03;

std::vector<Outcome> outcomes_of(const std::vector<JudgedCandidate>& judged) {
  std::vector<Outcome> outcomes;
  outcomes.reserve(judged.size());
  for (const JudgedCandidate& j : judged) outcomes.push_back(j.outcome);
  return outcomes;
}

/// A hash of the route's positions and fans, to a millimetre and a thousandth of a radian.
std::size_t fingerprint(const Route& route) {
  std::size_t seed = route.waypoints.size();
  const auto add = [&](double value) { boost::hash_combine(seed, std::llround(1000.0 * value)); };
  for (const Waypoint& w : route.waypoints) {
    add(w.position.x());
    add(w.position.y());
    if (!w.fan) continue;
    add(w.fan->port.rad());
    add(w.fan->starboard.rad());
  }
  return seed;
}

class Search {
 public:
  Search(LineWorkshop& shop, const SearchBudget& budget)
      : shop_(shop), budget_(budget), price_(shop.price()) {}

  std::vector<JudgedCandidate> run() {
    shop_.options().watch.phase("searching straight lines");
    first_candidates();
    // The goal may lie far from what is worth most, so every other variation is made for the goal.
    bool for_goal = false;
    while (left() > 0 && !over()) {
      for_goal = !for_goal && any(goal());
      const std::size_t next = most_promising(for_goal);
      if (next == pool_.size()) break;
      vary(next, for_goal ? goal() : PlanGoal{});
    }
    std::vector<JudgedCandidate> list = exact_front();
    add_blocked(list);
    return list;
  }

 private:
  /// Tries variations of a candidate until one is better. The search goes on from that one. It
  /// comes back to the other variations if this candidate is the most promising again.
  void vary(std::size_t base, const PlanGoal& goal) {
    for (const StraightCandidate& c : variations(pool_[base].candidate)) {
      if (left() <= 0 || over()) return;
      const std::size_t before = pool_.size();
      judge(c);
      if (pool_.size() > before &&
          pick({pool_[base].outcome, pool_.back().outcome}, goal, price_).index > 0)
        return;
    }
    varied_[base] = 1;
  }

  [[nodiscard]] const PlanGoal& goal() const { return shop_.options().goal; }
  [[nodiscard]] bool has_budget() const { return goal().length_m || goal().time_s; }
  /// Whether the search is to end: with a candidate to keep.
  [[nodiscard]] bool over() const { return shop_.options().watch.ended() && !pool_.empty(); }
  [[nodiscard]] int left() const { return budget_.candidates - static_cast<int>(pool_.size()); }

  void judge(const StraightCandidate& c) {
    if (over() || c.lines < 1 || std::find(tried_.begin(), tried_.end(), c) != tried_.end()) return;
    tried_.push_back(c);
    const Outcome outcome = budget_.steered ? steered(c) : estimated(c);
    if (!(outcome.length_m > 0.0)) return;
    pool_.push_back({c, outcome, {}});
    varied_.push_back(0);
    if (best_ == pool_.size() - 1 || worth(outcome, price_) > worth(pool_[best_].outcome, price_)) {
      best_ = pool_.size() - 1;
    }
    shop_.options().watch.tried(pool_.size(), static_cast<std::size_t>(budget_.candidates),
                                brief(pool_[best_].outcome));
  }

  /// Empty for a route that was judged before. On level ground many candidates give the same route.
  [[nodiscard]] Outcome steered(const StraightCandidate& c) {
    const BuiltRoute built = build(c, shop_);
    if (built.route.waypoints.size() < 2) return {};
    if (!routes_.insert(fingerprint(built.route)).second) return {};
    return shop_.judge(built.route, budget_.coarse, describe(c, shop_.options().grid_north));
  }
  [[nodiscard]] Outcome estimated(const StraightCandidate& c) const {
    return shop_.estimate(lines_of(c, shop_), width_of(c, shop_), angles_of(c), budget_.coarse,
                          describe(c, shop_.options().grid_north));
  }

  /// Tries directions in the order of the metres of line that they ask for, the least first. Each
  /// is tried with about as many lines as W asks for.
  void first_candidates() {
    const StraightCandidate plain;
    struct Direction {
      double deg, metres;
      double swaths;
    };
    std::vector<Direction> list;
    for (const double deg : directions(shop_)) {
      const RowWidths rows =
          row_widths(shop_.raster(), shop_.width(plain.gap), Angle::degrees(deg), plain.percentile);
      double metres = 0.0;
      for (const SurveyCurve& line :
           fitted_straight_lines(shop_.raster(), shop_.width(plain.gap), shop_.survey_area(),
                                 shop_.lines_in(), {.azimuth = Angle::degrees(deg)})) {
        metres += length_m(line) + 0.5 * lane_m(shop_.options());
      }
      list.push_back({deg, metres / std::ceil(rows.total()) * rows.total(),
                      rows.total() / counted_share(shop_.options())});
    }
    std::stable_sort(list.begin(), list.end(),
                     [](const Direction& a, const Direction& b) { return a.metres < b.metres; });
    for (const double share : kLineShares) {
      for (const Direction& d : list) {
        if (left() <= budget_.candidates / 2 || d.metres > kLongest * list[0].metres) break;
        StraightCandidate c = plain;
        c.azimuth_deg = d.deg;
        c.lines = std::max(1, static_cast<int>(std::lround(share * d.swaths)));
        judge(c);
        if (!budget_.steered) continue;
        // Where the seafloor steps, the two ways to share the ground differ most, and no variation
        // leads from one to the other.
        c.by_distance = true;
        judge(c);
      }
    }
    if (has_budget() && !list.empty()) few_rows(list[0].deg, list[0].swaths);
  }

  /// A length or time that is set may hold far fewer rows than W asks for.
  void few_rows(double deg, double swaths) {
    const int least = static_cast<int>(
        *std::min_element(std::begin(kLineShares), std::end(kLineShares)) * swaths);
    for (int lines = 1; lines < least && left() > budget_.candidates / 4; lines *= 2) {
      for (const double azimuth : {deg, std::fmod(deg + 90.0, 180.0)}) {
        if (azimuth != deg && shop_.options().heading) continue;
        StraightCandidate c;
        c.azimuth_deg = azimuth;
        c.lines = lines;
        judge(c);
      }
    }
  }

  /// Of the candidates on the front that were not varied yet: the one with the most worth, or the
  /// one that the goal picks. pool_.size(): there is none.
  [[nodiscard]] std::size_t most_promising(bool for_goal) const {
    std::vector<std::size_t> list = front();
    std::erase_if(list, [&](std::size_t i) { return varied_[i] != 0; });
    if (list.empty()) return pool_.size();
    return pick_among(outcomes_of(pool_), list, for_goal ? goal() : PlanGoal{}, price_);
  }

  [[nodiscard]] std::vector<std::size_t> front() const {
    const std::vector<Outcome> outcomes = outcomes_of(pool_);
    auto list = pareto_front(outcomes);
    const auto useful = [&](std::size_t i) { return outcomes[i].cover_pct >= kLeastUsefulPct; };
    if (!has_budget() && std::any_of(list.begin(), list.end(), useful)) {
      std::erase_if(list, [&](std::size_t i) { return !useful(i); });
    }
    return list;
  }

  [[nodiscard]] std::vector<StraightCandidate> variations(const StraightCandidate& c) const {
    std::vector<StraightCandidate> list;
    const auto vary = [&](auto member, auto value) {
      StraightCandidate v = c;
      v.*member = value;
      if (!(v == c)) list.push_back(v);
    };
    vary(&StraightCandidate::by_distance, !c.by_distance);
    const int step = std::max(1, c.lines / 25);
    const double radius = shop_.options().vehicle.turn_radius_m;
    vary(&StraightCandidate::lines, c.lines + step);
    vary(&StraightCandidate::lines, c.lines - step);
    if (c.lines > 1) {
      const double ends = c.end_rows.value_or(0.5);
      for (const double e : {ends - 0.1, ends + 0.15, 0.95}) {
        if (e > 0.2 && e < 1.0) vary(&StraightCandidate::end_rows, std::optional<double>(e));
      }
    }
    for (const double inset : {0.05, radius, 2.0 * radius})
      vary(&StraightCandidate::inset_m, inset);
    for (const double p : {0.0, 0.15, 0.35, 0.6}) vary(&StraightCandidate::percentile, p);
    for (const double o : {0.1, 0.4, 0.8, 1.5, 3.0}) vary(&StraightCandidate::overlap_m, o);
    if (shop_.options().cover == Cover::hit) {
      for (const double g : {1.0, 1.2, 1.5}) vary(&StraightCandidate::gap, g);
    }
    for (const double s : {0.65, 1.0}) vary(&StraightCandidate::widest_share, s);
    if (!shop_.options().heading) {
      vary(&StraightCandidate::azimuth_deg, std::fmod(c.azimuth_deg + 90.0, 180.0));
      vary(&StraightCandidate::azimuth_deg, c.azimuth_deg + 4.0);
      vary(&StraightCandidate::azimuth_deg, c.azimuth_deg - 4.0);
    }
    for (const double p : {0.42, 0.5, 0.58}) vary(&StraightCandidate::phase, p);
    return list;
  }

  /// The finalists: those about the goal, and others spread over the front.
  [[nodiscard]] std::vector<JudgedCandidate> exact_front() {
    const std::vector<Outcome> outcomes = outcomes_of(pool_);
    std::vector<std::size_t> finalists = about_the_goal(outcomes, front(), goal());
    const std::size_t most = budget_.finalists + finalists.size() / 2;
    for (const std::size_t i :
         spread(outcomes, front(), multiplied(kFinalistPrices, price_), pool_.size())) {
      finalists.push_back(i);
    }
    std::vector<JudgedCandidate> list;
    for (const std::size_t i : finalists) {
      if (list.size() == most) break;
      const bool apart = std::all_of(list.begin(), list.end(), [&](const JudgedCandidate& j) {
        return std::abs(j.candidate.lines - pool_[i].candidate.lines) > 0 ||
               j.candidate.azimuth_deg != pool_[i].candidate.azimuth_deg ||
               std::abs(j.outcome.length_ratio / pool_[i].outcome.length_ratio - 1.0) > kApart;
      });
      if (apart) list.push_back(pool_[i]);
    }
    const Watch& watch = shop_.options().watch;
    watch.phase("finishing the best straight lines");
    std::size_t done = 0;
    for (JudgedCandidate& j : list) {
      if (done > 0 && watch.ended()) break;
      j.built = build(j.candidate, shop_);
      j.outcome = shop_.judge(j.built.route, 1, j.outcome.what);
      watch.tried(++done, list.size(), brief(j.outcome));
    }
    list.resize(done);
    return list;
  }

  /// Takes the finalists that are best at each price of length, lays their rows anew block by
  /// block, and adds the results. Between two of these it adds one more where their lengths lie far
  /// apart.
  void add_blocked(std::vector<JudgedCandidate>& list) const {
    const std::vector<JudgedCandidate> finalists = list;
    const std::vector<Outcome> outcomes = outcomes_of(finalists);
    std::vector<std::size_t> all(outcomes.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    std::map<std::size_t, std::vector<double>> prices_of;
    for (const double price : budget_.block_prices) {
      for (const std::size_t best : spread(outcomes, all, {price}, 1)) {
        prices_of[best].push_back(price);
      }
    }
    shop_.options().watch.phase("mixing rows block by block");
    for (const auto& [i, prices] : prices_of) {
      if (over()) return;
      add_blocked(finalists[i].candidate, prices, list);
    }
  }

  void add_blocked(const StraightCandidate& base, const std::vector<double>& prices,
                   std::vector<JudgedCandidate>& list) const {
    BlockSearch search(base, budget_.coarse + kBlockCoarser, shop_);
    if (!search.has_blocks()) return;
    std::vector<Outcome> found;
    const auto add = [&](const std::optional<BlockedRows>& rows) {
      if (!rows) return;
      found.push_back(rows->outcome);
      JudgedCandidate j{rows->base, rows->outcome, {}};
      j.built = shop_.build(rows->lines, width_of(base, shop_), angles_of(base));
      j.outcome = shop_.judge(j.built.route, 1, rows->outcome.what);
      list.push_back(std::move(j));
    };
    for (const double price : prices) {
      if (over()) return;
      add(search.best_for(price));
    }
    const std::vector<Outcome> ends = found;
    const std::vector<std::size_t> order = pareto_front(ends);
    for (std::size_t k = 0; k + 1 < order.size(); ++k) {
      const Outcome& shorter = ends[order[k]];
      const Outcome& longer = ends[order[k + 1]];
      if (over() || longer.length_ratio < kStraightGap * shorter.length_ratio) continue;
      add(search.best_between(shorter, longer));
    }
  }

  LineWorkshop& shop_;
  SearchBudget budget_;
  double price_;  ///< of an ideal length, in points of coverage
  std::vector<JudgedCandidate> pool_;
  std::size_t best_ = 0;  ///< of the pool, for the watch
  std::vector<char> varied_;
  std::vector<StraightCandidate> tried_;
  std::set<std::size_t> routes_;
};

}  // namespace

std::vector<JudgedCandidate> search_straight_lines(LineWorkshop& shop, const SearchBudget& budget) {
  return Search(shop, budget).run();
}

}  // namespace swathplan
