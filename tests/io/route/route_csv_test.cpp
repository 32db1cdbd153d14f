#include "io/route/route_csv.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "io/files/atomic_file.h"
#include "io/sample_plan.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

using testing::HasSubstr;

Route zigzag() {
  Route route = test::parallel_lines({.min = Vec2(-40.0, -40.0), .max = Vec2(40.0, 40.0)}, 12.3);
  route.waypoints[1].fan.reset();
  route.waypoints[2].fan =
      FanAngles{.port = Angle::degrees(12.345678), .starboard = Angle::degrees(61.5)};
  route.waypoints[2].position += Vec2(0.123456, -0.654321);
  route.waypoints[3].speed_mps = 1.75;
  route.waypoints[5].feasible = false;
  return route;
}

Frame csv_frame() { return {.origin = Vec2(100.0, 200.0), .metres_per_unit = 1.0, .crs_wkt = ""}; }

void expect_same(const Route& a, const Route& b, double tolerance_m) {
  ASSERT_EQ(a.waypoints.size(), b.waypoints.size());
  for (std::size_t i = 0; i < a.waypoints.size(); ++i) {
    const Waypoint &p = a.waypoints[i], &q = b.waypoints[i];
    EXPECT_LT((p.position - q.position).norm(), tolerance_m) << i;
    EXPECT_EQ(p.kind, q.kind) << i;
    EXPECT_EQ(p.log, q.log) << i;
    EXPECT_EQ(p.line, q.line) << i;
    EXPECT_EQ(p.region, q.region) << i;
    EXPECT_EQ(p.feasible, q.feasible) << i;
    EXPECT_EQ(p.speed_mps, q.speed_mps) << i;
    ASSERT_EQ(p.fan.has_value(), q.fan.has_value()) << i;
    if (!p.fan) continue;
    EXPECT_NEAR(p.fan->port.deg(), q.fan->port.deg(), 1e-6) << i;
    EXPECT_NEAR(p.fan->starboard.deg(), q.fan->starboard.deg(), 1e-6) << i;
  }
}

