#include "planners/job/whole_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "coverage/route/cross_figures.h"
#include "coverage/route/route_figures.h"
#include "mesh/base/require.h"
#include "planners/job/job_order.h"
#include "planners/job/sorties.h"
#include "planners/job/strung_route.h"
#include "planners/wording.h"

namespace swathplan {
namespace {

/// Another order must save this share of the time before joins are made anew.
constexpr double kWorthReordering = 0.003;
/// Sorties that turn out too long are cut anew for so much less, up to so often.
constexpr double kTighter = 0.995;
constexpr int kMostCuts = 12;
/// Boats are balanced anew, up to so often, while one takes so much longer than another.
constexpr double kUneven = 1.01;
constexpr int kMostBalances = 4;
/// Cross-lines that turns made too short are laid anew for a little more, up to so often.
constexpr int kMostRelaid = 3;
constexpr double kShareReserve = 1.002, kShareDust = 1e-6;
/// Boats that cannot be kept apart otherwise begin later, by steps of this share of the makespan,
/// up to so many.
constexpr double kWaitStep = 0.01;
constexpr int kMostWaits = 30;

int largest_line_number(const Route& route) {
  int largest = 0;
  for (const Waypoint& w : route.waypoints) largest = std::max(largest, w.line.value_or(0));
  return largest;
}

std::vector<int> line_numbers(const Route& route) {
  std::vector<int> numbers;
  for (const Waypoint& w : route.waypoints) {
    if (!is_survey(w.kind) || !w.line) continue;
    if (numbers.empty() || numbers.back() != *w.line) numbers.push_back(*w.line);
  }
  return numbers;
}

/// Lines by what they are for.
struct LineGroups {
  std::vector<JobLine> patch, cross, main;
};

bool holds(const std::vector<JobLine>& lines, const std::optional<int>& number) {
  return number && std::any_of(lines.begin(), lines.end(), [&](const JobLine& line) {
           return line.points.front().line == number;
         });
}

LineGroups grouped(std::vector<JobLine> lines) {
  LineGroups groups;
  for (JobLine& line : lines) {
    const LegKind kind = purpose(line);
    auto& group = kind == LegKind::patch   ? groups.patch
                  : kind == LegKind::cross ? groups.cross
                                           : groups.main;
    // A join from a line of another group leads nowhere any more.
    if (group.empty()) line.join_before.clear();
    // Of several boats' patch tests in a route, one is enough to go by.
    if (purpose(line) == LegKind::patch && holds(group, line.points.front().line)) continue;
    group.push_back(std::move(line));
  }
  return groups;
}

/// What all steps work with.
class JobMaker {
 public:
  JobMaker(const Ground& ground, const PlanOptions& options, const JobOptions& how)
      : ground_(ground),
        options_(options),
        how_(how),
        connector_(connector_for(ground, options)),
        ways_(ground, options) {}

  Job make(const Route& main) {
    LineGroups groups = grouped(job_lines(main, options_.vehicle.turn_radius_m));
    if (groups.main.empty() && groups.cross.empty() && groups.patch.empty()) {
      throw InvalidInput("the route holds no survey line to make a job of");
    }
    set_berth(groups, main);
    next_number_ = largest_line_number(main) + 1;
    add_lines(groups);
    std::vector<JobLine> lines = in_sequence(groups);
    for (int more = 0; more < kMostRelaid && is_short_of_cross_lines(); ++more) {
      relay_cross_lines(groups);
      lines = in_sequence(groups);
    }
    if (how_.boats > 1) {
      divide_by_boats(lines);
    } else if (how_.longest_sortie_s) {
      boats_ = {sorties_of(lines, berth_)};
    } else {
      boats_ = {{undivided_}};
    }
    return finished();
  }

 private:
  using Built = std::vector<BuiltRoute>;  // of one boat's sorties

  void say(std::string note) {
    if (std::find(job_.notes.begin(), job_.notes.end(), note) == job_.notes.end()) {
      job_.notes.push_back(std::move(note));
    }
  }

