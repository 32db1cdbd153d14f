#include "io/route/foreign_route.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "io/files/lonlat.h"
#include "io/sample_plan.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

using testing::Contains;
using testing::HasSubstr;

const RouteDefaults kSixty{.fan = FanAngles{Angle::degrees(60.0), Angle::degrees(60.0)},
                           .speed_mps = 2.0};

ImportedRoute read(const std::string& text, const Frame& frame = test::utm_frame()) {
  return parse_route(text, "route", frame, kSixty);
}

/// The places of a route as longitude and latitude, rounded to 1e-7 degree.
std::vector<std::pair<double, double>> lonlat(const ImportedRoute& imported) {
  std::vector<std::pair<double, double>> places;
  const LonLat degrees(test::utm_frame());
  for (const Vec2& p : degrees.from_local(positions(imported.route.waypoints))) {
    places.emplace_back(std::round(p.x() * 1e7) / 1e7, std::round(p.y() * 1e7) / 1e7);
  }
  return places;
}

const std::vector<std::pair<double, double>> kCorner{{-3.01, 48.0}, {-3.0, 48.0}, {-3.0, 48.01}};

std::string said(const std::string& text, const Frame& frame = test::utm_frame()) {
  try {
    static_cast<void>(read(text, frame));
  } catch (const InvalidInput& e) {
    return e.what();
  }
  return "nothing";
}

const std::string kHome = "QGC WPL 110\n0\t1\t0\t16\t0\t0\t0\t0\t47\t-4\t0\t1\n";
std::string row(int index, const std::string& rest) {
  return std::to_string(index) + "\t0\t3\t" + rest + "\t1\n";
}

TEST(ForeignRoute, AMissionWithSpeedsAndOtherCommands) {
  const auto route =
      read(kHome + row(1, "178\t1\t1.5\t-1\t0\t0\t0\t0") + row(2, "16\t0\t0\t0\t0\t48\t-3.01\t0") +
           row(3, "206\t5\t0\t0\t0\t0\t0\t0") + row(4, "16\t0\t0\t0\t0\t48\t-3\t0") +
           row(5, "178\t1\t3\t-1\t0\t0\t0\t0") + row(6, "82\t0\t0\t0\t0\t48.01\t-3\t0") +
           row(7, "20\t0\t0\t0\t0\t0\t0\t0"));
  EXPECT_EQ(lonlat(route), kCorner) << "home is no part of it";
  EXPECT_EQ(route.route.waypoints[0].speed_mps, 1.5);
  EXPECT_EQ(route.route.waypoints[1].speed_mps, 3.0)
      << "set before the place that the leg leads to";
  EXPECT_THAT(route.notes, Contains(HasSubstr("20 (1x), 206 (1x)")));
}

TEST(ForeignRoute, AMissionThatIsNoneSaysWhy) {
  const std::string place = row(1, "16\t0\t0\t0\t0\t48\t-3.01\t0");
  EXPECT_THAT(said(kHome + place), HasSubstr("one waypoint beside home"));
  EXPECT_THAT(said(kHome), HasSubstr("no waypoints"));
  EXPECT_THAT(said("QGC WPL 120\n"), HasSubstr("another version"));
  EXPECT_THAT(said(kHome + place + "2\t0\t3\t16\t0\t0"), HasSubstr("line 4: has 6 columns"));
  EXPECT_THAT(said(kHome + place + "2\t0\t1\t16\t0\t0\t0\t0\t5\t7\t0\t1\n"), HasSubstr("frame 1"));
  EXPECT_THAT(said(kHome + place + row(2, "177\t1\t3\t0\t0\t0\t0\t0")), HasSubstr("loop"));
  EXPECT_THAT(said(kHome + place + row(2, "16\t0\t0\t0\t0\tx\t7\t0")),
              HasSubstr("'x' is no number"));
  EXPECT_THAT(said(kHome + place + row(2, "16\t0\t0\t0\t0\t480\t7\t0")), HasSubstr("not degrees"));
  EXPECT_THAT(said(kHome + place + place, Frame{}), HasSubstr("<CRS>"));
}

TEST(ForeignRoute, APlanOfQGroundControl) {
  const auto item = [](const std::string& place) {
    return R"({"type":"SimpleItem","command":16,"frame":3,"params":[0,0,0,null,)" + place + ",0]}";
  };
  const auto plan = [](const std::string& items) {
    return R"({"fileType":"Plan","version":1,"mission":{"version":2,"items":[)" + items + "]}}";
  };
  const std::string first = item("48,-3.01");
  const std::string others = item("48,-3") + "," + item("48.01,-3");
  EXPECT_EQ(lonlat(read(plan(first + "," + others))), kCorner);
  const std::string survey = R"({"type":"ComplexItem","complexItemType":"survey",)"
                             R"("TransectStyleComplexItem":{"Items":[)";
  EXPECT_EQ(lonlat(read(plan(first + "," + survey + others + "]}}"))), kCorner);
  const std::string old =
      R"({"type":"SimpleItem","command":16,"frame":3,"coordinate":[48,-3.01,0]})";
  EXPECT_EQ(lonlat(read(plan(old + "," + others))), kCorner);
  EXPECT_THAT(said(plan(survey + "]}}")), HasSubstr("an area but none of its lines"));
  EXPECT_THAT(said(plan(first)), HasSubstr("one waypoint: a route needs at least two"));
  EXPECT_THAT(said(R"({"fileType":"Plan","mission":3})"), HasSubstr("without mission items"));
}