std::string csv_refusal(const std::string& text, const Frame& frame = csv_frame(),
                        const RouteDefaults& defaults = {}) {
  try {
    (void)parse_route_csv(text, "lines.csv", frame, defaults);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "accepted";
}

const std::string kCsvHead = "x_m,y_m,port_deg,stbd_deg\n";

TEST(RouteCsv, ComesBackAsItWasWritten) {
  for (const Frame& frame : {csv_frame(), test::utm_frame()}) {
    const Route route = zigzag();
    const ImportedRoute back = parse_route_csv(route_csv(route, frame), "r.csv", frame, {});
    expect_same(route, back.route, 2e-6);
    EXPECT_TRUE(back.notes.empty());
  }
}

TEST(RouteCsv, HoldsTheColumnsOfTheContractInFileCoordinates) {
  Route route;
  route.waypoints.push_back({.position = Vec2(0.5, -0.25),
                             .kind = LegKind::run_in,
                             .log = false,
                             .line = 3,
                             .fan = FanAngles{Angle::degrees(45.0), Angle::degrees(50.5)},
                             .speed_mps = 1.5,
                             .region = 2,
                             .feasible = false});
  route.waypoints.push_back({.position = Vec2(10.0, 0.0),
                             .kind = LegKind::end,
                             .line = std::nullopt,
                             .fan = std::nullopt,
                             .region = std::nullopt});
  EXPECT_EQ(
      route_csv(route, csv_frame()),
      "seq,line,kind,log,x_m,y_m,lon_deg,lat_deg,port_deg,stbd_deg,speed_mps,region,status\r\n"
      "0,3,run_in,0,100.5,199.75,,,45,50.5,1.5,2,infeasible\r\n"
      "1,,end,1,110,200,,,,,2,,\r\n");
}

TEST(RouteCsv, GivesLongitudeAndLatitudeWhereTheInputHasACrs) {
  const Frame frame = test::utm_frame();
  const std::string text = route_csv(zigzag(), frame);
  // The same positions, given by longitude and latitude alone, lie where x and y put them.
  std::string only = text;
  only.replace(only.find("x_m,y_m"), 7, "a,b");
  const ImportedRoute back = parse_route_csv(only, "r.csv", frame, {});
  expect_same(zigzag(), back.route, 2e-4);
}

TEST(RouteCsv, ReadsForeignColumnsSeparatorsQuotesAndByteOrderMarks) {
  const RouteDefaults defaults{.fan = FanAngles{Angle::degrees(60.0), Angle::degrees(55.0)},
                               .speed_mps = 3.0};
  const std::string text =
      "\xEF\xBB\xBF\"Easting\";Northing;remark\r\n"
      "100;200;\"two\r\nlines; and \"\"quotes\"\"\"\r\n\r\n+150.5;200;\r\n";
  const ImportedRoute back = parse_route_csv(text, "r.csv", csv_frame(), defaults);
  ASSERT_EQ(back.route.waypoints.size(), 2U);
  EXPECT_EQ(back.route.waypoints[1].position, Vec2(50.5, 0.0));
  EXPECT_EQ(back.route.waypoints[0].kind, LegKind::line);
  EXPECT_EQ(back.route.waypoints[1].kind, LegKind::end);
  EXPECT_EQ(back.route.waypoints[0].fan, defaults.fan);
  EXPECT_EQ(back.route.waypoints[0].speed_mps, 3.0);
  EXPECT_THAT(back.fan_note.value_or(""), HasSubstr("names no fan: 60 degrees to port"));
}

TEST(RouteCsv, ReadsTheDecimalCommasOfSpreadsheets) {
  const auto read =
      parse_route_csv("x_m;y_m;port_deg;stbd_deg\n101,5;202,25;45,5;45,5\n103;204;45;45\n",
                      "lines.csv", csv_frame(), {});
  EXPECT_EQ(csv_frame().to_file(read.route.waypoints[0].position), Vec2(101.5, 202.25));
  EXPECT_NEAR(read.route.waypoints[0].fan->port.deg(), 45.5, 1e-9);
  EXPECT_THAT(csv_refusal("x_m;y_m;port_deg;stbd_deg\n1.234,5;2;45;45\n3;4;45;45\n"),
              HasSubstr("is not a finite number"));
}

TEST(RouteCsv, TakesRoutesWithoutAStatusAndWithAnotherOne) {
  const auto feasible = [](const std::string& text) {
    return parse_route_csv(text, "r.csv", csv_frame(), {}).route.waypoints[0].feasible;
  };
  EXPECT_TRUE(feasible(kCsvHead + "0,0,40,40\n9,0,40,40\n"));
  const std::string head = "x_m,y_m,port_deg,stbd_deg,status\n";
  EXPECT_TRUE(feasible(head + "0,0,40,40,surveyed\n9,0,40,40,\n"));
  EXPECT_FALSE(feasible(head + "0,0,40,40,Infeasible\n9,0,40,40,\n"));
}

TEST(RouteCsv, ReadsFeetAsTheFrameSays) {
  Frame feet = csv_frame();
  feet.metres_per_unit = 0.3048;
  const ImportedRoute back = parse_route_csv(
      "x_ft,y_ft,port_deg,stbd_deg\n100,200,45,45\n200,200,45,45\n", "r.csv", feet, {});
  EXPECT_NEAR(length_m(back.route), 30.48, 1e-12);
  const std::string again = route_csv(back.route, feet);
  EXPECT_THAT(again, HasSubstr("line,1,100,200,"));
  EXPECT_THAT(again, HasSubstr("end,1,200,200,"));
}

TEST(RouteCsv, TakesAnEmptyFanForASonarThatIsOff) {
  const ImportedRoute back = parse_route_csv(
      kCsvHead + "0,0,,\n1,0,45,45\n2,0,,\n", "r.csv", csv_frame(),
      {.fan = FanAngles{Angle::degrees(10.0), Angle::degrees(10.0)}, .speed_mps = 2.0});
  EXPECT_FALSE(back.route.waypoints[0].fan.has_value());
  EXPECT_TRUE(back.route.waypoints[1].fan.has_value());
}

TEST(RouteCsv, RefusesWhatIsNoRoute) {
  EXPECT_THAT(csv_refusal("hello world\n"), HasSubstr("'lines.csv' is not a route"));
  EXPECT_THAT(csv_refusal("1,2\n3,4\n"),
              HasSubstr("must name the columns x_m,y_m or lon_deg,lat_deg"));
  EXPECT_THAT(csv_refusal("x_m,port_deg\n1,2\n"), HasSubstr("is not a route"));
  EXPECT_THAT(csv_refusal(kCsvHead), HasSubstr("has 0 waypoints: a route needs at least two"));
  EXPECT_THAT(csv_refusal(kCsvHead + "1,2,45,45\n"),
              HasSubstr("has 1 waypoint: a route needs at least two"));
  EXPECT_THAT(csv_refusal("x,y\n1,2\n3,4\n"), HasSubstr("give the opening angle"));
  EXPECT_THAT(csv_refusal("lon,lat,port_deg,stbd_deg\n14,55,45,45\n14.1,55,45,45\n"),
              HasSubstr("the seafloor has no CRS"));
  EXPECT_THAT(csv_refusal("x,y,port_deg\n1,2,45\n3,4,45\n"), HasSubstr("only one of the columns"));
}

TEST(RouteCsv, NamesTheRowThatIsWrong) {
  const std::string good = "1,2,45,45\n";
  EXPECT_THAT(csv_refusal(kCsvHead + good + "nan,2,45,45\n"),
              HasSubstr("line 3: x_m 'nan' is not a finite number"));
  EXPECT_THAT(csv_refusal(kCsvHead + good + "1e999,2,45,45\n"),
              HasSubstr("is not a finite number"));
  EXPECT_THAT(csv_refusal(kCsvHead + good + "1 2,2,45,45\n"), HasSubstr("is not a finite number"));
  EXPECT_THAT(csv_refusal(kCsvHead + good + "1,2,45\n"), HasSubstr("line 3: has 3 fields"));
  EXPECT_THAT(csv_refusal(kCsvHead + good + "1,2,90,45\n"),
              HasSubstr("line 3: port_deg '90' must lie between 0 and 90"));
  EXPECT_THAT(csv_refusal(kCsvHead + good + "1,2,45,0\n"), HasSubstr("stbd_deg '0' must lie"));
  EXPECT_THAT(csv_refusal(kCsvHead + good + "1,2,45,\n"),
              HasSubstr("give both half-angles, or neither"));
  const std::string kinds = "seq,kind,log,line,speed_mps," + kCsvHead;
  EXPECT_THAT(csv_refusal(kinds + "0,spiral,1,1,2,1,2,45,45\n1,end,1,1,2,3,2,45,45\n"),
              HasSubstr("line 2: kind 'spiral' is none of line, turn"));
  EXPECT_THAT(csv_refusal(kinds + "0,end,1,1,2,1,2,45,45\n1,end,1,1,2,3,2,45,45\n"),
              HasSubstr("line 2: kind 'end' may stand in the last row only"));
  EXPECT_THAT(csv_refusal(kinds + "0,line,2,1,2,1,2,45,45\n1,end,1,1,2,3,2,45,45\n"),
              HasSubstr("log '2' must be 0 or 1"));
  EXPECT_THAT(csv_refusal(kinds + "0,line,1,1.5,2,1,2,45,45\n1,end,1,1,2,3,2,45,45\n"),
              HasSubstr("line '1.5' is not a whole number"));
  EXPECT_THAT(csv_refusal(kinds + "0,line,1,1,0,1,2,45,45\n1,end,1,1,2,3,2,45,45\n"),
              HasSubstr("speed_mps '0' must be greater than 0"));
  EXPECT_THAT(csv_refusal(kinds + "5,line,1,1,2,1,2,45,45\n5,end,1,1,2,3,2,45,45\n"),
              HasSubstr("line 3: seq '5' does not follow the row before"));
}

TEST(RouteCsv, RefusesDegreesOutOfRange) {
  const std::string head = "lon_deg,lat_deg,port_deg,stbd_deg\n";
  EXPECT_THAT(csv_refusal(head + "485000,6105000,45,45\n485100,6105000,45,45\n", test::utm_frame()),
              HasSubstr("line 2: lon_deg '485000' is no longitude"));
}

TEST(RouteCsv, WritesNothingForARouteThatIsNotValid) {
  const std::filesystem::path path =
      std::filesystem::path(testing::TempDir()) / "swathplan_invalid_route.csv";
  Route route = zigzag();
  route.waypoints.resize(1);
  EXPECT_THROW(write_route_csv(path, route, csv_frame()), InvalidInput);
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(ReadRoute, TellsTheFormatByTheContentAndNamesTheFile) {
  const std::filesystem::path path =
      std::filesystem::path(testing::TempDir()) / "swathplan_route.geojson";
  write_route_csv(path, zigzag(), csv_frame());
  expect_same(zigzag(), read_route(path, csv_frame(), {}).route, 2e-6);
  write_text_atomically(path, "  \n");
  const auto read = [&] { return read_route(path, csv_frame(), {}); };
  EXPECT_THAT(read, testing::ThrowsMessage<InvalidInput>(HasSubstr("route.geojson' is empty")));
  write_text_atomically(path, std::string("x_m\0y_m", 7));
  EXPECT_THAT(read, testing::ThrowsMessage<InvalidInput>(HasSubstr("is not a text file")));
  std::filesystem::remove(path);
  EXPECT_THAT(read, testing::ThrowsMessage<InvalidInput>(HasSubstr("cannot read")));
}

TEST(RouteCsv, FeetNeverStandInAColumnOfMetres) {
  Frame feet;
  feet.metres_per_unit = 0.3048;
  Route route;
  route.waypoints.resize(2);
  route.waypoints[1].position = {30.48, 0.0};
  route.waypoints[1].kind = LegKind::end;
  const std::string text = route_csv(route, feet);
  EXPECT_THAT(text, HasSubstr(",log,x_ft,y_ft,lon_deg,"));
  EXPECT_THAT(text, HasSubstr(",100,0,"));
  EXPECT_EQ(route_csv_unit_m(text), 0.3048);
  EXPECT_EQ(route_csv_unit_m("x_m,y_m\n0,0\n"), 1.0);
  const Route back = parse_route_csv(text, "route.csv", feet, {}).route;
  EXPECT_NEAR(back.waypoints[1].position.x(), 30.48, 1e-9);
  // Without a unit it is a coordinate of the file; with another one it is refused.
  EXPECT_NEAR(parse_route_csv("x,y\n0,0\n100,0\n", "r.csv", feet,
                              {.fan = FanAngles{Angle::degrees(45.0), Angle::degrees(45.0)}})
                  .route.waypoints[1]
                  .position.x(),
              30.48, 1e-9);
  for (const auto& [name, frame] : {std::pair{"x_m,y_m", feet}, std::pair{"x_ft,y_ft", Frame{}}}) {
    try {
      (void)parse_route_csv(std::string(name) + "\n0,0\n100,0\n", "r.csv", frame, {});
      FAIL() << name;
    } catch (const InvalidInput& e) {
      EXPECT_THAT(e.what(), HasSubstr("does not fit the coordinates"));
    }
  }
}

}  // namespace
}  // namespace swathplan