  void set_berth(const LineGroups& groups, const Route& main) {
    berth_ = how_.berth;
    if (!berth_ && (how_.boats > 1 || how_.longest_sortie_s)) {
      berth_ = main.waypoints.front().position;
      const Vec2 at = file_place(*berth_);
      say(
          fmt::format("no berth was given: boats begin and end where the first line does, at "
                      "{:.1f},{:.1f}",
                      at.x(), at.y()));
    }
    if (!berth_) return;
    std::size_t cut_off = 0, all = 0;
    for (const auto* group : {&groups.patch, &groups.cross, &groups.main}) {
      for (const JobLine& line : *group) {
        ++all;
        cut_off += ways_.joined(*berth_, line.points.front().position) ? 0 : 1;
      }
    }
    const Vec2 at = file_place(*berth_);
    if (cut_off == all) {
      throw UsageError(fmt::format(
          "the <berth> at {:.1f},{:.1f} is cut off: no way through safe water leads from it to any "
          "survey line; choose another one, or make the safe water wider (<clearance>, <margin>)",
          at.x(), at.y()));
    }
    if (cut_off > 0) {
      say(
          fmt::format("no way through safe water leads from the berth to {} of {} lines; the ways "
                      "there are marked infeasible",
                      cut_off, all));
    }
  }

  [[nodiscard]] Vec2 file_place(const Vec2& local) const {
    return ground_.seafloor != nullptr ? ground_.seafloor->frame.to_file(local) : local;
  }

  void add_lines(LineGroups& groups) {
    if (how_.patch_test) add_patch_test(groups);
    if (!(how_.cross_share > 0.0)) return;
    if (!groups.cross.empty()) {
      say("the route holds cross-lines already; none were added");
      return;
    }
    cross_aim_ = how_.cross_share;
    lay_cross_lines(groups);
  }

  void add_patch_test(LineGroups& groups) {
    if (!groups.patch.empty()) {
      say("the route holds patch-test lines already; none were added");
      return;
    }
    PatchTestPlan plan = patch_test(ground_, options_, connector_, next_number_);
    next_number_ += static_cast<int>(plan.lines.size());
    groups.patch = std::move(plan.lines);
    job_.summary.patch_tests = std::move(plan.tests);
    for (const PatchTest& test : job_.summary.patch_tests) {
      if (test.lines.empty()) say(fmt::format("patch test, {}: {}", test.name, test.reason));
    }
  }

  /// Each boat has a sonar of its own to calibrate. The first sails the patch test before all else,
  /// the last after all else, others between, so that no two meet there.
  [[nodiscard]] SortieLines with_patch_test(SortieLines part, std::size_t boat,
                                            std::size_t boats) const {
    if (patch_.empty()) return part;
    const double share = static_cast<double>(boat) / static_cast<double>(boats - 1);
    const auto at = part.begin() + static_cast<std::ptrdiff_t>(
                                       std::lround(share * static_cast<double>(part.size())));
    if (at != part.end()) at->join_before.clear();
    part.insert(at, patch_.begin(), patch_.end());
    return part;
  }

  void lay_cross_lines(LineGroups& groups) {
    CrossLines laid = cross_lines(groups.main, ground_, options_, connector_,
                                  {.share = cross_aim_, .first_number = next_number_});
    groups.cross = std::move(laid.lines);
    laid.lines.clear();
    job_.summary.cross = laid;
    job_.summary.cross_share_asked = how_.cross_share;
  }

  /// Turns onto cross-lines may have cut their ends off, and so taken from their share.
  [[nodiscard]] bool is_short_of_cross_lines() const {
    const double found = cross_figures(undivided_.route).share();
    return cross_aim_ > 0.0 && found > 0.0 && found < how_.cross_share &&
           job_.summary.cross->share >= cross_aim_ - kShareDust;
  }
  void relay_cross_lines(LineGroups& groups) {
    const double found = cross_figures(undivided_.route).share();
    cross_aim_ = std::min(1.0, kShareReserve * cross_aim_ * how_.cross_share / found);
    lay_cross_lines(groups);
  }

