#include "io/results/plan_json.h"

#include <fmt/format.h>

#include <cmath>

#include "io/files/atomic_file.h"
#include "io/results/job_json.h"
#include "io/results/provenance_json.h"

namespace swathplan {
namespace {

using Json = nlohmann::ordered_json;

Json point(const Vec2& local, const Frame& frame) {
  const Vec2 file = frame.to_file(local);
  return Json::array({file.x(), file.y()});
}

Json edge(const std::pair<Vec2, Vec2>& e, const Frame& frame) {
  return Json::array({point(e.first, frame), point(e.second, frame)});
}

/// Of straight lines, from 0 to 360 degrees; null where they share none.
Json azimuth(const PlanRecord& record, Angle north) {
  if (!record.heading) return nullptr;
  const double deg = std::fmod((*record.heading + north).deg() + 720.0, 360.0);
  return std::fmod(std::round(1e6 * deg) / 1e6, 360.0);
}

Json regions_json(const PlanRecord& record) {
  Json list = Json::array();
  for (std::size_t i = 0; i < record.regions.size(); ++i) {
    const PlanRegion& r = record.regions[i];
    list.push_back({{"id", i},
                    {"band", r.band},
                    {"faces", r.faces},
                    {"area_m2", r.area_m2},
                    {"min_depth_m", r.min_depth_m},
                    {"mean_depth_m", r.mean_depth_m},
                    {"max_depth_m", r.max_depth_m},
                    {"opening_deg", (r.fan.port + r.fan.starboard).deg()},
                    {"port_deg", r.fan.port.deg()},
                    {"stbd_deg", r.fan.starboard.deg()}});
  }
  return list;
}

Json gates_json(const PlanRecord& record, const Frame& frame) {
  Json list = Json::array();
  for (const PlanGate& g : record.gates) {
    list.push_back({{"regions", {g.region_a, g.region_b}},
                    {"slope_deg", g.slope.deg()},
                    {"edge_xy", edge(g.edge, frame)}});
  }
  return list;
}

Json choices_json(const PlanRecord& record) {
  Json list = Json::array();
  for (std::size_t i = 0; i < record.choices.size(); ++i) {
    const Outcome& o = record.choices[i];
    list.push_back({{fmt::format("coverage_{}_pct", name(o.cover)), expected_cover_pct(o)},
                    {"length_ratio", o.length_ratio},
                    {"length_m", o.length_m},
                    {"turns", o.turns},
                    {"duration_s", o.duration_s},
                    {"infeasible_legs", o.infeasible_legs},
                    {"made_of", o.what},
                    {"picked", i == record.chosen}});
    if (o.whole_cover_pct) list.back()["coverage_within_margin_pct"] = o.cover_pct;
  }
  return list;
}

Json violations_json(const PlanRecord& record, const Frame& frame) {
  Json list = Json::array();
  for (const PlanViolation& v : record.violations) {
    list.push_back({{"what", name(v.violation.kind)},
                    {"leg", v.leg},
                    {"waypoints", {v.violation.first, v.violation.last}},
                    {"at_xy", point(v.violation.position, frame)},
                    {"length_m", v.violation.length_m},
                    {"reason", v.reason}});
  }
  return list;
}

/// Their outlines stand in hazards.geojson.
Json hazards_json(const PlanRecord& record) {
  Json classes = Json::array();
  for (const HazardCount& c : record.hazards.counts) {
    classes.push_back({{"layer", c.layer},
                       {"found", c.found},
                       {"near", c.near},
                       {"without_position", c.without_place},
                       {"least_buffer_m", c.near > 0 ? Json(c.least_buffer_m) : Json(nullptr)},
                       {"most_buffer_m", c.near > 0 ? Json(c.most_buffer_m) : Json(nullptr)},
                       {"to_be_seen", c.to_be_seen}});
  }
  return classes;
}

Json sonar_json(const Sonar& s) {
  return {{"name", s.name},
          {"beams", s.beams},
          {"spacing", s.spacing == BeamSpacing::equiangular ? "equiangular" : "equidistant"},
          {"beam_width_along_deg", tidy_degrees(s.beam_width_along)},
          {"beam_width_across_deg", tidy_degrees(s.beam_width_across)},
          {"max_opening_deg", tidy_degrees(s.max_opening)},
          {"max_ping_rate_hz", s.max_ping_rate_hz},
          {"max_range_m", s.max_range_m}};
}

Json vehicle_json(const Vehicle& v) {
  return {{"name", v.name},
          {"speed_mps", v.speed_mps},
          {"turn_radius_m", v.turn_radius_m},
          {"draft_m", v.draft_m},
          {"under_keel_margin_m", v.under_keel_margin_m}};
}

}  // namespace

std::string plan_json(const PlanRecord& record, const Frame& frame, const Provenance& provenance) {
  Json json = provenance_json(provenance);
  json["planner"] = record.planner;
  json["coordinates"] = "x, y of the input file";
  json["crs_wkt"] = frame.crs_wkt.empty() ? Json(nullptr) : Json(frame.crs_wkt);
  json["meridian_convergence_deg"] = record.grid_north.deg();
  json["heading_true_deg"] = azimuth(record, record.grid_north);
  json["heading_grid_deg"] = azimuth(record, {});
  json["sonar"] = sonar_json(record.sonar);
  json["vehicle"] = vehicle_json(record.vehicle);
  json["band_limits_m"] = record.band_limits_m;
  json["regions"] = regions_json(record);
  json["gates"] = gates_json(record, frame);
  json["blocked_edges"] = Json::array();
  for (const auto& e : record.blocked_edges) json["blocked_edges"].push_back(edge(e, frame));
  json["choices"] = choices_json(record);
  json["picked_because"] = record.choices.empty() ? Json(nullptr) : Json(record.chosen_why);
  json["job"] = record.job ? job_json(*record.job, record.job_files, frame) : Json(nullptr);
  json["violations"] = violations_json(record, frame);
  json["hazards"] = hazards_json(record);
  json["notes"] = record.notes;
  return json_text(json);
}

void write_plan_json(const std::filesystem::path& path, const PlanRecord& record,
                     const Frame& frame, const Provenance& provenance) {
  write_text_atomically(path, plan_json(record, frame, provenance));
}

}  // namespace swathplan
