#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/report/verdict_internal.h"

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

std::string times(double ratio) { return fmt::format("{:.2f} times the ideal length", ratio); }

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

std::string gaps_text(const Score& score) {
  const Holidays& gaps = score.holidays;
  if (gaps.count == 0) return "No gaps.";
  std::string text = fmt::format(
      "{} gap{}, {} m² in all; the largest {} m²", with_commas(static_cast<double>(gaps.count)),
      gaps.count == 1 ? "" : "s", area_text(gaps.total_m2), area_text(gaps.largest_m2));
  if (!gaps.list.empty()) text += ", " + cause_text(gaps.list.front().cause);
  return text + ".";
}

std::string verdict(const Score& score) {
  return fmt::format("Covers {} % at {}. {}", percent_text(score.all.hit_pct),
                     times(score.route.length_ratio), gaps_text(score));
}

std::vector<std::string> warnings(const Score& score) {
  std::vector<std::string> list;
  if (score.route.outside_water_m > 0.0) {
    list.push_back(fmt::format("Leaves the water for {:.1f} m", score.route.outside_water_m));
  }
  if (score.route.unknown_depth_m > 0.0) {
    list.push_back(fmt::format("Crosses {:.1f} m of land or ground without a known depth",
                               score.route.unknown_depth_m));
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
  if (score.route.self_crossings > 0) {
    list.push_back(fmt::format("Crosses its own path {} time{}", score.route.self_crossings,
                               score.route.self_crossings == 1 ? "" : "s"));
  }
  return list;
}

std::string overall_verdict(const std::vector<std::string>& planners,
                            const std::vector<const Score*>& scores) {
  std::size_t best = 0, shortest = 0;
  for (std::size_t i = 1; i < scores.size(); ++i) {
    if (scores[i]->all.hit_pct > scores[best]->all.hit_pct) best = i;
    if (scores[i]->route.length_m < scores[shortest]->route.length_m) shortest = i;
  }
  const auto pair = [&](std::size_t i) {
    return fmt::format("{} ({} % at {})", planners[i], percent_text(scores[i]->all.hit_pct),
                       times(scores[i]->route.length_ratio));
  };
  if (scores.size() == 1) return {};
  if (best == shortest) return fmt::format("{} covers most and is the shortest.", pair(best));
  return fmt::format("{} covers most; {} is the shortest.", pair(best), pair(shortest));
}

}  // namespace swathplan::internal