  /// All lines in sailing order; sets the undivided route.
  std::vector<JobLine> in_sequence(const LineGroups& groups) {
    std::vector<JobLine> lead = groups.patch;
    JobEnds ends;
    ends.out = berth_;
    if (!lead.empty()) ends.after = lead.back();
    for (JobLine& line : in_best_order(groups.cross, ways_, ends)) lead.push_back(std::move(line));
    if (!lead.empty()) ends.after = lead.back();
    ends.home = berth_;
    const std::vector<JobLine> given = in_given_order(groups.main, ways_, ends);
    const std::vector<JobLine> best = in_best_order(groups.main, ways_, ends);
    const auto joined_to_lead = [&](const std::vector<JobLine>& main) {
      std::vector<JobLine> all = lead;
      all.insert(all.end(), main.begin(), main.end());
      return all;
    };
    std::vector<JobLine> chosen = joined_to_lead(given);
    undivided_ = strung(chosen, first_berth(), ground_, options_, connector_);
    if (estimated_s(best, ways_, ends) <
        (1.0 - kWorthReordering) * estimated_s(given, ways_, ends)) {
      std::vector<JobLine> other = joined_to_lead(best);
      BuiltRoute built = strung(other, first_berth(), ground_, options_, connector_);
      if (is_better(built.route, undivided_.route)) {
        undivided_ = std::move(built);
        chosen = std::move(other);
      }
    }
    job_.summary.undivided_s = sailing_s(undivided_.route.waypoints);
    return chosen;
  }

  static bool is_better(const Route& a, const Route& b) {
    constexpr double kDust = 1e-3;
    const double more = infeasible_m(a) - infeasible_m(b);
    if (std::abs(more) > kDust) return more < 0.0;
    return sailing_s(a.waypoints) < sailing_s(b.waypoints);
  }

  [[nodiscard]] std::optional<Berth> first_berth() const {
    return berth_ ? std::optional(Berth{*berth_, std::nullopt}) : std::nullopt;
  }

  [[nodiscard]] double with_contingency(double seconds) const {
    return (1.0 + options_.vehicle.contingency) * seconds;
  }

  [[nodiscard]] Built built(const std::vector<SortieLines>& sorties) const {
    Built routes;
    std::optional<Berth> lying = first_berth();
    for (const SortieLines& lines : sorties) {
      routes.push_back(strung(lines, lying, ground_, options_, connector_));
      lying = end_of(routes.back().route);
    }
    return routes;
  }

  static double longest_of(const Built& routes) {
    double longest = 0.0;
    for (const BuiltRoute& b : routes) longest = std::max(longest, sailing_s(b.route.waypoints));
    return longest;
  }

  /// Sorties that keep to their hours as sailed, not only by the estimate.
  [[nodiscard]] Built sorties_of(const std::vector<JobLine>& lines,
                                 const std::optional<Vec2>& berth) const {
    const double longest = *how_.longest_sortie_s / (1.0 + options_.vehicle.contingency);
    double aim = longest;
    for (int cut = 0; cut < kMostCuts; ++cut) {
      Built routes = built(cut_into_sorties(lines, ways_, *berth, aim));
      const double found = longest_of(routes);
      if (found <= longest) return routes;
      aim *= kTighter * longest / found;
    }
    throw UsageError(fmt::format(
        "sorties of {:.2f} h are too short: ways between the lines and the berth take most of "
        "them; make them longer (<sortie hours>), or choose a nearer <berth>",
        *how_.longest_sortie_s / 3600.0));
  }

  /// Parts of the boats, as sailed.
  struct Shared {
    std::vector<SortieLines> parts;
    std::vector<double> seconds;
    BoatsApart apart;
    [[nodiscard]] double longest() const {
      return *std::max_element(seconds.begin(), seconds.end());
    }
    /// Apart by a swath comes first; then a second on neighbouring lines counts as so much more
    /// time.
    [[nodiscard]] bool better_than(const Shared& other) const {
      constexpr double kDust = 0.5, kNeighbourWorth = 0.2;
      if (std::abs(apart.within_a_swath_s - other.apart.within_a_swath_s) > kDust) {
        return apart.within_a_swath_s < other.apart.within_a_swath_s;
      }
      return longest() + kNeighbourWorth * apart.neighbours_s <
             other.longest() + kNeighbourWorth * other.apart.neighbours_s;
    }
  };

