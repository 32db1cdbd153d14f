#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "io/report/verdict_internal.h"
#include "planners/pareto.h"

namespace swathplan::internal {
namespace {

std::string with_commas(double whole) {
  const std::string digits = fmt::format("{:.0f}", whole);
  std::string out;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) out += ',';
    out += digits[i];
  }
  return out;
}

/// Whether it is predicted to pass, or which rules it fails by; the rules' figures stand elsewhere.
std::string short_sentence(const Verdict& verdict) {
  if (verdict.pass) return "predicted to pass " + verdict.title;
  std::string failing;
  for (const JudgedRule& rule : verdict.rules) {
    if (!rule.pass) failing += (failing.empty() ? " by " : ", ") + rule.name;
  }
  return "predicted to fail " + verdict.title + failing;
}

double covered_pct(const Score& score) {
  return score.goal ? score.goal->covered_pct : score.counted().hit_pct;
}

bool reaches_goal(const Score& score) {
  return score.goal && score.goal->covered_pct >= score.goal->wanted_pct;
}

}  // namespace

std::string percent_text(double percent) {
  const double shown = percent < 100.0 ? std::min(percent, 99.9) : percent;
  return fmt::format("{:.1f}", shown);
}

std::string area_text(double square_metres) {
  if (square_metres >= 100.0) return with_commas(square_metres);
  return fmt::format("{:.{}f}", square_metres, square_metres >= 1.0 ? 1 : 2);
}

