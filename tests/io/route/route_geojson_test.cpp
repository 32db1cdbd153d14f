#include "io/route/route_geojson.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "io/files/crs.h"
#include "io/results/holidays_geojson.h"
#include "io/sample_plan.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

using nlohmann::json;
using testing::HasSubstr;

const RouteDefaults kFan{.fan = FanAngles{Angle::degrees(60.0), Angle::degrees(60.0)},
                         .speed_mps = 2.0};

Frame geojson_frame() {
  return {.origin = Vec2(100.0, 200.0), .metres_per_unit = 1.0, .crs_wkt = ""};
}

/// Lines whose fan changes within a leg, and a leg with the sonar off.
Route changing() {
  Route route = test::parallel_lines({.min = Vec2(-40.0, -40.0), .max = Vec2(40.0, 40.0)}, 16.0);
  const Waypoint first = route.waypoints[0];
  for (int i = 1; i < 5; ++i) {
    Waypoint w = first;
    w.position.y() += i;
    w.fan = FanAngles{Angle::degrees(40.0 + i), Angle::degrees(40.0)};
    w.speed_mps = 2.0 + 0.1 * i;
    route.waypoints.insert(route.waypoints.begin() + i, w);
  }
  route.waypoints[5].fan.reset();
  route.waypoints[7].feasible = false;
  return route;
}

/// A route over 180 degrees, in UTM.
TEST(RouteGeojson, LegsAreCutAt180DegreesAndReadAsOneRoute) {
  Frame frame;
  frame.crs_wkt = utm_crs(179.99, 52.0);
  frame.origin = CrsTransform(wgs84_crs(), frame.crs_wkt)(Vec2(180.0, 52.0));
  const Route route = changing();
  const std::string text = route_geojson(route, frame);
  std::size_t parts = 0;
  const json written = json::parse(text);
  for (const json& feature : written.at("features")) {
    double low = 400.0, high = -400.0;
    for (const json& p : feature.at("geometry").at("coordinates")) {
      low = std::min(low, p.at(0).get<double>());
      high = std::max(high, p.at(0).get<double>());
    }
    EXPECT_LT(high - low, 1.0);
    ++parts;
  }
  EXPECT_GT(parts, legs(route).size());
  const ImportedRoute back = parse_route_geojson(text, "r.geojson", frame, {});
  EXPECT_TRUE(back.notes.empty());
  EXPECT_NEAR(length_m(back.route), length_m(route), 1e-3);
}

std::string geojson_refusal(const std::string& text, const Frame& frame = geojson_frame(),
                            const RouteDefaults& defaults = kFan) {
  try {
    (void)parse_route_geojson(text, "lines.geojson", frame, defaults);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "accepted";
}

TEST(RouteGeojson, ComesBackAsItWasWritten) {
  for (const Frame& frame : {geojson_frame(), test::utm_frame()}) {
    const Route route = changing();
    const ImportedRoute back =
        parse_route_geojson(route_geojson(route, frame), "r.geojson", frame, {});
    EXPECT_TRUE(back.notes.empty());
    ASSERT_EQ(back.route.waypoints.size(), route.waypoints.size());
    for (std::size_t i = 0; i < route.waypoints.size(); ++i) {
      const Waypoint &p = route.waypoints[i], &q = back.route.waypoints[i];
      EXPECT_EQ(p.feasible, q.feasible) << i;
      EXPECT_LT((p.position - q.position).norm(), 2e-4) << i;
      EXPECT_EQ(p.kind, q.kind) << i;
      if (p.kind == LegKind::end) continue;  // holds for nothing, so no feature tells of it
      EXPECT_EQ(p.log, q.log) << i;
      EXPECT_EQ(p.line, q.line) << i;
      EXPECT_EQ(p.region, q.region) << i;
      EXPECT_EQ(p.speed_mps, q.speed_mps) << i;
      ASSERT_EQ(p.fan.has_value(), q.fan.has_value()) << i;
      if (p.fan) {
        EXPECT_NEAR(p.fan->port.deg(), q.fan->port.deg(), 1e-6) << i;
      }
    }
  }
}

TEST(RouteGeojson, IsOneLineStringALegInLongitudeAndLatitude) {
  const Route route = changing();
  const json document = json::parse(route_geojson(route, test::utm_frame()));
  EXPECT_EQ(document["type"], "FeatureCollection");
  EXPECT_FALSE(document.contains("crs"));
  EXPECT_FALSE(document.contains("local_frame"));
  ASSERT_EQ(document["features"].size(), legs(route).size());
  for (const json& feature : document["features"]) {
    EXPECT_EQ(feature["geometry"]["type"], "LineString");
    for (const json& p : feature["geometry"]["coordinates"]) {
      EXPECT_NEAR(p[0].get<double>(), 14.77, 0.1);  // near Roenne
      EXPECT_NEAR(p[1].get<double>(), 55.1, 0.1);
    }
    for (const char* key :
         {"leg", "line", "kind", "log", "port_deg", "stbd_deg", "speed_mps", "region"}) {
      EXPECT_TRUE(feature["properties"].contains(key)) << key;
    }
  }
}

TEST(RouteGeojson, SaysThatMetresAreNotDegrees) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "swathplan_gj";
  const auto local = write_route_geojson(folder, changing(), geojson_frame());
  const auto global = write_route_geojson(folder, changing(), test::utm_frame());
  EXPECT_EQ(local.filename(), "route.local.geojson");
  EXPECT_EQ(global.filename(), "route.geojson");
  const json document = json::parse(route_geojson(changing(), geojson_frame()));
  EXPECT_THAT(document["local_frame"]["note"].get<std::string>(),
              HasSubstr("not longitude and latitude"));
  EXPECT_EQ(document["features"][0]["geometry"]["coordinates"][0], json::array({68.0, 160.0}));
  std::filesystem::remove_all(folder);
}

