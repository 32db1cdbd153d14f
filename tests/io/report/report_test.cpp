#include "io/report/report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/base64.h"
#include "io/sample_judged.h"
#include "io/sample_plan.h"
#include "mesh/base/error.h"
#include "mesh/synthetic.h"

namespace swathplan {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

/// Two plans over the saddle.
struct ReportSample {
  Seafloor seafloor = saddle();
  DepthQuery depths{seafloor};
  Area area{{.outer = {{-40, -40}, {40, -40}, {40, 40}, {-40, 40}}, .holes = {}}};
  std::vector<Route> routes;
  std::vector<CoverageGrid> grids;
  std::vector<Score> scores;
  std::vector<PlanRecord> records = std::vector<PlanRecord>(2);

  ReportSample() {
    records[0].label = "back-and-forth";
    records[0].notes = {"A note."};
    records[0].regions.emplace_back();
    records[0].regions[0].outline = area;
    records[0].regions[0].fan = {Angle::degrees(20.0), Angle::degrees(20.0)};
    records[0].gates.push_back({.edge = {{0, 0}, {0, 10}}, .slope = {}});
    records[0].blocked_edges = {{{0, 10}, {0, 20}}};
    records[1].label = "</script><script>alert(1)</script>";
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
            .provenance = test::provenance()};
  }
  [[nodiscard]] std::vector<ReportPlan> plans() const {
    return {{&records[0], &routes[0], &scores[0], &grids[0], 0.25},
            {&records[1], &routes[1], &scores[1], &grids[1], 1.5}};
  }
};

json data_of(const std::string& page) {
  const std::string open = R"(<script type="application/json" id="data">)";
  const std::size_t first = page.find(open) + open.size();
  return json::parse(page.substr(first, page.find("</script>", first) - first));
}

TEST(Report, IsOnePageThatAsksNobodyForAnything) {
  const ReportSample s;
  std::string page = report_html(s.site(), s.plans());
  EXPECT_THAT(page, testing::StartsWith("<!doctype html>"));
  // Leaflet asks with it whether it runs in a browser of long ago.
  const std::string asked = "url(#default#VML)";
  page.erase(page.find(asked), asked.size());
  for (const char* never : {"src=\"", "<link rel=\"stylesheet", "@import", "url(", "fetch(",
                            "XMLHttpRequest", "import(", "sourceMappingURL", "{{"}) {
    EXPECT_THAT(page, Not(HasSubstr(never)));
  }
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
  EXPECT_THAT(page, HasSubstr("Predicted, not measured."));
  EXPECT_THAT(page, HasSubstr("Vladimir Agafonkin"));  // the licences of Leaflet and uPlot
  EXPECT_THAT(page, HasSubstr("Copyright (c) 2022 Leon Sorokin"));
}

TEST(Report, LetsNoNameBreakThePage) {
  const ReportSample s;
  const std::string page = report_html(s.site(), s.plans());
  EXPECT_THAT(page, HasSubstr("A &lt;b&gt;saddle&lt;/b&gt; &amp; more"));
  EXPECT_THAT(page, Not(HasSubstr("<script>alert")));
  EXPECT_EQ(data_of(page)["plans"][1]["name"], "</script><script>alert(1)</script>");
}

TEST(Report, CarriesFiguresPathsGapsAndSettings) {
  const ReportSample s;
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
  EXPECT_NEAR(data["regions"][0]["opening_deg"].get<double>(), 40.0, 1e-9);
  double walked = 0.0;
  for (const json& leg : plan["legs"]) {
    const json& line = leg["points"];
    for (std::size_t i = 2; i + 1 < line.size(); i += 2) {
      walked += std::hypot(line[i].get<double>(), line[i + 1].get<double>()) / 100.0;
    }
  }
  EXPECT_NEAR(walked, length_m(s.routes[0]), 0.05);
}

TEST(Report, ListsEachLegAsItIsSailed) {
  ReportSample s;
  s.records[0].grid_north = Angle::degrees(2.0);
  s.records[0].pings.spacing_m = 0.25;
  const json plan = data_of(report_html(s.site(), s.plans()))["plans"][0];
  ASSERT_EQ(plan["legs"].size(), legs(s.routes[0]).size());
  const json& line = plan["legs"][0];  // north along x = -27.2 from edge to edge
  EXPECT_EQ(line["line"], 0);
  EXPECT_EQ(line["kind"], "line");
  EXPECT_EQ(line["from"], json::array({-27.2, -40.0}));
  EXPECT_EQ(line["to"], json::array({-27.2, 40.0}));
  EXPECT_EQ(line["heading_deg"], 2.0);  // true
  EXPECT_EQ(line["length_m"], 80.0);
  EXPECT_EQ(line["port_deg"], json::array({40.0, 40.0}));
  EXPECT_EQ(line["speed_mps"], json::array({2.0, 2.0}));
  // The saddle is (x^2 - y^2) / 64 - 35 high.
  EXPECT_NEAR(line["depth_m"][0].get<double>(), 35.0 - 27.2 * 27.2 / 64.0, 0.05);
  EXPECT_NEAR(line["depth_m"][1].get<double>(), 60.0 - 27.2 * 27.2 / 64.0, 0.05);
  EXPECT_EQ(line["times"].back(), 400);  // tenths of a second
  EXPECT_EQ(line["swath"].size(), 1U);
  EXPECT_FALSE(plan["legs"][1].contains("swath"));  // a turn
  EXPECT_EQ(plan["along"][2][1], 0.25);
}