  [[nodiscard]] Shared shared(std::vector<SortieLines> parts) const {
    Shared result;
    std::vector<BuiltRoute> routes;
    for (std::size_t boat = 0; boat < parts.size(); ++boat) {
      if (boat > 0) parts[boat] = with_patch_test(std::move(parts[boat]), boat, parts.size());
      routes.push_back(strung(parts[boat], first_berth(), ground_, options_, connector_));
      result.seconds.push_back(sailing_s(routes.back().route.waypoints));
    }
    std::vector<BoatTrack> tracks;
    for (const BuiltRoute& built : routes) tracks.push_back({{0.0, &built.route}});
    result.apart = boats_apart(tracks, ground_, options_.vehicle);
    result.parts = std::move(parts);
    return result;
  }

  /// The parts with each boat's main scheme sailed forwards or backwards: all ways to do so.
  [[nodiscard]] static std::vector<std::vector<SortieLines>> turned(
      const std::vector<SortieLines>& parts) {
    std::vector<std::vector<SortieLines>> all;
    for (std::size_t mask = 0; mask < (std::size_t{1} << std::min<std::size_t>(parts.size(), 3));
         ++mask) {
      std::vector<SortieLines> some = parts;
      for (std::size_t boat = 0; boat < parts.size(); ++boat) {
        if ((mask >> boat & 1U) == 0) continue;
        const auto lead = static_cast<std::ptrdiff_t>(leading(parts[boat]));
        const SortieLines main(parts[boat].begin() + lead, parts[boat].end());
        some[boat].erase(some[boat].begin() + lead, some[boat].end());
        for (JobLine& line : backwards(main)) some[boat].push_back(std::move(line));
      }
      all.push_back(std::move(some));
    }
    return all;
  }

  void divide_by_boats(std::vector<JobLine> lines) {
    const auto end_of_patch = std::find_if(lines.begin(), lines.end(), [](const JobLine& line) {
      return purpose(line) != LegKind::patch;
    });
    patch_.assign(lines.begin(), end_of_patch);
    lines.erase(lines.begin(), end_of_patch);
    if (!patch_.empty() && !lines.empty()) lines.front().join_before.clear();
    std::vector<double> weights;
    std::optional<Shared> best;
    for (int round = 0; round < kMostBalances; ++round) {
      std::vector<SortieLines> parts = cut_for_boats(lines, ways_, *berth_, how_.boats, weights);
      parts.front() = with_patch_test(std::move(parts.front()), 0, 2);
      std::vector<std::vector<SortieLines>> ways_to_sail = turned(parts);
      ways_to_sail.push_back(
          kept_apart(parts, leading(parts.front()), ground_, options_.vehicle, ways_, *berth_));
      std::optional<Shared> here;
      for (std::vector<SortieLines>& way : ways_to_sail) {
        Shared sailed = shared(std::move(way));
        if (!here || sailed.better_than(*here)) here = std::move(sailed);
      }
      weights.resize(parts.size(), 1.0);
      for (std::size_t k = 0; k < parts.size(); ++k) {
        JobEnds ends;
        ends.out = ends.home = berth_;
        weights[k] = here->seconds[k] / std::max(1.0, estimated_s(here->parts[k], ways_, ends));
      }
      const double shortest = *std::min_element(here->seconds.begin(), here->seconds.end());
      const bool even = here->longest() < kUneven * shortest;
      if (!best || here->better_than(*best)) best = std::move(here);
      if (even) break;
    }
    for (const SortieLines& part : best->parts) {
      boats_.push_back(how_.longest_sortie_s ? sorties_of(part, berth_) : built({part}));
    }
  }

