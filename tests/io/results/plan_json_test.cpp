#include "io/results/plan_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/sample_plan.h"

namespace swathplan {
namespace {

using nlohmann::json;

/// Two squares side by side, each a region, and a third beyond a blocked edge.
Plan three_squares() {
  Plan plan;
  plan.mesh = {
      .vertices = {{0, 0}, {10, 0}, {20, 0}, {30, 0}, {0, 10}, {10, 10}, {20, 10}, {30, 10}},
      .faces = {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}}};
  plan.edges = {{.face = {0, 1}, .edge = {1, 3}}, {.face = {1, 2}, .edge = {1, 3}}};
  plan.regions.band_limits_m = {8.0};
  for (std::uint32_t i = 0; i < 3; ++i) {
    plan.regions.regions.push_back({.band = static_cast<int>(i % 2),
                                    .faces = {i},
                                    .mean_depth_m = 5.0 + i,
                                    .min_depth_m = 4.0,
                                    .max_depth_m = 9.0,
                                    .area_m2 = 100.0});
  }
  plan.gates = {.gates = {{.edge = 0, .region_a = 0, .region_b = 1, .slope = Angle::degrees(7.5)}},
                .blocked_edges = {1}};
  plan.openings.assign(3, Angle::degrees(90.0));
  return plan;
}

TEST(PlanJson, HoldsRegionsGatesAndBlockedEdgesInFileCoordinates) {
  const Frame frame{.origin = Vec2(1000.0, 2000.0), .metres_per_unit = 1.0, .crs_wkt = ""};
  PlanRecord record = plan_record(three_squares(), {}, {}, {});
  record.planner = "mdnuc";
  EXPECT_NEAR(area_m2(record.regions[1].outline), 100.0, 1e-6);
  const json read = json::parse(plan_json(record, frame, test::provenance()));
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
  PlanRecord record;
  record.violations =
      plan_violations(route, {.turn_radius_m = 5.0},
                      {{.outer = {{-9, -9}, {99, -9}, {99, 9}, {-9, 9}}, .holes = {}}});
  const Frame frame{.origin = Vec2(1000.0, 2000.0), .metres_per_unit = 1.0, .crs_wkt = ""};
  const json read = json::parse(plan_json(record, frame, test::provenance()));
  ASSERT_EQ(read["violations"].size(), 1U);
  EXPECT_EQ(read["violations"][0],
            json::parse(R"({"what": "infeasible", "leg": "transit", "waypoints": [1, 2],
                            "at_xy": [1020.0, 2000.0], "length_m": 20.0,
                            "reason": "no forward way with turns of 5 m stays in safe water"})"));
}

TEST(PlanJson, HoldsTheChoicesThatThePlannerHad) {
  PlanRecord record;
  record.planner = "fitted-lines";
  record.choices = {{.length_ratio = 1.5,
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
  record.chosen = 1;
  record.chosen_why = "the most coverage";
  const json read = json::parse(plan_json(record, {}, test::provenance()));
  ASSERT_EQ(read["choices"].size(), 2U);
  EXPECT_EQ(read["choices"][0],
            json::parse(R"({"coverage_hit_pct": 95.0, "length_ratio": 1.5, "length_m": 3000.0,
                            "turns": 20, "duration_s": 1500.0, "infeasible_legs": 2, "made_of": "9 straight rows",
                            "picked": false})"));
  EXPECT_EQ(read["choices"][1]["picked"], true);
  record.choices[0].cover = Cover::footprint;
  EXPECT_EQ(json::parse(
                plan_json(record, {}, test::provenance()))["choices"][0]["coverage_footprint_pct"],
            95.0);
  EXPECT_EQ(read["picked_because"], "the most coverage");
  record.choices.clear();
  EXPECT_TRUE(json::parse(plan_json(record, {}, test::provenance()))["picked_because"].is_null());
}

}  // namespace
}  // namespace swathplan