std::string cause_text(HolidayCause cause) {
  if (cause == HolidayCause::edge) return "at the edge";
  std::string text(name(cause));
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

std::string time_text(double seconds) {
  const auto minutes = static_cast<long>(std::lround(seconds / 60.0));
  if (seconds < 60.0) return fmt::format("{:.0f} s", seconds);
  if (minutes < 60) return fmt::format("{} min", minutes);
  return fmt::format("{} h {:02} min", minutes / 60, minutes % 60);
}

std::string length_text(double metres) {
  return metres < 1000.0 ? fmt::format("{:.0f} m", metres)
                         : fmt::format("{:.1f} km", metres / 1000.0);
}

std::string gaps_text(const Score& score) {
  const Holidays& gaps = score.holidays;
  if (gaps.count == 0) return "No gaps.";
  const auto listed = static_cast<std::size_t>(
      std::count_if(gaps.list.begin(), gaps.list.end(),
                    [](const Holiday& gap) { return gap.cells >= kSpeckleCells; }));
  if (listed == 0) return "No gaps but speckle of a cell or a few.";
  std::string text =
      fmt::format("{} gap{}", with_commas(static_cast<double>(listed)), listed == 1 ? "" : "s");
  if (gaps.count > listed) {
    text += fmt::format(" beside {} smaller one{} or speckle",
                        with_commas(static_cast<double>(gaps.count - listed)),
                        gaps.count - listed == 1 ? "" : "s");
  }
  return text + fmt::format("; the largest {} m², {}.", area_text(gaps.largest_m2),
                            cause_text(gaps.list.front().cause));
}

std::string verdict(const ComparedPlan& plan) {
  const Score& score = *plan.score;
  const CoverageFigures& counted = score.counted();
  std::string text = fmt::format(
      "{}, {}, {} % {}, 5 soundings in {} % of cells", time_text(score.route.duration_s),
      length_text(score.route.length_m), percent_text(counted.hit_pct),
      score.logged_counts ? "logged" : "covered by all pings", percent_text(counted.hit_5_pct));
  if (plan.judged != nullptr) text += ": " + short_sentence(plan.judged->verdict);
  text += ".";
  // The least hours are of all of the site: they are no measure for a plan of a part of it.
  constexpr double kNearlyAll = 90.0;
  if (score.least_hours && *score.least_hours > 0.0 && counted.hit_pct >= kNearlyAll) {
    text += fmt::format(" {:.2f} times the least hours that the site can take.",
                        score.route.duration_s / 3600.0 / *score.least_hours);
  }
  return text;
}

std::vector<std::string> warnings(const Score& score) {
  std::vector<std::string> list;
  if (score.route.outside_water_m > 0.0) {
    list.push_back(fmt::format("Leaves the water for {:.1f} m", score.route.outside_water_m));
  }
  if (score.route.over_land_m > 0.0) {
    list.push_back(fmt::format("Crosses {:.1f} m of land or no-go areas", score.route.over_land_m));
  }
  if (score.route.over_unknown_m > 0.0) {
    list.push_back(fmt::format("Crosses {:.1f} m of ground without data: look at a chart",
                               score.route.over_unknown_m));
  }
  if (score.route.min_under_keel_m < 0.0) {
    list.push_back(
        fmt::format("Runs aground: {:.2f} m too little water", -score.route.min_under_keel_m));
  }
  if (score.route.infeasible_legs > 0) {
    list.push_back(fmt::format(
        "{} leg{} ({:.0f} m) cannot be steered in safe water", score.route.infeasible_legs,
        score.route.infeasible_legs == 1 ? "" : "s", std::ceil(score.route.infeasible_m)));
  }
  return list;
}

std::size_t best_plan(const std::vector<ComparedPlan>& plans) {
  const auto sound = [](const ComparedPlan& p) { return warnings(*p.score).empty(); };
  const auto passes = [](const ComparedPlan& p) { return p.judged && p.judged->verdict.pass; };
  const auto hours = [](const ComparedPlan& p) { return p.score->route.duration_s; };
  const auto most = [&](std::size_t a, std::size_t b) {
    return covered_pct(*plans[a].score) < covered_pct(*plans[b].score);
  };
  std::vector<std::size_t> among(plans.size());
  std::iota(among.begin(), among.end(), std::size_t{0});
  const auto keep = [&](const auto& rule) {
    std::vector<std::size_t> kept;
    std::copy_if(among.begin(), among.end(), std::back_inserter(kept),
                 [&](std::size_t i) { return rule(plans[i]); });
    if (!kept.empty()) among = kept;
  };
  keep(sound);
  keep(passes);
  if (passes(plans[among.front()])) {
    return *std::min_element(among.begin(), among.end(), [&](std::size_t a, std::size_t b) {
      return hours(plans[a]) < hours(plans[b]);
    });
  }
  keep([&](const ComparedPlan& p) { return reaches_goal(*p.score); });
  if (!reaches_goal(*plans[among.front()].score)) {
    return *std::max_element(among.begin(), among.end(), most);
  }
  const auto to_pick_by = [&](std::size_t i) {
    return hours_to_pick_by(hours(plans[i]), covered_pct(*plans[i].score));
  };
  return *std::min_element(among.begin(), among.end(), [&](std::size_t a, std::size_t b) {
    return to_pick_by(a) < to_pick_by(b);
  });
}

std::string overall_verdict(const std::vector<ComparedPlan>& plans) {
  if (plans.size() < 2) return {};
  const ComparedPlan& best = plans[best_plan(plans)];
  const bool passes = best.judged != nullptr && best.judged->verdict.pass;
  std::string why = "it passes in the fewest hours";
  if (!passes && reaches_goal(*best.score)) {
    why = fmt::format(
        "the fewest hours that cover at least {:.4g} % of the cells; a point more "
        "counts {:g} % of the hours",
        best.score->goal->wanted_pct, 100.0 * kHoursOfPointBeyond);
  } else if (!passes) {
    why = best.score->goal ? fmt::format("the most coverage, as none reaches {:.4g} % of the cells",
                                         best.score->goal->wanted_pct)
                           : "the most coverage";
  }
  return fmt::format("The best of {} plans is {}: {}.", plans.size(), best.name, why);
}

}  // namespace swathplan::internal