  /// How many lines come before the main scheme.
  static std::size_t leading(const SortieLines& lines) {
    std::size_t count = 0;
    while (count < lines.size() && purpose(lines[count]) != LegKind::line) ++count;
    return count;
  }

  /// When a sortie that could begin at `from_s` begins.
  [[nodiscard]] double begins(double from_s, double seconds) const {
    if (!how_.daylight) return from_s;
    constexpr double kDay = 24.0 * 3600.0;
    const double dawn = 3600.0 * how_.daylight->from_h;
    const double dusk = 3600.0 * how_.daylight->to_h;
    const double day = std::floor(from_s / kDay) * kDay;
    const double now = std::max(from_s, day + dawn);
    return now + with_contingency(seconds) <= day + dusk ? now : day + kDay + dawn;
  }

  [[nodiscard]] std::vector<std::vector<double>> schedule(const std::vector<double>& waits) const {
    std::vector<std::vector<double>> times;
    for (std::size_t b = 0; b < boats_.size(); ++b) {
      times.emplace_back();
      double now = waits[b];
      for (const BuiltRoute& sortie : boats_[b]) {
        const double seconds = sailing_s(sortie.route.waypoints);
        times.back().push_back(begins(now, seconds));
        now = times.back().back() + (how_.daylight ? with_contingency(seconds) : seconds);
      }
    }
    return times;
  }

  [[nodiscard]] BoatsApart watched(const std::vector<std::vector<double>>& times) const {
    std::vector<BoatTrack> tracks;
    for (std::size_t b = 0; b < boats_.size(); ++b) {
      tracks.emplace_back();
      for (std::size_t s = 0; s < boats_[b].size(); ++s) {
        tracks.back().push_back({times[b][s], &boats_[b][s].route});
      }
    }
    return boats_apart(tracks, ground_, options_.vehicle);
  }

  /// When boats begin so that none comes within a swath of another.
  std::vector<std::vector<double>> kept_apart_in_time() {
    std::vector<double> waits(boats_.size(), 0.0);
    std::vector<std::vector<double>> best = schedule(waits);
    if (boats_.size() < 2) return best;
    job_.summary.apart = watched(best);
    double longest = 0.0;
    for (const Built& boat : boats_) {
      double sum = 0.0;
      for (const BuiltRoute& b : boat) sum += sailing_s(b.route.waypoints);
      longest = std::max(longest, sum);
    }
    for (std::size_t b = boats_.size(); b-- > 0;) {
      std::vector<double> tried = waits;
      for (int k = 1; k <= kMostWaits && job_.summary.apart.within_a_swath_s > 0.0; ++k) {
        tried[b] = k * kWaitStep * longest;
        const auto times = schedule(tried);
        const BoatsApart apart = watched(times);
        if (apart.within_a_swath_s >= job_.summary.apart.within_a_swath_s) continue;
        job_.summary.apart = apart;
        best = times;
        waits = tried;
      }
    }
    return best;
  }

  /// Says where a way out of the berth or home cannot be sailed as drawn.
  void say_berth_ways(const Route& route) {
    if (!berth_) return;
    const auto& w = route.waypoints;
    const auto is_on_line = [](const Waypoint& p) {
      return is_survey(p.kind) || p.kind == LegKind::run_in;
    };
    const auto first = std::find_if(w.begin(), w.end(), is_on_line);
    const auto last = std::find_if(w.rbegin(), w.rend(), [](const Waypoint& p) {
                        return is_survey(p.kind) || p.kind == LegKind::run_out;
                      }).base();
    for (const auto& [begin, end, what] :
         {std::tuple(w.begin(), first, "out of"), std::tuple(last, w.end(), "home to")}) {
      const auto bad = std::find_if(
          begin, end, [](const Waypoint& p) { return !p.feasible && p.kind != LegKind::end; });
      if (bad == end) continue;
      const Vec2 at = file_place(bad->position), berth = file_place(*berth_);
      say(fmt::format(
          "a way {} the berth at {:.1f},{:.1f} cannot be sailed as drawn about "
          "{:.1f},{:.1f}: no forward way with turns of {:g} m stays in safe water there; "
          "take another <berth>, or turn by hand",
          what, berth.x(), berth.y(), at.x(), at.y(), options_.vehicle.turn_radius_m));
    }
  }

