#include "io/report/report.h"

#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <random>

#include "io/report/display_path_internal.h"
#include "io/report/pictures_internal.h"
#include "io/report/verdict_internal.h"
#include "io/sample_plan.h"
#include "mesh/base/error.h"
#include "mesh/synthetic.h"

namespace swathplan {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

/// Two plans over the saddle.
struct Sample {
  Seafloor seafloor = saddle();
  DepthQuery depths{seafloor};
  Area area{{.outer = {{-40, -40}, {40, -40}, {40, 40}, {-40, 40}}, .holes = {}}};
  std::vector<Route> routes;
  std::vector<CoverageGrid> grids;
  std::vector<Score> scores;

  Sample() {
    for (const double spacing : {25.6, 10.0}) {
      routes.push_back(test::parallel_lines(extent(area), spacing));
      grids.push_back(test::swept(area, 0.25, routes.back(), 6.0));
      scores.push_back(test::plain_score(grids.back(), routes.back(), 6400.0));
    }
  }

  [[nodiscard]] ReportSite site() const {
    return {.title = "A <b>saddle</b> & more",
            .seafloor = &seafloor,
            .depths = &depths,
            .survey_area = area,
            .water = area,
            .no_go = {},
            .vehicle = {},
            .regions = {{.outline = area, .band = 0, .mean_depth_m = 35.0, .opening_deg = 40.0}},
            .gates = {{{0, 0}, {0, 10}}},
            .blocked_edges = {{{0, 10}, {0, 20}}},
            .provenance = test::provenance()};
  }
  [[nodiscard]] std::vector<ReportPlan> plans() const {
    return {{"back-and-forth", &routes[0], &scores[0], &grids[0], 0.25, {"A note."}, {}, 0, {}},
            {"</script><script>alert(1)</script>",
             &routes[1],
             &scores[1],
             &grids[1],
             1.5,
             {},
             {},
             0,
             {}}};
  }
};

json data_of(const std::string& page) {
  const std::string open = R"(<script type="application/json" id="data">)";
  const std::size_t first = page.find(open) + open.size();
  return json::parse(page.substr(first, page.find("</script>", first) - first));
}

std::string bytes_of(const std::string& base64) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  std::uint32_t bits = 0;
  int have = 0;
  for (const char c : base64) {
    if (c == '=') break;
    bits = (bits << 6) | static_cast<std::uint32_t>(digits.find(c));
    have += 6;
    if (have >= 8) out += static_cast<char>((bits >> (have -= 8)) & 0xFFU);
  }
  return out;
}

TEST(Report, IsOnePageThatAsksNobodyForAnything) {
  const Sample s;
  const std::string page = report_html(s.site(), s.plans());
  EXPECT_THAT(page, testing::StartsWith("<!doctype html>"));
  for (const char* never : {"http://", "src=\"", "@import", "url(", "fetch(", "{{"}) {
    std::string rest = page;
    // The namespace of SVG is a name, not an address.
    if (const auto at = rest.find("http://www.w3.org/2000/svg"); at != std::string::npos) {
      rest.erase(at, 26);
    }
    EXPECT_THAT(rest, Not(HasSubstr(never)));
  }
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
  EXPECT_THAT(page, HasSubstr("Predicted, not measured."));
}

TEST(Report, LetsNoNameBreakThePage) {
  const Sample s;
  const std::string page = report_html(s.site(), s.plans());
  EXPECT_THAT(page, HasSubstr("A &lt;b&gt;saddle&lt;/b&gt; &amp; more"));
  EXPECT_THAT(page, Not(HasSubstr("<script>alert")));
  EXPECT_EQ(data_of(page)["plans"][1]["name"], "</script><script>alert(1)</script>");
}

TEST(Report, CarriesFiguresPathsGapsAndSettings) {
  const Sample s;
  const json data = data_of(report_html(s.site(), s.plans()));
  ASSERT_EQ(data["plans"].size(), 2U);
  const json& plan = data["plans"][0];
  EXPECT_EQ(plan["figures"]["coverage_hit_pct"], s.scores[0].all.hit_pct);
  EXPECT_EQ(plan["planning_s"], 0.25);
  EXPECT_EQ(plan["notes"], json::array({"A note."}));
  EXPECT_EQ(plan["holidays"].size(), 2U);
  EXPECT_EQ(plan["holidays"][0]["cause"], "between lines");
  EXPECT_EQ(data["provenance"]["options"]["beams"], 256);
  EXPECT_EQ(data["gates"].size(), 1U);
  EXPECT_EQ(data["blocked"].size(), 1U);
  EXPECT_EQ(data["regions"][0]["opening_deg"], 40.0);
  double walked = 0.0;
  for (const json& part : plan["path"]) {
    const json& line = part["line"];
    for (std::size_t i = 2; i + 1 < line.size(); i += 2) {
      walked += std::hypot(line[i].get<double>(), line[i + 1].get<double>()) / 100.0;
    }
  }
  EXPECT_NEAR(walked, length_m(s.routes[0]), 0.05);
}