TEST(Report, DrawsGapsByTheirOutline) {
  ReportSample s;
  Holiday& gap = s.scores[0].holidays.list[0];
  gap.outline = {{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, {}};
  const json data = data_of(report_html(s.site(), s.plans()));
  const json& rings = data["plans"][0]["holidays"][0]["rings"];
  ASSERT_EQ(rings.size(), 1U);
  EXPECT_EQ(rings[0].size(), 14U);  // six corners and the first again
  EXPECT_TRUE(data["plans"][0]["holidays"][1]["rings"].empty());
}

TEST(Report, ShowsTheHazardsOfTheRecord) {
  ReportSample s;
  Hazard wreck;
  wreck.layer = "WRECKS";
  wreck.name = "<b>Anna</b>";
  wreck.buffer_m = 20.0;
  wreck.to_be_seen = true;
  wreck.area = {{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {}}};
  s.records[0].hazards.list = {wreck};
  const std::string page = report_html(s.site(), s.plans());
  EXPECT_THAT(page, Not(HasSubstr("<b>Anna")));
  const json hazard = data_of(page)["hazards"].at(0);
  EXPECT_EQ(hazard["name"], "<b>Anna</b>");
  EXPECT_EQ(hazard["buffer_m"], 20.0);
  EXPECT_EQ(hazard["to_be_seen"], true);
  EXPECT_EQ(hazard["rings"].size(), 1U);
}

TEST(Report, KnowsLongitudeAndLatitudeOfItsMap) {
  ReportSample s;
  EXPECT_TRUE(data_of(report_html(s.site(), s.plans()))["lonlat"].is_null());
  s.seafloor.frame = test::utm_frame();
  const json data = data_of(report_html(s.site(), s.plans()));
  ASSERT_EQ(data["lonlat"].size(), 32U);
  EXPECT_NEAR(data["lonlat"][0].get<double>(), 14.77, 0.01);
  EXPECT_NEAR(data["lonlat"][1].get<double>(), 55.09, 0.01);
}

TEST(Report, PicturesShowTheGridAndTheDepths) {
  const ReportSample s;
  const json data = data_of(report_html(s.site(), s.plans()));
  EXPECT_NEAR(data["depth"]["min_m"].get<double>(), 10.0, 0.5);
  EXPECT_NEAR(data["depth"]["max_m"].get<double>(), 60.0, 0.5);
  const std::string png = test::bytes_of(data["plans"][0]["coverage"]["png"]);
  EXPECT_THAT(png, testing::StartsWith("\x89PNG"));
  EXPECT_EQ(data["plans"][0]["coverage"]["columns"], 320);
  const json& box = data["plans"][0]["coverage"]["box"];
  EXPECT_EQ(box[2].get<int>() - box[0].get<int>(), 8000);
}

TEST(Report, SaysWhereAPlanCannotBeSailedAndWhy) {
  ReportSample s;
  s.routes[0].waypoints[1].feasible = false;
  ReportSite site = s.site();
  site.water = {{.outer = {{-40, -40}, {30, -40}, {30, 40}, {-40, 40}}, .holes = {}}};
  s.records[0].violations = plan_violations(s.routes[0], {.turn_radius_m = 20.0}, site.water);
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
  ReportSample s;
  PlanRecord& record = s.records[0];
  record.choices = {{.length_ratio = 1.5, .cover_pct = 95.0, .what = "few"},
                    {.length_ratio = 2.0, .cover_pct = 99.0, .what = "many"}};
  record.chosen = 1;
  record.chosen_why = "the most coverage";
  const json data = data_of(report_html(s.site(), s.plans()));
  const json& choices = data["plans"][0]["choices"];
  ASSERT_EQ(choices["list"].size(), 2U);
  EXPECT_EQ(choices["list"][1]["coverage_pct"], 99.0);
  EXPECT_EQ(choices["chosen"], 1);
  EXPECT_EQ(choices["why"], "the most coverage");
  EXPECT_EQ(choices["cover"], "hit");
  EXPECT_TRUE(data["plans"][1]["choices"]["list"].empty());
  for (Outcome& o : record.choices) o.cover = Cover::footprint;
  EXPECT_EQ(data_of(report_html(s.site(), s.plans()))["plans"][0]["choices"]["cover"], "footprint");
}

TEST(Report, OpensWithTheVerdictOfTheCriterion) {
  const ReportSample s;
  const JudgedSurvey judged = test::judged_survey();
  std::vector<ReportPlan> plans = s.plans();
  EXPECT_TRUE(data_of(report_html(s.site(), plans))["plans"][0]["criterion"].is_null());
  plans[0].judged = &judged;
  const std::string page = report_html(s.site(), plans);
  const json criterion = data_of(page)["plans"][0]["criterion"];
  EXPECT_EQ(criterion["predicted_to_pass"], false);
  EXPECT_EQ(criterion["rules"].size(), 2U);
  EXPECT_EQ(criterion["tvu"]["columns"], 3);
  const std::string says = "predicted to fail IHO S-44 Special Order by coverage.";
  EXPECT_THAT(data_of(page)["plans"][0]["verdict"].get<std::string>(), HasSubstr(says));
  EXPECT_LT(page.find("id=\"h-verdict\""), page.find("id=\"h-map\""));
}

TEST(Report, NeedsAPlan) {
  const ReportSample s;
  EXPECT_THROW((void)report_html(s.site(), {}), InvalidInput);
}

}  // namespace
}  // namespace swathplan