TEST(RouteGeojson, JoinsLinesThatDoNotMeetByTransitsWithTheSonarOff) {
  const std::string text =
      R"({"local_frame":{},"type":"FeatureCollection","features":[
        {"type":"Feature","properties":null,"geometry":{"type":"LineString","coordinates":[[100,200],[100,300]]}},
        {"type":"Feature","properties":{},"geometry":{"type":"Point","coordinates":[0,0]}},
        {"type":"Feature","properties":{"port_deg":30,"stbd_deg":40},"geometry":{"type":"MultiLineString",
         "coordinates":[[[110,300],[110,200]],[[110,200],[120,200]]]}}]})";
  const ImportedRoute back = parse_route_geojson(text, "r.geojson", geojson_frame(), kFan);
  const auto& w = back.route.waypoints;
  ASSERT_EQ(w.size(), 5U);
  EXPECT_EQ(w[0].fan, kFan.fan);
  EXPECT_EQ(w[1].kind, LegKind::transit);
  EXPECT_FALSE(w[1].log);
  EXPECT_FALSE(w[1].fan.has_value());
  EXPECT_EQ(w[1].position, Vec2(0.0, 100.0));
  EXPECT_NEAR(w[2].fan->starboard.deg(), 40.0, 1e-12);
  EXPECT_EQ(w[3].kind, LegKind::line);
  EXPECT_EQ(w[4].kind, LegKind::end);
  EXPECT_THAT(back.notes, testing::Contains(HasSubstr("1 gap between lines was joined")));
  EXPECT_THAT(back.fan_note.value_or(""), HasSubstr("60 degrees to port"));
  EXPECT_THAT(back.notes, testing::Contains(HasSubstr("1 geometries that are no lines")));
}

TEST(RouteGeojson, ReadsABareLineStringAndAStatedCrs) {
  const std::string bare = R"({"type":"LineString","coordinates":[[14.77,55.1],[14.771,55.1]]})";
  const ImportedRoute lonlat = parse_route_geojson(bare, "r.geojson", test::utm_frame(), kFan);
  EXPECT_NEAR(length_m(lonlat.route), 63.9, 0.5);
  const std::string utm =
      R"({"type":"LineString","crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::32633"}},
         "coordinates":[[485010,6105020],[485110,6105020]]})";
  const ImportedRoute other = parse_route_geojson(utm, "r.geojson", test::utm_frame(), kFan);
  EXPECT_LT((other.route.waypoints[0].position - Vec2(10.0, 20.0)).norm(), 1e-6);
}

TEST(RouteGeojson, RefusesCollectionsWithoutEnd) {
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += R"({"type":"GeometryCollection","geometries":[)";
  for (int i = 0; i < 100000; ++i) deep += "]}";
  EXPECT_THAT(geojson_refusal(deep), HasSubstr("levels deep"));
}