TEST(Report, PicturesShowTheGridAndTheDepths) {
  const Sample s;
  const json data = data_of(report_html(s.site(), s.plans()));
  EXPECT_NEAR(data["depth"]["min_m"].get<double>(), 10.0, 0.5);
  EXPECT_NEAR(data["depth"]["max_m"].get<double>(), 60.0, 0.5);
  const std::string png = bytes_of(data["plans"][0]["coverage"]["png"]);
  EXPECT_THAT(png, testing::StartsWith("\x89PNG"));
  EXPECT_EQ(data["plans"][0]["coverage"]["columns"], 320);
  const json& box = data["plans"][0]["coverage"]["box"];
  EXPECT_EQ(box[2].get<int>() - box[0].get<int>(), 8000);
}

TEST(Report, SaysWhereAPlanCannotBeSailedAndWhy) {
  Sample s;
  s.routes[0].waypoints[1].feasible = false;
  ReportSite site = s.site();
  site.vehicle.turn_radius_m = 20.0;
  site.water = {{.outer = {{-40, -40}, {30, -40}, {30, 40}, {-40, 40}}, .holes = {}}};
  const json data = data_of(report_html(site, s.plans()));
  const json& found = data["plans"][0]["violations"];
  ASSERT_EQ(found["count"], found["list"].size());
  const json& leg = found["list"][0];
  EXPECT_EQ(leg["what"], "infeasible");
  EXPECT_NEAR(leg["length_m"].get<double>(), 25.6, 1e-6);
  EXPECT_NEAR(leg["x"].get<double>(), -40 + 25.6, 0.01);
  EXPECT_NEAR(leg["y"].get<double>(), 40.0, 0.01);
  EXPECT_THAT(leg["reason"].get<std::string>(), HasSubstr("no forward way with turns of 20 m"));
  // The other turn, 25.6 m from line to line, is half of that at its corners.
  EXPECT_EQ(found["list"].back()["what"], "tight turn");
  EXPECT_NEAR(data["cut_off"]["area_m2"].get<double>(), 800.0, 1e-6);
  EXPECT_NEAR(data["cut_off"]["share_pct"].get<double>(), 12.5, 1e-6);
  ASSERT_EQ(data["cut_off"]["list"].size(), 1U);
  EXPECT_GT(data["cut_off"]["list"][0]["x"], 30.0);
}

TEST(Report, CarriesTheChoicesOfAPlanner) {
  const Sample s;
  std::vector<ReportPlan> plans = s.plans();
  plans[0].choices = {{.length_ratio = 1.5, .cover_pct = 95.0, .what = "few"},
                      {.length_ratio = 2.0, .cover_pct = 99.0, .what = "many"}};
  plans[0].chosen = 1;
  plans[0].chosen_why = "the most coverage";
  const json data = data_of(report_html(s.site(), plans));
  const json& choices = data["plans"][0]["choices"];
  ASSERT_EQ(choices["list"].size(), 2U);
  EXPECT_EQ(choices["list"][1]["coverage_pct"], 99.0);
  EXPECT_EQ(choices["chosen"], 1);
  EXPECT_EQ(choices["why"], "the most coverage");
  EXPECT_EQ(choices["cover"], "hit");
  EXPECT_TRUE(data["plans"][1]["choices"]["list"].empty());
  for (Outcome& o : plans[0].choices) o.cover = Cover::footprint;
  EXPECT_EQ(data_of(report_html(s.site(), plans))["plans"][0]["choices"]["cover"], "footprint");
}

TEST(Report, NeedsAPlan) {
  const Sample s;
  EXPECT_THROW((void)report_html(s.site(), {}), InvalidInput);
}

TEST(Verdict, SaysCoverageLengthAndGaps) {
  Score score;
  score.all.hit_pct = 99.97;
  score.route.length_ratio = 3.4449;
  EXPECT_EQ(internal::verdict(score), "Covers 99.9 % at 3.44 times the ideal length. No gaps.");
  score.holidays = {.count = 12345, .largest_m2 = 3.44, .total_m2 = 1234.5, .list = {}};
  EXPECT_THAT(internal::verdict(score),
              HasSubstr("12,345 gaps, 1,234 m² in all; the largest 3.4 m²."));
  score.all.hit_pct = 100.0;
  EXPECT_EQ(internal::percent_text(score.all.hit_pct), "100.0");
}

