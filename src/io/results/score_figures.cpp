#include "io/results/score_figures.h"

#include <map>
#include <optional>

namespace swathplan {
namespace {

using Json = nlohmann::ordered_json;

double share_pct(std::uint64_t part, std::uint64_t whole) {
  return whole > 0 ? 100.0 * static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}

Json number_or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

void add_coverage(Json& json, const Score& score) {
  json["coverage_hit_pct"] = score.all.hit_pct;
  json["coverage_footprint_pct"] = number_or_null(score.all.footprint_pct);
  json["coverage_hit_logged_pct"] = score.logged.hit_pct;
  json["coverage_footprint_logged_pct"] = number_or_null(score.logged.footprint_pct);
  json["coverage_hit_2_pct"] = score.all.hit_2_pct;
  json["coverage_hit_5_pct"] = score.all.hit_5_pct;
  json["coverage_hit_2_logged_pct"] = score.logged.hit_2_pct;
  json["coverage_hit_5_logged_pct"] = score.logged.hit_5_pct;
  json["overlap_soundings_per_cell"] = score.overlap;
  json["several_legs_pct"] = score.several_legs_pct;
  json["cells"] = score.cells;
  json["pings"] = score.pings;
  json["mean_ping_spacing_m"] = score.pinging.mean_spacing_m;
  json["largest_ping_spacing_m"] = score.pinging.largest_spacing_m;
  json["sound_bound_pings_pct"] = share_pct(score.pinging.sound_bound, score.pinging.intervals);
  json["rays"] = score.rays;
  json["soundings"] = score.soundings;
  json["survey_area_m2"] = score.survey_area_m2;
  json["footprint_width_m"] = score.footprint_width_m;
}

/// Only where a part was covered before.
void add_whole(Json& json, const WholeFigures& whole) {
  json["whole_cells"] = whole.cells;
  json["whole_area_m2"] = whole.area_m2;
  json["covered_before_pct"] = whole.before_pct;
  json["coverage_whole_pct"] = whole.all_pct;
  json["coverage_whole_logged_pct"] = whole.logged_pct;
  json["gaps_left_out_m2"] = whole.left_out_m2;
}

void add_route(Json& json, const RouteFigures& route) {
  json["length_m"] = route.length_m;
  json["length_ratio"] = route.length_ratio;
  json["logged_length_m"] = route.logged_length_m;
  json["length_by_kind_m"] = Json::object();
  for (const auto& [kind, metres] : route.length_by_kind_m) {
    json["length_by_kind_m"][kind] = metres;
  }
  json["duration_s"] = route.duration_s;
  json["duration_by_kind_s"] = Json::object();
  for (const auto& [kind, seconds] : route.duration_by_kind_s) {
    json["duration_by_kind_s"][kind] = seconds;
  }
  json["duration_by_line_s"] = Json::object();
  for (const auto& [line, seconds] : route.duration_by_line_s) {
    json["duration_by_line_s"][std::to_string(line)] = seconds;
  }
  json["contingency_s"] = route.contingency_s;
  json["duration_with_contingency_s"] = route.duration_s + route.contingency_s;
  json["energy_wh"] = route.energy_wh ? Json(*route.energy_wh) : Json(nullptr);
  json["energy_by_line_wh"] = Json::object();
  if (route.energy_wh && route.duration_s > 0.0) {
    for (const auto& [line, seconds] : route.duration_by_line_s) {
      json["energy_by_line_wh"][std::to_string(line)] =
          *route.energy_wh * seconds / route.duration_s;
    }
  }
  json["beyond_endurance"] = route.beyond_endurance;
  json["infeasible_legs"] = route.infeasible_legs;
  json["infeasible_m"] = route.infeasible_m;
  json["tight_turn_m"] = route.tight_turn_m;
  json["turns"] = route.turns;
  json["sharp_turns"] = route.sharp_turns;
  json["total_turning_deg"] = route.total_turning_deg;
  json["min_turn_radius_m"] = route.min_turn_radius_m;
  json["sharp_corners"] = route.sharp_corners;
  json["self_crossings"] = route.self_crossings;
  json["shared_stretches"] = route.shared_stretches;
  json["shared_m"] = route.shared_m;
  json["outside_water_m"] = route.outside_water_m;
  json["cross_lines"] = route.cross.lines;
  json["cross_lines_length_m"] = route.cross.length_m;
  json["cross_lines_share_pct"] = 100.0 * route.cross.share();
  json["cross_lines_crossings"] = route.cross.crossings;
  json["cross_lines_right_angled"] = route.cross.right_angled;
  json["over_land_m"] = route.over_land_m;
  json["over_unknown_m"] = route.over_unknown_m;
  json["min_under_keel_m"] = route.min_under_keel_m;
  json["least_under_keel"] = nullptr;
  if (const auto& least = route.least_water) {
    json["least_under_keel"] = {{"leg", least->leg},
                                {"kind", name(least->kind)},
                                {"line", least->line ? Json(*least->line) : Json(nullptr)},
                                {"start_s", least->start_s},
                                {"under_keel_m", least->under_keel_m}};
  }
  json["under_keel_by_line_m"] = Json::object();
  for (const auto& [line, metres] : route.under_keel_by_line_m) {
    json["under_keel_by_line_m"][std::to_string(line)] = metres;
  }
}

void add_hours(Json& json, const Score& score) {
  json["least_hours"] = number_or_null(score.least_hours);
  const bool known = score.least_hours && *score.least_hours > 0.0;
  json["hours_ratio"] =
      known ? Json(score.route.duration_s / 3600.0 / *score.least_hours) : Json(nullptr);
}

void add_holidays(Json& json, const Score& score) {
  const Holidays& holidays = score.holidays;
  json["holidays_of"] = score.logged_counts ? "logged pings" : "all pings";
  json["holidays"] = holidays.count;
  json["largest_holiday_m2"] = holidays.largest_m2;
  json["holidays_total_m2"] = holidays.total_m2;
  json["holidays_listed"] = holidays.list.size();
  json["holidays_listed_by_cause_m2"] = Json::object();
  std::map<HolidayCause, double> by_cause;
  for (const Holiday& h : holidays.list) by_cause[h.cause] += h.area_m2;
  for (const auto& [cause, metres] : by_cause) {
    json["holidays_listed_by_cause_m2"][std::string(name(cause))] = metres;
  }
}

}  // namespace

nlohmann::ordered_json score_figures(const Score& score) {
  Json json = Json::object();
  add_coverage(json, score);
  if (score.whole) add_whole(json, *score.whole);
  add_route(json, score.route);
  add_hours(json, score);
  add_holidays(json, score);
  return json;
}

}  // namespace swathplan
