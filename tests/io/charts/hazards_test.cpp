#include "io/charts/hazards.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "chart_files.h"
#include "io/charts/hazards_geojson.h"
#include "io/files/crs.h"
#include "io/import_files.h"

namespace swathplan {
namespace {

using test::ChartFeature;
using test::small_chart;
using test::write_chart;
using testing::Contains;
using testing::HasSubstr;

class ChartHazards : public ImportFiles {
 protected:
  [[nodiscard]] Hazards read(const std::filesystem::path& file,
                             const std::vector<HazardChoice>& choices = {{}}) const {
    return read_hazards(file, choices, frame, near);
  }
  Frame frame{
      .origin = {500000, 4000000}, .metres_per_unit = 1.0, .crs_wkt = parse_crs("EPSG:32633")};
  Box2 near{{0, 0}, {1200, 600}};
};

TEST_F(ChartHazards, HaveBuffersByTheirAccuracy) {
  const Hazards all = read(write_chart(path("c.gpkg"), small_chart(), 32633));
  ASSERT_EQ(all.list.size(), 4U);
  EXPECT_EQ(all.list[0].layer, "LNDARE");
  EXPECT_EQ(all.list[0].name, "The Island");
  EXPECT_DOUBLE_EQ(all.list[0].buffer_m, 60.0);  // 10 m and 50 m, for nothing is stated
  const Hazard& approximate = all.list[2];
  EXPECT_DOUBLE_EQ(approximate.buffer_m, 70.0);  // no scale is stated: 50 m, more than QUAPOS 4
  EXPECT_TRUE(approximate.to_be_seen);
  const Hazard& measured = all.list[3];
  EXPECT_EQ(measured.accuracy_from, "POSACC");
  EXPECT_DOUBLE_EQ(measured.buffer_m, 25.0);
  for (int i = 0; i < 360; ++i) {
    const double angle = Angle::degrees(i).rad();
    const Vec2 rim = Vec2(300, 300) + 25.0 * Vec2(std::cos(angle), std::sin(angle));
    EXPECT_TRUE(contains(measured.area, rim)) << i;
  }
  EXPECT_LT(area_m2(measured.area), 1.02 * 3.1416 * 25.0 * 25.0);
}

TEST_F(ChartHazards, WhatLiesInAZoneOfPoorQualityHasMoreRoom) {
  test::ChartLayers layers = small_chart();
  layers["M_QUAL"] = {{{{"CATZOC", "4"}},
                       "POLYGON((501000 4000000,501200 4000000,501200 4000600,501000 "
                       "4000600,501000 4000000))"}};
  const Hazards all = read(write_chart(path("c.gpkg"), layers, 32633));
  EXPECT_EQ(all.list[2].accuracy_from, "CATZOC C");
  EXPECT_DOUBLE_EQ(all.list[2].buffer_m, 520.0);
  EXPECT_DOUBLE_EQ(all.list[3].buffer_m, 25.0);
}

TEST_F(ChartHazards, ChoicesOverrideAndTurnOff) {
  const auto file = write_chart(path("c.gpkg"), small_chart(), 32633);
  const Hazards wide = read(file, {{}, {{}, "WRECKS", 90.0, false}, {{}, "LNDARE", {}, true}});
  ASSERT_EQ(wide.list.size(), 2U);
  EXPECT_DOUBLE_EQ(wide.list[0].buffer_m, 90.0);
  EXPECT_EQ(wide.list[0].accuracy_from, "typed");
  const Hazards one = read(file, {{file, "wrecks", {}, false}});
  EXPECT_EQ(one.list.size(), 2U);
  EXPECT_THAT(refusal([&] {
                return read(file, {{file, "CABLES", 3.0, false}});
              }),
              HasSubstr("has no layer 'CABLES'"));
}

TEST_F(ChartHazards, OnlyThoseNearAreKept) {
  near = {{0, 0}, {400, 600}};
  const Hazards some = read(write_chart(path("c.gpkg"), small_chart(), 32633));
  ASSERT_EQ(some.list.size(), 2U);  // the land in the north and one wreck
  EXPECT_EQ(some.counts[1].layer, "WRECKS");
  EXPECT_EQ(some.counts[1].found, 2U);
  EXPECT_EQ(some.counts[1].near, 1U);
}

TEST_F(ChartHazards, AreasThatForbidOtherThingsThanEntryAreSailed) {
  const std::string square =
      "POLYGON((500100 4000100,500200 4000100,500200 4000200,500100 4000200,500100 4000100))";
  test::ChartLayers layers = small_chart();
  layers["RESARE"] = {{{{"RESTRN", "16"}}, square},
                      {{{"RESTRN", "4,8"}}, square},
                      {{{"CATREA", "12"}}, square},
                      {{{"CATREA", "4"}}, square},
                      {{}, square}};
  const Hazards all = read(write_chart(path("c.gpkg"), layers, 32633));
  EXPECT_THAT(all.notes, Contains(HasSubstr("2 restricted areas")));
  EXPECT_EQ(std::count_if(all.list.begin(), all.list.end(),
                          [](const Hazard& h) { return h.layer == "RESARE"; }),
            3);
  EXPECT_FALSE(contains(united_area(all, true), {150, 150}));
  EXPECT_TRUE(contains(united_area(all, false), {150, 150}));
}

TEST_F(ChartHazards, WithoutAPositionTheyAreSaidOrRefused) {
  test::ChartLayers layers = small_chart();
  layers["WRECKS"].push_back({{{"VALSOU", "2"}}, ""});
  EXPECT_THAT(
      read(write_chart(path("some.gpkg"), layers, 32633)).warnings,
      Contains(HasSubstr("1 of 3 hazards in layer WRECKS of 'some.gpkg' have no position")));
  layers["WRECKS"] = {{{{"VALSOU", "2"}}, ""}};
  const auto none = write_chart(path("none.gpkg"), layers, 32633);
  EXPECT_THAT(refusal([&] { return read(none); }),
              HasSubstr("none of the 1 hazards in layer WRECKS"));
}

TEST_F(ChartHazards, OtherFilesNeedABufferAndGoToTheFrame) {
  const auto file = write_chart(
      path("cables.gpkg"), {{"cables", {{{{"name", "A"}}, "LINESTRING(15 36.14,15.01 36.14)"}}}});
  EXPECT_THROW((void)read(file, {{file, "", {}, false}}), UsageError);
  frame.origin = {499000, 3999000};
  near = {{0, 0}, {3000, 3000}};
  const Hazards all = read(file, {{file, "", 15.0, false}});
  ASSERT_EQ(all.list.size(), 1U);
  EXPECT_EQ(all.list[0].name, "A");
  EXPECT_FALSE(all.list[0].to_be_seen);
  const CrsTransform to_frame(wgs84_crs(), frame.crs_wkt);
  EXPECT_TRUE(contains(all.list[0].area, frame.to_local(to_frame(Vec2(15.005, 36.14)))));
  frame.crs_wkt.clear();
  EXPECT_THAT(refusal([&] {
                return read(file, {{file, "", 15.0, false}});
              }),
              HasSubstr("no coordinate reference system"));
}

TEST_F(ChartHazards, GeoJsonHoldsThemWithTheirRoom) {
  const Hazards all = read(write_chart(path("c.gpkg"), small_chart(), 32633));
  const auto json = nlohmann::json::parse(hazards_geojson(all, frame));
  ASSERT_EQ(json["features"].size(), 4U);
  const auto& wreck = json["features"][3];
  EXPECT_EQ(wreck["properties"]["layer"], "WRECKS");
  EXPECT_EQ(wreck["properties"]["buffer_m"], 25);
  EXPECT_EQ(wreck["properties"]["to_be_seen"], true);
  EXPECT_EQ(wreck["geometry"]["type"], "MultiPolygon");
  const auto& place = wreck["geometry"]["coordinates"][0][0][0];
  EXPECT_NEAR(place[0].get<double>(), 15.003, 0.001);
}

}  // namespace
}  // namespace swathplan