TEST(Verdict, WarnsOfWhatMustNotBeSailed) {
  Score score;
  score.route.min_under_keel_m = 0.5;
  EXPECT_TRUE(internal::warnings(score).empty());
  score.route.outside_water_m = 0.24;
  score.route.min_under_keel_m = -0.5;
  score.route.self_crossings = 1;
  score.route.infeasible_legs = 2;
  score.route.infeasible_m = 31.2;
  EXPECT_THAT(internal::warnings(score),
              testing::ElementsAre(
                  "Leaves the water for 0.2 m", "Runs aground: 0.50 m too little water",
                  "2 legs (32 m) cannot be steered in safe water", "Crosses its own path 1 time"));
}

TEST(Verdict, NamesTheBestAndTheShortest) {
  Score a, b;
  a.all.hit_pct = 60.0;
  a.route.length_m = 10.0;
  b.all.hit_pct = 90.0;
  b.route.length_m = 30.0;
  EXPECT_THAT(internal::overall_verdict({"a", "b"}, {&a, &b}),
              testing::MatchesRegex("b .*covers most; a .*is the shortest."));
  b.route.length_m = 5.0;
  EXPECT_THAT(internal::overall_verdict({"a", "b"}, {&a, &b}),
              testing::MatchesRegex("b .*covers most and is the shortest."));
  EXPECT_EQ(internal::overall_verdict({"a"}, {&a}), "");
}

TEST(DisplayPath, StaysWithinTheTolerance) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> step(-1.0, 1.0);
  std::vector<Vec2> line{Vec2::Zero()};
  for (int i = 0; i < 700; ++i) line.push_back(line.back() + Vec2(step(random), step(random)));
  for (const double tolerance : {0.0, 0.1, 0.7, 3.0}) {
    const std::vector<Vec2> kept = internal::simplified(line, tolerance);
    EXPECT_EQ(kept.front(), line.front());
    EXPECT_EQ(kept.back(), line.back());
    std::size_t segment = 0;
    for (const Vec2& p : line) {
      if (segment + 2 < kept.size() && p == kept[segment + 1]) ++segment;
      const Vec2 a = kept[segment], along = kept[segment + 1] - a;
      const double t = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
      EXPECT_LE((p - a - t * along).norm(), tolerance + 1e-9);
    }
  }
}

TEST(DisplayPath, JoinsWhatLooksAlikeAndKeepsTheEnds) {
  const Route route = test::parallel_lines({.min = Vec2(0.0, 0.0), .max = Vec2(100.0, 50.0)}, 25.0);
  const std::vector<internal::DisplayPath> path = internal::display_path(route, 0.01);
  ASSERT_EQ(path.size(), legs(route).size());
  EXPECT_EQ(path.front().points.front(), route.waypoints.front().position);
  EXPECT_EQ(path.back().points.back(), route.waypoints.back().position);
  for (std::size_t i = 1; i < path.size(); ++i) {
    EXPECT_EQ(path[i].points.front(), path[i - 1].points.back());
  }
}

TEST(Pictures, DepthPictureFollowsTheSeafloor) {
  const Seafloor slope = tilted(100.0, 60.0, 5.0, Angle::degrees(20.0));
  const DepthQuery depths(slope);
  const internal::DepthPicture made =
      internal::depth_picture(depths, {.min = Vec2(-10.0, 0.0), .max = Vec2(90.0, 60.0)}, 100);
  EXPECT_EQ(made.picture.columns, 100U);
  EXPECT_EQ(made.picture.rows, 60U);
  const std::uint8_t* row = &made.picture.pixels[std::size_t{30} * 100];
  EXPECT_EQ(row[5], 0);  // west of the data
  for (int c = 11; c < 100; ++c) {
    EXPECT_GE((row[c] - 1) / internal::kDepthShades, (row[c - 1] - 1) / internal::kDepthShades);
  }
  EXPECT_EQ((row[99] - 1) / internal::kDepthShades, internal::kDepthLevels - 1);
}

TEST(Pictures, CoveragePictureKeepsToItsBudget) {
  const Area area{{.outer = {{0, 0}, {150, 0}, {150, 150}, {0, 150}}, .holes = {}}};
  CoverageGrid grid(area, 0.1);
  std::mt19937 random(9);
  for (std::uint32_t& word : grid.words()) word |= static_cast<std::uint32_t>(random() % 4);
  const internal::CoveragePicture made = internal::coverage_picture(grid, 200'000);
  EXPECT_LE(made.png.size(), 200'000U);
  EXPECT_GT(made.columns, 200U);
  EXPECT_GE(made.box.max.x(), 150.0 - 1e-9);
}

TEST(Pictures, Base64IsTheKnownOne) {
  EXPECT_EQ(internal::base64(""), "");
  EXPECT_EQ(internal::base64("f"), "Zg==");
  EXPECT_EQ(internal::base64("fo"), "Zm8=");
  EXPECT_EQ(internal::base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(bytes_of(internal::base64("\xff\x01z")), "\xff\x01z");
}

}  // namespace
}  // namespace swathplan