TEST(ForeignRoute, GpxOfChartPlotters) {
  const std::string head = "<?xml version=\"1.0\"?><gpx version=\"1.1\">";
  const auto point = [](const std::string& kind, const char* lat, const char* lon,
                        const std::string& more = "") {
    return "<" + kind + " lat=\"" + lat + "\" lon=\"" + lon + "\">" + more + "</" + kind + ">";
  };
  const auto three = [&](const std::string& kind) {
    return point(kind, "48", "-3.01") + point(kind, "48", "-3") + point(kind, "48.01", "-3");
  };
  const auto track = "<trk><trkseg>" + three("trkpt") + "</trkseg></trk>";
  EXPECT_EQ(lonlat(read(head + "<rte>" + three("rtept") + "</rte></gpx>")), kCorner);
  EXPECT_EQ(lonlat(read(head + track + "</gpx>")), kCorner);
  EXPECT_EQ(lonlat(read(head + three("wpt") + "</gpx>")), kCorner);
  const auto both =
      read(head + "<wpt lat=\"0\" lon=\"0\"/><rte>" + three("rtept") + "</rte>" + track + "</gpx>");
  EXPECT_EQ(lonlat(both), kCorner) << "the route counts";
  EXPECT_THAT(both.notes, Contains(HasSubstr("1 tracks beside the routes")));
  const auto two =
      read(head + "<rte>" + point("rtept", "48", "-3.01", "<type>transit</type>") +
           point("rtept", "48", "-3.005") + "</rte><rte>" + point("rtept", "48", "-3") +
           point("rtept", "48.01", "-3") + "</rte></gpx>");
  EXPECT_EQ(two.route.waypoints.size(), 4U);
  EXPECT_EQ(two.route.waypoints[0].kind, LegKind::transit);
  EXPECT_FALSE(two.route.waypoints[0].log) << "no line";
  EXPECT_EQ(two.route.waypoints[1].kind, LegKind::transit) << "from one route to the next";
  EXPECT_FALSE(two.route.waypoints[1].fan.has_value());
  EXPECT_THAT(said(head + "<rte>" + point("rtept", "48", "-3") + "</rte></gpx>"),
              HasSubstr("one waypoint"));
  EXPECT_THAT(said(head + "<rte>" + point("rtept", "N48", "-3") + "</rte></gpx>"),
              HasSubstr("'N48'"));
  EXPECT_THAT(said(head), HasSubstr("not complete XML"));
  EXPECT_THAT(said("<html></html>"), HasSubstr("XML of the kind 'html'"));
}

TEST(ForeignRoute, KmlOfMapViewers) {
  const auto kml = [](const std::string& inside) {
    return "<kml xmlns:gx=\"g\"><Document>" + inside + "</Document></kml>";
  };
  const auto line = [](const std::string& places) {
    return "<Placemark><LineString><coordinates>" + places +
           "</coordinates></LineString></Placemark>";
  };
  EXPECT_EQ(lonlat(read(kml(line("\n -3.01,48,0 -3,48,0\n-3,48.01,0\n")))), kCorner);
  EXPECT_EQ(lonlat(read(kml("<Placemark><gx:Track><gx:coord>-3.01 48 0</gx:coord><gx:coord>-3 48 "
                            "0</gx:coord><gx:coord>-3 48.01 0</gx:coord></gx:Track></Placemark>"))),
            kCorner);
  const auto mark = [](const std::string& place) {
    return "<Placemark><Point><coordinates>" + place + "</coordinates></Point></Placemark>";
  };
  EXPECT_EQ(lonlat(read(kml(mark("-3.01,48") + mark("-3,48") + mark("-3,48.01")))), kCorner);
  const auto more = read(kml(line("-3.01,48 -3,48 -3,48.01") + mark("5,5") +
                             "<Placemark><Polygon/></Placemark><NetworkLink/>"));
  EXPECT_EQ(lonlat(more), kCorner);
  EXPECT_THAT(more.notes, Contains(HasSubstr("1 places")));
  EXPECT_THAT(more.notes, Contains(HasSubstr("1 polygons")));
  EXPECT_THAT(more.notes, Contains(HasSubstr("1 links")));
  EXPECT_THAT(said(kml(line("-3.01;48 -3;48"))), HasSubstr("'-3.01;48'"));
  EXPECT_THAT(said(kml("")), HasSubstr("no waypoints"));
}