  Job finished() {
    JobSummary& summary = job_.summary;
    if (const double share = cross_figures(undivided_.route).share();
        cross_aim_ > 0.0 && share < how_.cross_share) {
      say(fmt::format(
          "cross-lines make up {:.2f} % of the main scheme, not the {:g} % asked for: no further "
          "straight line with room to turn crosses it near a right angle",
          100.0 * share, 100.0 * how_.cross_share));
    }
    summary.berth = berth_;
    summary.boats = static_cast<int>(boats_.size());
    summary.longest_sortie_s = how_.longest_sortie_s;
    summary.by_daylight = how_.daylight.has_value();
    const auto times = kept_apart_in_time();
    for (std::size_t b = 0; b < boats_.size(); ++b) {
      double ends = 0.0;
      for (std::size_t s = 0; s < boats_[b].size(); ++s) {
        BuiltRoute& sortie = boats_[b][s];
        JobSortie row = row_of(sortie.route);
        row.boat = static_cast<int>(b) + 1;
        row.number = static_cast<int>(s) + 1;
        row.begins_s = times[b][s];
        ends = row.begins_s + row.duration_s;
        summary.sailed_s += row.duration_s;
        summary.sorties.push_back(std::move(row));
        for (std::string& note : sortie.notes) say(std::move(note));
        say_berth_ways(sortie.route);
        job_.routes.push_back(std::move(sortie.route));
      }
      const double dawn = how_.daylight ? 3600.0 * how_.daylight->from_h : 0.0;
      summary.makespan_s = std::max(summary.makespan_s, ends - dawn);
    }
    std::vector<const Route*> all;
    for (const Route& route : job_.routes) all.push_back(&route);
    job_.route = one_after_the_other(all);
    if (summary.apart.within_a_swath_s > 0.0) {
      say(
          fmt::format("two boats on lines are nearer to each other than a swath for {:.0f} s: no "
                      "order of their lines and no later beginning keeps them apart",
                      summary.apart.within_a_swath_s));
    }
    if (summary.boats < how_.boats) {
      say(fmt::format("there is work for {} only", counted(boats_.size(), "boat")));
    }
    return std::move(job_);
  }

  [[nodiscard]] JobSortie row_of(const Route& route) const {
    JobSortie row;
    const auto& w = route.waypoints;
    row.length_m = length_m(route);
    row.duration_s = sailing_s(w);
    row.with_contingency_s = with_contingency(row.duration_s);
    for (std::size_t i = 0; i + 1 < w.size(); ++i) {
      if (w[i].log) row.logged_m += (w[i + 1].position - w[i].position).norm();
    }
    row.lines = line_numbers(route);
    return row;
  }

  const Ground& ground_;
  const PlanOptions& options_;
  const JobOptions& how_;
  Connector connector_;
  JobWays ways_;
  std::optional<Vec2> berth_;
  int next_number_ = 1;
  std::vector<JobLine> patch_;  // of each of several boats
  double cross_aim_ = 0.0;
  BuiltRoute undivided_;
  std::vector<Built> boats_;
  Job job_;
};

}  // namespace

void check(const JobOptions& how) {
  if (how.cross_share != 0.0) check(CrossLineOptions{.share = how.cross_share});
  require(how.boats >= 1 && how.boats <= kMostBoats, "boats", how.boats,
          "a whole number from 1 to 8");
  if (how.longest_sortie_s) require_positive("sortie hours", *how.longest_sortie_s / 3600.0);
}

Job whole_job(const Route& main, const Ground& ground, const PlanOptions& options,
              const JobOptions& how) {
  check(how);
  return JobMaker(ground, options, how).make(main);
}

}  // namespace swathplan
