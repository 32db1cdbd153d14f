#include "io/results/score_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/sample_plan.h"

namespace swathplan {
namespace {

using nlohmann::json;

struct ScoreSample {
  Area area{{.outer = {{0, 0}, {60, 0}, {60, 40}, {0, 40}}, .holes = {}}};
  Route route = test::parallel_lines({.min = Vec2(0.0, 0.0), .max = Vec2(60.0, 40.0)}, 20.0);
  CoverageGrid grid = test::swept(area, 0.5, route, 8.0);
  Score score = test::plain_score(grid, route, 2400.0);
};

TEST(ScoreJson, HoldsEveryFigureUnderItsName) {
  ScoreSample s;
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

TEST(ScoreJson, NamesTheLegWithTheLeastWaterUnderTheKeel) {
  ScoreSample s;
  EXPECT_TRUE(
      json::parse(score_json("nuc", s.score, test::provenance()))["least_under_keel"].is_null());
  s.score.route.least_water = {
      .leg = 3, .kind = LegKind::line, .line = 2, .under_keel_m = 0.5, .start_s = 60.0};
  s.score.route.under_keel_by_line_m = {{1, 1.5}, {2, 0.5}};
  s.score.route.over_land_m = 2.5;
  s.score.route.over_unknown_m = 4.0;
  const json read = json::parse(score_json("nuc", s.score, test::provenance()));
  EXPECT_EQ(
      read["least_under_keel"],
      json({{"leg", 3}, {"kind", "line"}, {"line", 2}, {"start_s", 60.0}, {"under_keel_m", 0.5}}));
  EXPECT_EQ(read["under_keel_by_line_m"], json({{"1", 1.5}, {"2", 0.5}}));
  EXPECT_EQ(read["over_land_m"], 2.5);
  EXPECT_EQ(read["over_unknown_m"], 4.0);
}

TEST(ScoreJson, SharesTheEnergyOutByLine) {
  ScoreSample s;
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
  const ScoreSample s;
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
  const ScoreSample s;  // its smallest radius is infinite
  const json read = json::parse(score_json("nuc", s.score, test::provenance()));
  EXPECT_TRUE(read["min_turn_radius_m"].is_null());
}

TEST(ScoreJson, SurvivesAFileNameThatIsNotUtf8) {
  const ScoreSample s;
  Provenance provenance = test::provenance();
  provenance.input_file = "r\xF8nne.tif";
  EXPECT_TRUE(json::accept(score_json("nuc", s.score, provenance)));
}

}  // namespace
}  // namespace swathplan