TEST(ForeignRoute, RtzOfChartSystems) {
  const auto rtz = [](const std::string& inside) {
    return "<route xmlns=\"http://www.cirm.org/RTZ/1/1\" version=\"1.1\"><routeInfo "
           "routeName=\"r\"/><waypoints><defaultWaypoint radius=\"0.5\"/>" +
           inside + "</waypoints></route>";
  };
  const auto route = read(rtz(
      "<waypoint id=\"1\"><position lat=\"48\" lon=\"-3.01\"/></waypoint>"
      "<waypoint id=\"2\" radius=\"0.1\"><position lat=\"48\" lon=\"-3\"/><leg speedMax=\"10\" "
      "geometryType=\"Orthodrome\"/></waypoint>"
      "<waypoint id=\"3\"><position lat=\"48.01\" lon=\"-3\"/><leg speedMax=\"5\"/></waypoint>"));
  EXPECT_EQ(lonlat(route), kCorner);
  EXPECT_NEAR(route.route.waypoints[0].speed_mps, 10.0 * 1852 / 3600, 1e-9);
  EXPECT_NEAR(route.route.waypoints[1].speed_mps, 5.0 * 1852 / 3600, 1e-9);
  EXPECT_THAT(route.notes, Contains(HasSubstr("1 turn radii")));
  EXPECT_THAT(route.notes, Contains(HasSubstr("1 great-circle legs")));
  EXPECT_THAT(said(rtz("<waypoint id=\"1\"/>")), HasSubstr("waypoint 1: has no position"));
}

TEST(ForeignRoute, PlannedLinesOfHypack) {
  const std::string text =
      "LNW 1.0\r\nLNS 2\r\nLIN 2\r\nPTS 500030.00 5300000.00\r\nPTS 500360.00 5300000.00\r\n"
      "LNN 7\r\nEOL\r\nLIN 2\r\nPTS 500360 5300020 3\r\nPTS 500030 5300020 3\r\nLBP 1 2\r\n"
      "LNN 8_2\r\nEOL\r\n";
  const Frame frame{.origin = Vec2(500000, 5300000), .metres_per_unit = 1.0, .crs_wkt = ""};
  const auto route = read(text, frame);
  ASSERT_EQ(route.route.waypoints.size(), 4U);
  EXPECT_EQ(route.route.waypoints[0].position, Vec2(30, 0));
  EXPECT_EQ(route.route.waypoints[3].position, Vec2(30, 20));
  EXPECT_EQ(route.route.waypoints[0].line, 7);
  EXPECT_EQ(route.route.waypoints[1].kind, LegKind::transit);
  EXPECT_EQ(route.route.waypoints[2].line, 8);
  EXPECT_THAT(route.notes, Contains(HasSubstr("'LBP' was left out")));
  EXPECT_THAT(route.notes, Contains(HasSubstr("name no coordinate reference system")));
  EXPECT_THAT(said("LNS 1\nLIN 2\nPTS 1 2\nEOL\n"), HasSubstr("holds 1 points where LIN says 2"));
  EXPECT_THAT(said("LNS 2\nLIN 2\nPTS 1 2\nPTS 3 4\nEOL\n"), HasSubstr("holds 1 lines where LNS"));
  EXPECT_THAT(said("LNS 1\nPTS 1 2\n"), HasSubstr("line 2: PTS outside a line"));
  EXPECT_THAT(said("LNS 1\nLIN 1\nPTS 1 N\n"), HasSubstr("line 3: PTS must be followed"));
}

TEST(ForeignRoute, DrawingsWithLines) {
  const auto drawing = [](const std::string& entities) {
    return "0\nSECTION\n2\nENTITIES\n" + entities + "0\nENDSEC\n0\nEOF\n";
  };
  const std::string line = "0\nLINE\n8\nLINES\n10\n0\n20\n5\n11\n40\n21\n5\n";
  const std::string turn = "0\nLWPOLYLINE\n8\nturn\n90\n2\n70\n0\n10\n40\n20\n5\n10\n40\n20\n25\n";
  const std::string dot = "0\nPOINT\n8\n0\n10\n1\n20\n1\n";
  const auto route = read(drawing(line + turn + dot), Frame{});
  ASSERT_EQ(route.route.waypoints.size(), 3U);
  EXPECT_EQ(route.route.waypoints[0].position, Vec2(0, 5));
  EXPECT_EQ(route.route.waypoints[1].kind, LegKind::turn);
  EXPECT_EQ(route.route.waypoints[2].position, Vec2(40, 25));
  EXPECT_THAT(route.notes, Contains(HasSubstr("1 drawn things that are no lines")));
  EXPECT_THAT(said(drawing(dot), Frame{}), HasSubstr("holds no line"));
  EXPECT_THAT(said("0\nSECTION\n2\nENTITIES\n0\nLINE\n", Frame{}), HasSubstr("'route'"));
}

}  // namespace
}  // namespace swathplan
