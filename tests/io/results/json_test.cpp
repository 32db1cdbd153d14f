#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/results/plan_json.h"
#include "io/results/score_json.h"
#include "io/sample_plan.h"

namespace swathplan {
namespace {

using nlohmann::json;

struct Sample {
  Area area{{.outer = {{0, 0}, {60, 0}, {60, 40}, {0, 40}}, .holes = {}}};
  Route route = test::parallel_lines({.min = Vec2(0.0, 0.0), .max = Vec2(60.0, 40.0)}, 20.0);
  CoverageGrid grid = test::swept(area, 0.5, route, 8.0);
  Score score = test::plain_score(grid, route, 2400.0);
};

TEST(ScoreJson, HoldsEveryFigureUnderItsName) {
  Sample s;
  s.score.overlap = 1.25;
  s.score.pings = 12;
  s.score.rays = 3072;
  s.score.route.min_turn_radius_m = 3.5;
  s.score.route.min_under_keel_m = -0.25;
  s.score.route.outside_water_m = 7.5;
  s.score.route.self_crossings = 4;
  s.score.route.shared_stretches = 2;
  s.score.route.shared_m = 55.5;
  const json read = json::parse(score_json("nuc", s.score, test::provenance()));
  EXPECT_EQ(read["planner"], "nuc");
  EXPECT_EQ(read["coverage_hit_pct"], s.score.all.hit_pct);
  EXPECT_EQ(read["coverage_footprint_pct"], s.score.all.footprint_pct.value());
  EXPECT_TRUE(read["coverage_footprint_logged_pct"].is_null());  // not scored in the sample
  EXPECT_EQ(read["coverage_hit_logged_pct"], s.score.logged.hit_pct);
  EXPECT_EQ(read["length_m"], s.score.route.length_m);
  EXPECT_EQ(read["length_ratio"], s.score.route.length_ratio);
  EXPECT_EQ(read["length_by_kind_m"]["line"], 0.9 * s.score.route.length_m);
  EXPECT_EQ(read["cells"], s.score.cells);
  EXPECT_EQ(read["pings"], 12);
  EXPECT_EQ(read["rays"], 3072);
  EXPECT_EQ(read["self_crossings"], 4);
  EXPECT_EQ(read["shared_stretches"], 2);
  EXPECT_EQ(read["shared_m"], 55.5);
  EXPECT_EQ(read["outside_water_m"], 7.5);
  EXPECT_EQ(read["min_under_keel_m"], -0.25);
  EXPECT_EQ(read["turns"], s.score.route.turns);
  EXPECT_EQ(read["min_turn_radius_m"], 3.5);
  EXPECT_EQ(read["holidays"], 2);
  EXPECT_EQ(read["largest_holiday_m2"], 12.5);
  EXPECT_EQ(read["duration_s"], s.score.route.duration_s);
  EXPECT_EQ(read["overlap_soundings_per_cell"], 1.25);
  EXPECT_EQ(read["holidays_listed_by_cause_m2"]["edge"], 0.5);
}

TEST(ScoreJson, SharesTheEnergyOutByLine) {
  Sample s;
  s.score.route.duration_s = 100.0;
  s.score.route.duration_by_line_s = {{1, 30.0}, {2, 60.0}};
  s.score.route.contingency_s = 15.0;
  s.score.route.energy_wh = 50.0;
  const json read = json::parse(score_json("nuc", s.score, test::provenance()));
  EXPECT_EQ(read["contingency_s"], 15.0);
  EXPECT_EQ(read["duration_with_contingency_s"], 115.0);
  EXPECT_EQ(read["energy_wh"], 50.0);
  EXPECT_EQ(read["energy_by_line_wh"]["1"], 15.0);
  EXPECT_EQ(read["energy_by_line_wh"]["2"], 30.0);
}

TEST(ScoreJson, TellsWhatMadeItWithoutFolders) {
  const Sample s;
  const std::string text = score_json("nuc", s.score, test::provenance());
  const json read = json::parse(text);
  EXPECT_EQ(read["version"], "0.1.0");
  EXPECT_EQ(read["seed"], 7);
  EXPECT_EQ(read["input_file"], "harbour.ply");
  EXPECT_EQ(read["input_hash"], test::provenance().input_hash);
  EXPECT_EQ(read["options"]["beams"], 256);
  EXPECT_EQ(read["options"]["resolution_m"], 0.1);
  EXPECT_EQ(read["options"]["footprint"], true);
  EXPECT_EQ(read["options"]["depth_band_limits_m"], json::array({8.0, 15.5}));
  EXPECT_EQ(text.find("/somewhere"), std::string::npos);
}

TEST(ScoreJson, SaysNullForAFigureThatDoesNotExist) {
  const Sample s;  // its smallest radius is infinite
  const json read = json::parse(score_json("nuc", s.score, test::provenance()));
  EXPECT_TRUE(read["min_turn_radius_m"].is_null());
}

TEST(ScoreJson, SurvivesAFileNameThatIsNotUtf8) {
  const Sample s;
  Provenance provenance = test::provenance();
  provenance.input_file = "r\xF8nne.tif";
  EXPECT_TRUE(json::accept(score_json("nuc", s.score, provenance)));
}

/// Two squares side by side, each a region, and a third beyond a blocked edge.
PlanFacts three_squares() {
  const PlanarMesh mesh{
      .vertices = {{0, 0}, {10, 0}, {20, 0}, {30, 0}, {0, 10}, {10, 10}, {20, 10}, {30, 10}},
      .faces = {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}}};
  const std::vector<SharedEdge> edges{{.face = {0, 1}, .edge = {1, 3}},
                                      {.face = {1, 2}, .edge = {1, 3}}};
  DepthRegions regions;
  regions.band_limits_m = {8.0};
  for (std::uint32_t i = 0; i < 3; ++i) {
    regions.regions.push_back({.band = static_cast<int>(i % 2),
                               .faces = {i},
                               .mean_depth_m = 5.0 + i,
                               .min_depth_m = 4.0,
                               .max_depth_m = 9.0,
                               .area_m2 = 100.0});
  }
  const Gates gates{
      .gates = {{.edge = 0, .region_a = 0, .region_b = 1, .slope = Angle::degrees(7.5)}},
      .blocked_edges = {1}};
  const FanAngles fan{Angle::degrees(50.0), Angle::degrees(40.0)};
  return plan_facts("mdnuc", mesh, edges, regions, gates, {fan, fan, fan});
}

TEST(PlanJson, HoldsRegionsGatesAndBlockedEdgesInFileCoordinates) {
  const Frame frame{.origin = Vec2(1000.0, 2000.0), .metres_per_unit = 1.0, .crs_wkt = ""};
  const json read = json::parse(plan_json(three_squares(), frame, test::provenance()));
  EXPECT_EQ(read["planner"], "mdnuc");
  ASSERT_EQ(read["regions"].size(), 3U);
  EXPECT_EQ(read["regions"][2]["id"], 2);
  EXPECT_EQ(read["regions"][2]["mean_depth_m"], 7.0);
  EXPECT_NEAR(read["regions"][0]["opening_deg"].get<double>(), 90.0, 1e-9);
  ASSERT_EQ(read["gates"].size(), 1U);
  EXPECT_EQ(read["gates"][0]["regions"], json::array({0, 1}));
  EXPECT_NEAR(read["gates"][0]["slope_deg"].get<double>(), 7.5, 1e-9);
  EXPECT_EQ(read["gates"][0]["edge_xy"], json::parse("[[1010.0,2000.0],[1010.0,2010.0]]"));
  EXPECT_EQ(read["blocked_edges"], json::parse("[[[1020.0,2000.0],[1020.0,2010.0]]]"));
  EXPECT_EQ(read["sonar"]["beams"], 256);
  EXPECT_EQ(read["vehicle"]["draft_m"], 0.3);
  EXPECT_EQ(read["version"], "0.1.0");
  EXPECT_TRUE(read["crs_wkt"].is_null());
}

TEST(PlanJson, SaysWhatCannotBeSailedWhereAndWhy) {
  Route route;
  for (const double x : {0.0, 10.0, 30.0}) {
    route.waypoints.emplace_back();
    route.waypoints.back().position = {x, 0.0};
  }
  route.waypoints[1].kind = LegKind::transit;
  route.waypoints[1].feasible = false;
  route.waypoints.back().kind = LegKind::end;
  PlanFacts facts;
  facts.violations =
      plan_violations(route, {.turn_radius_m = 5.0},
                      {{.outer = {{-9, -9}, {99, -9}, {99, 9}, {-9, 9}}, .holes = {}}});
  const Frame frame{.origin = Vec2(1000.0, 2000.0), .metres_per_unit = 1.0, .crs_wkt = ""};
  const json read = json::parse(plan_json(facts, frame, test::provenance()));
  ASSERT_EQ(read["violations"].size(), 1U);
  EXPECT_EQ(read["violations"][0],
            json::parse(R"({"what": "infeasible", "leg": "transit", "waypoints": [1, 2],
                            "at_xy": [1020.0, 2000.0], "length_m": 20.0,
                            "reason": "no forward way with turns of 5 m stays in safe water"})"));
}

TEST(PlanJson, HoldsTheChoicesThatThePlannerHad) {
  PlanFacts facts;
  facts.planner = "fitted-lines";
  facts.choices = {{.length_ratio = 1.5,
                    .cover_pct = 95.0,
                    .turns = 20,
                    .length_m = 3000.0,
                    .duration_s = 1500.0,
                    .what = "9 straight rows",
                    .infeasible_legs = 2},
                   {.length_ratio = 2.0,
                    .cover_pct = 99.0,
                    .turns = 30,
                    .length_m = 4000.0,
                    .duration_s = 2000.0,
                    .what = "11 straight rows"}};
  facts.chosen = 1;
  facts.chosen_why = "the most coverage";
  const json read = json::parse(plan_json(facts, {}, test::provenance()));
  ASSERT_EQ(read["choices"].size(), 2U);
  EXPECT_EQ(read["choices"][0],
            json::parse(R"({"coverage_hit_pct": 95.0, "length_ratio": 1.5, "length_m": 3000.0,
                            "turns": 20, "duration_s": 1500.0, "infeasible_legs": 2, "made_of": "9 straight rows",
                            "picked": false})"));
  EXPECT_EQ(read["choices"][1]["picked"], true);
  facts.choices[0].cover = Cover::footprint;
  EXPECT_EQ(
      json::parse(plan_json(facts, {}, test::provenance()))["choices"][0]["coverage_footprint_pct"],
      95.0);
  EXPECT_EQ(read["picked_because"], "the most coverage");
  facts.choices.clear();
  EXPECT_TRUE(json::parse(plan_json(facts, {}, test::provenance()))["picked_because"].is_null());
}

}  // namespace
}  // namespace swathplan
