#include "io/results/holidays_geojson.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/sample_plan.h"
#include "temporary_folder.h"

namespace swathplan {
namespace {

Holidays two_of_five() {
  Holidays holidays;
  holidays.count = 5;
  holidays.total_m2 = 20.5;
  for (const double area : {12.0, 8.0}) {
    Box2 box;
    box.extend(Vec2(area, 0.0));
    box.extend(Vec2(area + 4.0, 3.0));
    holidays.list.push_back({.cells = 100,
                             .area_m2 = area,
                             .position = Vec2(area + 1.0, 2.0),
                             .box = box,
                             .cause = HolidayCause::edge});
  }
  return holidays;
}

TEST(HolidaysGeoJson, ListsBoxesInOrderAndCountsAllHolidays) {
  const Frame frame{.origin = Vec2(1000.0, 2000.0), .metres_per_unit = 1.0, .crs_wkt = ""};
  const auto read = nlohmann::json::parse(holidays_geojson(two_of_five(), frame));
  EXPECT_EQ(read.at("holidays"), 5);
  EXPECT_EQ(read.at("listed"), 2);
  EXPECT_EQ(read.at("holidays_total_m2"), 20.5);
  ASSERT_EQ(read.at("features").size(), 2U);
  const auto& first = read.at("features").at(0);
  EXPECT_EQ(first.at("properties").at("rank"), 1);
  EXPECT_EQ(first.at("properties").at("area_m2"), 12.0);
  EXPECT_EQ(first.at("properties").at("cause"), "edge");
  EXPECT_EQ(first.at("properties").at("x_m"), 1013.0);
  EXPECT_EQ(first.at("properties").at("y_m"), 2002.0);
  // The ring runs against the clock and ends where it begins (RFC 7946).
  EXPECT_EQ(first.at("geometry").at("coordinates").at(0),
            nlohmann::json::parse("[[1012,2000],[1016,2000],[1016,2003],[1012,2003],[1012,2000]]"));
}

TEST(HolidaysGeoJson, GivesTheTrueOutlineWhereThereIsOne) {
  Holidays holidays = two_of_five();
  holidays.list[0].outline = {{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{{3, 3}, {3, 6}, {6, 6}, {6, 3}}}};
  const auto local = nlohmann::json::parse(holidays_geojson(holidays, Frame{}));
  const auto& features = local.at("features");
  EXPECT_EQ(features.at(0).at("properties").at("outline"), "cells");
  EXPECT_EQ(features.at(0).at("geometry").at("coordinates"),
            nlohmann::json::parse("[[[0,0],[9,0],[9,9],[0,9],[0,0]],"
                                  "[[3,3],[3,6],[6,6],[6,3],[3,3]]]"));
  EXPECT_EQ(features.at(1).at("properties").at("outline"), "box");
  const auto world = nlohmann::json::parse(holidays_geojson(holidays, test::utm_frame()));
  EXPECT_EQ(world.at("features").at(0).at("geometry").at("coordinates").size(), 2U);
}

TEST(HolidaysGeoJson, DrawsABoxInTwoPartsWhereAGapCrosses180Degrees) {
  const Frame frame{.origin = Vec2(669'800.0, 6'600'000.0),  // zone 60N, at its eastern end
                    .metres_per_unit = 1.0,
                    .crs_wkt = parse_crs("EPSG:32660")};
  Holidays holidays = two_of_five();
  holidays.list.resize(1);
  holidays.list[0].box.extend(Vec2(-3e4, 0.0));
  holidays.list[0].box.extend(Vec2(3e4, 100.0));
  holidays.list[0].outline = {{{-3e4, 0}, {3e4, 0}, {3e4, 100}, {-3e4, 100}}, {}};
  const auto read = nlohmann::json::parse(holidays_geojson(holidays, frame));
  const auto& feature = read.at("features").at(0);
  EXPECT_EQ(feature.at("properties").at("outline"), "box");
  EXPECT_EQ(feature.at("geometry").at("type"), "MultiPolygon");
}

TEST(HolidaysGeoJson, TheNameOfTheFileSaysWhetherItIsInDegrees) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(write_holidays_geojson(folder.path(), {}, Frame{}).filename(),
            "holidays.local.geojson");
  const auto path = write_holidays_geojson(folder.path(), two_of_five(), test::utm_frame());
  EXPECT_EQ(path.filename(), "holidays.geojson");
  EXPECT_TRUE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace swathplan