TEST(RouteGeojson, RefusesWhatIsNoRoute) {
  EXPECT_THAT(geojson_refusal(R"({"type":"LineString","coordinates":[[1,2],[3,)"),
              HasSubstr("truncated"));
  EXPECT_THAT(geojson_refusal(R"({"a":1})"), HasSubstr("it has no 'type'"));
  EXPECT_THAT(geojson_refusal(R"({"type":"FeatureCollection"})"),
              HasSubstr("'features' is missing"));
  EXPECT_THAT(geojson_refusal(R"({"type":"Point","coordinates":[1,2]})"),
              HasSubstr("holds neither a LineString nor two points"));
  EXPECT_THAT(geojson_refusal(R"({"type":"LineString","coordinates":[[1,2],[3,4]]})"),
              HasSubstr("the seafloor has no CRS"));
  EXPECT_THAT(
      geojson_refusal(R"({"type":"LineString","coordinates":[[485000,6105000],[485100,6105000]]})",
                      test::utm_frame()),
      HasSubstr("point 0 (485000, 6105000) is no longitude and latitude"));
  const std::string head = R"({"local_frame":{},"type":"Feature","properties":)";
  const std::string two = R"(,"geometry":{"type":"LineString","coordinates":[[1,2],[3,4]]}})";
  EXPECT_THAT(geojson_refusal(R"({"local_frame":{},"type":"LineString","coordinates":[[1,2]]})"),
              HasSubstr("at least two points"));
  EXPECT_THAT(
      geojson_refusal(R"({"local_frame":{},"type":"LineString","coordinates":[[1,2],[3,"x"]]})"),
      HasSubstr("point 1 is not a pair of numbers"));
  EXPECT_THAT(geojson_refusal(head + R"({"kind":"spiral"})" + two),
              HasSubstr("kind \"spiral\" is none of"));
  EXPECT_THAT(geojson_refusal(head + R"({"log":2})" + two), HasSubstr("log must be 0 or 1"));
  EXPECT_THAT(geojson_refusal(head + R"({"port_deg":30})" + two),
              HasSubstr("must both lie between 0 and 90"));
  EXPECT_THAT(geojson_refusal(head + R"({"port_deg":30,"stbd_deg":90})" + two),
              HasSubstr("must both lie"));
  EXPECT_THAT(geojson_refusal(head + R"({"speed_mps":0})" + two), HasSubstr("greater than 0"));
  EXPECT_THAT(geojson_refusal(head + "{}" + two, geojson_frame(), {}),
              HasSubstr("give the opening angle"));
  EXPECT_THAT(geojson_refusal(R"({"type":"LineString","crs":{"properties":{"name":"nonsense"}},)"
                              R"("coordinates":[[1,2],[3,4]]})",
                              test::utm_frame()),
              HasSubstr("names no coordinate reference system"));
}

TEST(HolidaysGeojson, ListsTheGapsWithAreaCauseAndBox) {
  const Box2 box{.min = Vec2(-50.0, -50.0), .max = Vec2(50.0, 50.0)};
  const Route route = test::parallel_lines(box, 25.6);
  const Area area{{.outer = {{-50, -50}, {50, -50}, {50, 50}, {-50, 50}}, .holes = {}}};
  const CoverageGrid grid = test::swept(area, 0.5, route, 10.0);
  const Holidays gaps = test::plain_score(grid, route, 1e4).holidays;
  for (const Frame& frame : {geojson_frame(), test::utm_frame()}) {
    const json document = json::parse(holidays_geojson(gaps, frame));
    EXPECT_EQ(document.contains("local_frame"), frame.crs_wkt.empty());
    EXPECT_EQ(document["holidays"], 2);
    ASSERT_EQ(document["features"].size(), 2U);
    const json& first = document["features"][0];
    EXPECT_EQ(first["properties"]["area_m2"], 12.5);
    EXPECT_EQ(first["properties"]["cause"], "between_lines");
    const Vec2 at = frame.to_file(gaps.list[0].position);
    EXPECT_NEAR(first["properties"]["x_m"].get<double>(), at.x(), 1e-3);
    const json& ring = first["geometry"]["coordinates"][0];
    ASSERT_EQ(ring.size(), 5U);
    EXPECT_EQ(ring[0], ring[4]);
    if (frame.crs_wkt.empty()) {
      EXPECT_EQ(ring[0][0].get<double>(), frame.to_file(gaps.list[0].box.min).x());
      EXPECT_EQ(ring[2][1].get<double>(), frame.to_file(gaps.list[0].box.max).y());
    } else {
      EXPECT_NEAR(ring[0][0].get<double>(), 14.77, 0.1);
    }
  }
}

}  // namespace
}  // namespace swathplan
