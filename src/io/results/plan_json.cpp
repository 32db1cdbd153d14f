#include "io/results/plan_json.h"

#include <fmt/format.h>

#include "io/files/atomic_file.h"
#include "io/results/provenance_json.h"

namespace swathplan {
namespace {

using Json = nlohmann::ordered_json;

std::pair<Vec2, Vec2> edge_of(const PlanarMesh& mesh, const SharedEdge& shared) {
  const PlanarMesh::Face& face = mesh.faces[shared.face[0]];
  const std::size_t corner = shared.edge[0];
  return {mesh.vertices[face[corner]], mesh.vertices[face[(corner + 1) % face.size()]]};
}

Json point(const Vec2& local, const Frame& frame) {
  const Vec2 file = frame.to_file(local);
  return Json::array({file.x(), file.y()});
}

Json edge(const std::pair<Vec2, Vec2>& e, const Frame& frame) {
  return Json::array({point(e.first, frame), point(e.second, frame)});
}

Json regions_json(const PlanFacts& facts) {
  Json list = Json::array();
  for (std::size_t i = 0; i < facts.regions.size(); ++i) {
    const PlanRegion& r = facts.regions[i];
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

Json gates_json(const PlanFacts& facts, const Frame& frame) {
  Json list = Json::array();
  for (const PlanGate& g : facts.gates) {
    list.push_back({{"regions", {g.region_a, g.region_b}},
                    {"slope_deg", g.slope.deg()},
                    {"edge_xy", edge(g.edge, frame)}});
  }
  return list;
}

Json choices_json(const PlanFacts& facts) {
  Json list = Json::array();
  for (std::size_t i = 0; i < facts.choices.size(); ++i) {
    const Outcome& o = facts.choices[i];
    list.push_back({{fmt::format("coverage_{}_pct", name(o.cover)), expected_cover_pct(o)},
                    {"length_ratio", o.length_ratio},
                    {"length_m", o.length_m},
                    {"turns", o.turns},
                    {"duration_s", o.duration_s},
                    {"infeasible_legs", o.infeasible_legs},
                    {"made_of", o.what},
                    {"picked", i == facts.chosen}});
    if (o.whole_cover_pct) list.back()["coverage_within_margin_pct"] = o.cover_pct;
  }
  return list;
}

Json violations_json(const PlanFacts& facts, const Frame& frame) {
  Json list = Json::array();
  for (const PlanViolation& v : facts.violations) {
    list.push_back({{"what", name(v.violation.kind)},
                    {"leg", v.leg},
                    {"waypoints", {v.violation.first, v.violation.last}},
                    {"at_xy", point(v.violation.position, frame)},
                    {"length_m", v.violation.length_m},
                    {"reason", v.reason}});
  }
  return list;
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

PlanFacts plan_facts(const std::string& planner, const PlanarMesh& mesh,
                     const std::vector<SharedEdge>& edges, const DepthRegions& regions,
                     const Gates& gates, const std::vector<FanAngles>& fans) {
  PlanFacts facts;
  facts.planner = planner;
  facts.band_limits_m = regions.band_limits_m;
  for (std::size_t i = 0; i < regions.regions.size(); ++i) {
    const DepthRegion& r = regions.regions[i];
    facts.regions.push_back({.band = r.band,
                             .faces = r.faces.size(),
                             .area_m2 = r.area_m2,
                             .min_depth_m = r.min_depth_m,
                             .mean_depth_m = r.mean_depth_m,
                             .max_depth_m = r.max_depth_m,
                             .fan = fans.at(i)});
  }
  for (const Gate& g : gates.gates) {
    facts.gates.push_back({.edge = edge_of(mesh, edges[g.edge]),
                           .region_a = g.region_a,
                           .region_b = g.region_b,
                           .slope = g.slope});
  }
  for (const std::uint32_t e : gates.blocked_edges) {
    facts.blocked_edges.push_back(edge_of(mesh, edges[e]));
  }
  return facts;
}

std::vector<PlanViolation> plan_violations(const Route& route, const Vehicle& vehicle,
                                           const Area& water) {
  std::vector<PlanViolation> list;
  for (const Violation& v : violations(route, vehicle, water)) {
    list.push_back(
        {v, std::string(name(route.waypoints[v.first].kind)), reason(v, route, vehicle)});
  }
  return list;
}

std::string plan_json(const PlanFacts& facts, const Frame& frame, const Provenance& provenance) {
  Json json = internal::to_json(provenance);
  json["planner"] = facts.planner;
  json["coordinates"] = "x, y of the input file";
  json["crs_wkt"] = frame.crs_wkt.empty() ? Json(nullptr) : Json(frame.crs_wkt);
  json["sonar"] = sonar_json(facts.sonar);
  json["vehicle"] = vehicle_json(facts.vehicle);
  json["band_limits_m"] = facts.band_limits_m;
  json["regions"] = regions_json(facts);
  json["gates"] = gates_json(facts, frame);
  json["blocked_edges"] = Json::array();
  for (const auto& e : facts.blocked_edges) json["blocked_edges"].push_back(edge(e, frame));
  json["choices"] = choices_json(facts);
  json["picked_because"] = facts.choices.empty() ? Json(nullptr) : Json(facts.chosen_why);
  json["violations"] = violations_json(facts, frame);
  json["notes"] = facts.notes;
  return internal::json_text(json);
}

void write_plan_json(const std::filesystem::path& path, const PlanFacts& facts, const Frame& frame,
                     const Provenance& provenance) {
  write_text_atomically(path, plan_json(facts, frame, provenance));
}

}  // namespace swathplan
