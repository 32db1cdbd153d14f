// Exported files, read by readers that are not this program's: GDAL, xmllint, gpsbabel, and parsers
// written here for formats that have none.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <set>

#include "io/exports/exported.h"
#include "io/files/lonlat.h"
#include "io/route/read_route.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

using testing::HasSubstr;

/// What is not thinned lies within a centimetre of the plan.
constexpr double kCentimetre = 0.01;

/// A route of few waypoints, which no tolerance thins: lines 20 m apart with slanting ends.
Route few_waypoints() {
  Route route;
  for (int line = 1; line <= 3; ++line) {
    const double x = 20.0 * line;
    const FanAngles fan{Angle::degrees(50.0 + line), Angle::degrees(60.0 - line)};
    for (const double y : {0.0, 90.0}) {
      const bool on = y == 0.0;
      route.waypoints.push_back({.position = Vec2(x + 0.1234 * y, line % 2 == 1 ? y : 91.7 - y),
                                 .kind = on ? LegKind::line : LegKind::turn,
                                 .log = on,
                                 .line = on ? std::optional<int>(line) : std::nullopt,
                                 .fan = on ? std::optional<FanAngles>(fan) : std::nullopt,
                                 .speed_mps = on ? 1.75 : 1.0,
                                 .region = std::nullopt});
    }
  }
  route.waypoints.back().kind = LegKind::end;
  return route;
}

void expect_within_a_centimetre(const std::vector<Vec2>& lonlat, const Route& route,
                                const Frame& frame) {
  const std::vector<Vec2> local = LonLat(frame).to_local(lonlat);
  ASSERT_EQ(local.size(), route.waypoints.size());
  for (std::size_t i = 0; i < local.size(); ++i) {
    EXPECT_LE((local[i] - route.waypoints[i].position).norm(), kCentimetre) << i;
  }
}

std::vector<Vec2> points_of(OGRLayer& layer) {
  std::vector<Vec2> points;
  for (const auto& feature : layer) {
    const OGRGeometry* geometry = feature->GetGeometryRef();
    if (wkbFlatten(geometry->getGeometryType()) == wkbPoint) {
      points.emplace_back(geometry->toPoint()->getX(), geometry->toPoint()->getY());
    }
  }
  return points;
}

TEST(ReadElsewhere, GdalReadsGpxWithinACentimetre) {
  const test::Exported gpx(ExportFormat::gpx, few_waypoints());
  const auto data = gpx.open();
  ASSERT_TRUE(data);
  expect_within_a_centimetre(points_of(*data->GetLayerByName("route_points")), gpx.route,
                             gpx.frame);
}

TEST(ReadElsewhere, GdalReadsKmlAndDxfWithinACentimetre) {
  const std::vector<Vec2> planned = positions(few_waypoints().waypoints);
  for (const ExportFormat format : {ExportFormat::kml, ExportFormat::dxf}) {
    const test::Exported exported(format, few_waypoints());
    const auto data = exported.open();
    ASSERT_TRUE(data);
    std::size_t points = 0;
    for (OGRLayer* layer : data->GetLayers()) {
      for (const auto& feature : *layer) {
        for (const OGRPoint& p : *feature->GetGeometryRef()->toLineString()) {
          const Vec2 at(p.getX(), p.getY());
          const Vec2 local = format == ExportFormat::dxf
                                 ? exported.frame.to_local(at)
                                 : LonLat(exported.frame).to_local({at}).front();
          double nearest = 1e9;
          for (const Vec2& w : planned) nearest = std::min(nearest, (w - local).norm());
          EXPECT_LE(nearest, kCentimetre) << name(format);
          ++points;
        }
      }
    }
    EXPECT_EQ(points, 2 * (planned.size() - 1)) << name(format) << ": two ends of each leg";
  }
}

TEST(ReadElsewhere, GdalReadsTheGeoPackageWithFansAndSpeeds) {
  const test::Exported gpkg(ExportFormat::gpkg, few_waypoints());
  const auto data = gpkg.open();
  ASSERT_TRUE(data);
  OGRLayer* points = data->GetLayerByName("waypoints");
  ASSERT_NE(points, nullptr);
  EXPECT_EQ(points->GetFeatureCount(), 6);
  EXPECT_NE(points->GetSpatialRef(), nullptr);
  std::size_t i = 0;
  for (const auto& feature : *points) {
    const Waypoint& w = gpkg.route.waypoints[i++];
    const OGRPoint& p = *feature->GetGeometryRef()->toPoint();
    EXPECT_LE((gpkg.frame.to_local(Vec2(p.getX(), p.getY())) - w.position).norm(), 1e-6);
    EXPECT_EQ(std::string(feature->GetFieldAsString("kind")), name(w.kind));
    EXPECT_EQ(feature->IsFieldSetAndNotNull(feature->GetFieldIndex("port_deg")) != 0,
              w.fan.has_value());
    if (w.fan) {
      EXPECT_NEAR(feature->GetFieldAsDouble("port_deg"), w.fan->port.deg(), 1e-9);
    }
    EXPECT_NEAR(feature->GetFieldAsDouble("speed_mps"), w.speed_mps, 1e-12);
  }
  OGRLayer* lines = data->GetLayerByName("legs");
  ASSERT_NE(lines, nullptr);
  EXPECT_EQ(lines->GetFeatureCount(), static_cast<GIntBig>(legs(gpkg.route).size()));
}

TEST(ReadElsewhere, TheSameRouteGivesTheSameGeoPackage) {
  const test::Exported once(ExportFormat::gpkg, few_waypoints());
  const test::Exported again(ExportFormat::gpkg, few_waypoints());
  EXPECT_TRUE(test::text_of(once.file()) == test::text_of(again.file()));
}

TEST(ReadElsewhere, OurReaderTakesFansAndSpeedsFromTheGeoPackage) {
  const test::Exported gpkg(ExportFormat::gpkg, few_waypoints());
  const ImportedRoute back = read_route(gpkg.file(), gpkg.frame, {});
  ASSERT_EQ(back.route.waypoints.size(), gpkg.route.waypoints.size());
  EXPECT_FALSE(back.fan_note);
  for (std::size_t i = 0; i < back.route.waypoints.size(); ++i) {
    const Waypoint& w = gpkg.route.waypoints[i];
    const Waypoint& r = back.route.waypoints[i];
    EXPECT_LE((r.position - w.position).norm(), 1e-6);
    EXPECT_EQ(r.kind, w.kind);
    EXPECT_EQ(r.line, w.line);
    ASSERT_EQ(r.fan.has_value(), w.fan.has_value()) << i;
    if (w.fan) {
      EXPECT_NEAR(r.fan->starboard.deg(), w.fan->starboard.deg(), 1e-9);
    }
    EXPECT_NEAR(r.speed_mps, w.speed_mps, 1e-12);
  }
}

/// xmllint's word on a file of RTZ.
int xmllint(const std::string& file) {
  const std::string schema = SWATHPLAN_SOURCE_DIR "/tests/io/exports/rtz_1_0.xsd";
  return std::system(
      ("xmllint --noout --nonet --schema '" + schema + "' '" + file + "' 2>/dev/null").c_str());
}

TEST(ReadElsewhere, XmllintHoldsRtzAgainstItsSchema) {
  if (std::system("command -v xmllint >/dev/null") != 0) {
    GTEST_SKIP() << "skipped: xmllint is not installed";
  }
  const test::Exported rtz(ExportFormat::rtz);
  EXPECT_EQ(xmllint(rtz.file().string()), 0);
  const test::TemporaryFolder folder;
  const std::string good = test::text_of(rtz.file());
  const auto broken = [&](const std::string& what, const std::string& with) {
    std::string text = good;
    text.replace(text.find(what), what.size(), with);
    const auto file = folder.path() / "broken.rtz";
    std::ofstream(file) << text;
    return xmllint(file.string());
  };
  EXPECT_NE(broken("lat=\"", "lat=\"1"), 0) << "a latitude over 90";
  EXPECT_NE(broken("geometryType=\"Loxodrome\"", "geometryType=\"Straight\""), 0);
  EXPECT_NE(broken("version=\"1.0\">", "version=\"1.9\">"), 0);
  EXPECT_NE(broken("id=\"2\"", "id=\"1\""), 0) << "one id twice";
}

TEST(ReadElsewhere, GpsbabelReadsGpx) {
  if (std::system("command -v gpsbabel >/dev/null") != 0) {
    GTEST_SKIP() << "skipped: gpsbabel is not installed";
  }
  const test::Exported gpx(ExportFormat::gpx, few_waypoints());
  const test::TemporaryFolder folder;
  const auto out = folder.path() / "out.csv";
  ASSERT_EQ(std::system(("gpsbabel -r -i gpx -f '" + gpx.file().string() +
                         "' -x transform,wpt=rte -o unicsv,prec=8 -F '" + out.string() + "'")
                            .c_str()),
            0);
  std::istringstream rows(test::text_of(out));
  std::string row;
  std::getline(rows, row);
  EXPECT_THAT(row, HasSubstr("Latitude,Longitude"));
  std::vector<Vec2> lonlat;
  while (std::getline(rows, row)) {
    double number = 0.0, lat = 0.0, lon = 0.0;
    ASSERT_EQ(std::sscanf(row.c_str(), "%lf,%lf,%lf", &number, &lat, &lon), 3) << row;
    lonlat.emplace_back(lon, lat);
  }
  expect_within_a_centimetre(lonlat, gpx.route, gpx.frame);
}

/// The rows of a text, of which each must end in CRLF.
std::vector<std::string> crlf_rows(const std::string& text) {
  std::vector<std::string> rows;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find("\r\n", at);
    EXPECT_NE(end, std::string::npos) << "a row without its end";
    if (end == std::string::npos) break;
    rows.push_back(text.substr(at, end - at));
    at = end + 2;
  }
  return rows;
}

TEST(ReadElsewhere, RunlinesFollowEivasDescription) {
  const test::Exported rln(ExportFormat::rln, few_waypoints());
  std::vector<Vec2> places;
  std::vector<double> kilometres;
  std::vector<std::string> names;
  for (const std::string& row : crlf_rows(test::text_of(rln.file()))) {
    if (row.starts_with('#')) continue;
    if (row.starts_with('"')) {
      ASSERT_TRUE(row.ends_with('"'));
      names.push_back(row.substr(1, row.size() - 2));
      continue;
    }
    double x = 0.0, y = 0.0, kp = 0.0;
    int used = 0;
    ASSERT_EQ(std::sscanf(row.c_str(), "%lf, %lf, %lf%n", &x, &y, &kp, &used), 3) << row;
    EXPECT_EQ(used, static_cast<int>(row.size()));
    places.push_back(rln.frame.to_local(Vec2(x, y)));
    kilometres.push_back(kp);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"1", "2", "3"}));
  ASSERT_EQ(places.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_LE((places[i] - rln.route.waypoints[i].position).norm(), kCentimetre);
    const double length = (places[i] - places[i - i % 2]).norm();
    EXPECT_NEAR(kilometres[i], length / 1000.0, 1e-6);
  }
}

TEST(ReadElsewhere, PlannedLinesOfSisHaveTheirRows) {
  const test::Exported sis(ExportFormat::asciiplan, few_waypoints());
  const auto rows = crlf_rows(test::text_of(sis.file()));
  ASSERT_EQ(rows.size(), 6U);
  EXPECT_EQ(rows[0], "DEG");
  EXPECT_EQ(rows[1], "");
  EXPECT_EQ(rows[2], "0 0 0 0");
  std::vector<Vec2> lonlat;
  for (std::size_t i = 3; i < 6; ++i) {
    char line[32], mark = 0;
    int number = 0, zero = -1;
    long long time = 0;
    double lat[2], lon[2];
    ASSERT_EQ(std::sscanf(rows[i].c_str(), "_LINE %31s %d %lld %d %lf %lf %lf %lf %c", line,
                          &number, &time, &zero, &lat[0], &lon[0], &lat[1], &lon[1], &mark),
              9);
    EXPECT_EQ(std::string(line), "Line_" + std::to_string(i - 2));
    EXPECT_EQ(number, static_cast<int>(i - 2));
    EXPECT_EQ(zero, 0);
    EXPECT_EQ(mark, '"');
    for (const int k : {0, 1}) lonlat.emplace_back(lon[k], lat[k]);
  }
  expect_within_a_centimetre(lonlat, sis.route, sis.frame);
}

TEST(ReadElsewhere, PosesOfRosStandOnThePathAndLookAlongIt) {
  const test::Exported ros(ExportFormat::yaml, few_waypoints());
  std::istringstream in(test::text_of(ros.file()));
  std::string row;
  std::getline(in, row);
  EXPECT_THAT(row, HasSubstr("EPSG:32633"));
  std::vector<std::string> head(4);
  for (std::string& h : head) std::getline(in, h);
  EXPECT_EQ(head, (std::vector<std::string>{"header:", "  stamp: {sec: 0, nanosec: 0}",
                                            "  frame_id: map", "poses:"}));
  std::size_t i = 0;
  while (std::getline(in, row)) {
    ASSERT_EQ(row, "- header: {stamp: {sec: 0, nanosec: 0}, frame_id: map}");
    double x = 0.0, y = 0.0, z = 1.0, w = 0.0;
    std::getline(in, row);
    ASSERT_EQ(row, "  pose:");
    std::getline(in, row);
    ASSERT_EQ(std::sscanf(row.c_str(), "    position: {x: %lf, y: %lf, z: 0.0}", &x, &y), 2);
    std::getline(in, row);
    ASSERT_EQ(std::sscanf(row.c_str(), "    orientation: {x: 0.0, y: 0.0, z: %lf, w: %lf}", &z, &w),
              2);
    const auto& points = ros.route.waypoints;
    ASSERT_LT(i, points.size());
    EXPECT_LE((ros.frame.to_local(Vec2(x, y)) - points[i].position).norm(), 1e-5);
    const std::size_t k = std::min(i, points.size() - 2);
    const Vec2 course = (points[k + 1].position - points[k].position).normalized();
    EXPECT_NEAR((Vec2(1.0 - 2.0 * z * z, 2.0 * z * w) - course).norm(), 0.0, 1e-6);
    ++i;
  }
  EXPECT_EQ(i, ros.route.waypoints.size());
}

TEST(LineTable, HoldsWhatFormatsLeaveOut) {
  const test::Exported gpx(ExportFormat::gpx, few_waypoints());
  const auto rows = crlf_rows(test::text_of(gpx.folder.path() / line_table_name("north & south")));
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_THAT(rows[0], HasSubstr("heading_deg,length_m,port_deg,stbd_deg,speed_mps"));
  EXPECT_THAT(rows[1], testing::StartsWith("1,line,1,"));
  EXPECT_THAT(rows[1], testing::EndsWith(",51,59,1.75"));
  EXPECT_THAT(rows[3], testing::EndsWith(",53,57,1.75"));
  const test::Exported gpkg(ExportFormat::gpkg, few_waypoints());
  EXPECT_FALSE(std::filesystem::exists(gpkg.folder.path() / line_table_name("north & south")));
}

TEST(LineTable, HasARowForEachStretchOfOneFan) {
  Route route = few_waypoints();
  Waypoint middle = route.waypoints[0];
  middle.position = 0.5 * (route.waypoints[0].position + route.waypoints[1].position);
  middle.fan = FanAngles{Angle::degrees(30), Angle::degrees(31)};
  route.waypoints.insert(route.waypoints.begin() + 1, middle);
  const test::Exported gpx(ExportFormat::gpx, route);
  const auto rows = crlf_rows(test::text_of(gpx.folder.path() / line_table_name("north & south")));
  ASSERT_EQ(rows.size(), 5U);
  EXPECT_THAT(rows[2], testing::StartsWith("1,line,2,"));
  EXPECT_THAT(rows[2], testing::EndsWith(",30,31,1.75"));
}

std::string refusal_of_route(const std::string& text, const std::string& file) {
  try {
    (void)parse_route(text, file, test::utm_frame(),
                      {.fan = FanAngles{Angle::degrees(60), Angle::degrees(60)}});
  } catch (const InvalidInput& e) {
    return e.what();
  }
  return "accepted";
}

TEST(ForeignLines, BrokenRowsAreNamed) {
  EXPECT_THAT(refusal_of_route("\"a\"\n1,2,0\n3;\n", "x.rln"), HasSubstr("'x.rln', line 3"));
  EXPECT_THAT(refusal_of_route("\"a\"\n500000,6000000,0\n", "x.rln"), HasSubstr("one waypoint"));
  EXPECT_THAT(refusal_of_route("DEG\n\n0 0 0 0\n_LINE A 1 20200101000000 0 55 15 \"\n", "x"),
              HasSubstr("at least two pairs"));
  EXPECT_THAT(refusal_of_route("DEG\n\n0 0 0 0\n_LINE A 1 2020 0 55 15 55 e \"\n", "x"),
              HasSubstr("'55 e' is no latitude and longitude"));
  EXPECT_THAT(refusal_of_route("XY\n\n_LINE A 1 2020 0 55 15 55 16 \"\n", "x"),
              HasSubstr("in degrees (DEG)"));
  EXPECT_THAT(refusal_of_route("poses:\n- pose:\n    position: {x: 1.0, z: 0}\n", "p.yaml"),
              HasSubstr("'p.yaml', pose 1"));
}

TEST(ForeignLines, OtherWritersOfTheSameFormatsAreRead) {
  const RouteDefaults how{.fan = FanAngles{Angle::degrees(60), Angle::degrees(60)}};
  const Frame frame = test::utm_frame();
  const Vec2 a = frame.to_file(Vec2(10, 20));
  const Vec2 b = frame.to_file(Vec2(10, 90));
  // Blanks as separators, comments, no kilometres.
  const std::string rln = "# made by hand\n\"pipe\"\n" + std::to_string(a.x()) + " " +
                          std::to_string(a.y()) + "\n" + std::to_string(b.x()) + " " +
                          std::to_string(b.y()) + "\n";
  const ImportedRoute runline = parse_route(rln, "x.rln", frame, how);
  ASSERT_EQ(runline.route.waypoints.size(), 2U);
  EXPECT_LE((runline.route.waypoints[1].position - Vec2(10, 90)).norm(), 1e-5);
  EXPECT_FALSE(runline.route.waypoints[0].line);
  // Block style, as ros2 topic echo prints it.
  const auto pose = [](const Vec2& p) {
    return "- header:\n    stamp:\n      sec: 1\n      nanosec: 5\n    frame_id: map\n  pose:\n    "
           "position:\n      x: " +
           std::to_string(p.x()) + "\n      y: " + std::to_string(p.y()) +
           "\n      z: 0.0\n    orientation:\n      x: 0.0\n      y: 0.0\n      z: 0.7\n      w: "
           "0.7\n";
  };
  const std::string yaml =
      "header:\n  stamp:\n    sec: 0\n    nanosec: 0\n  frame_id: map\nposes:\n" + pose(a) +
      pose(b) + "---\n";
  const ImportedRoute path = parse_route(yaml, "p.yaml", frame, how);
  ASSERT_EQ(path.route.waypoints.size(), 2U);
  EXPECT_LE((path.route.waypoints[0].position - Vec2(10, 20)).norm(), 1e-5);
}

/// A .plan with these items beside members that QGroundControl never wrote.
std::string plan_with(const std::string& items) {
  return R"({"fileType":"Plan","version":1,"weather":{"wind":[1,2]},"mission":{"version":2,"sea":3,)"
         R"("items":[)" +
         items + "]}}";
}

std::string plan_item(double lat, const std::string& more = "") {
  return R"({"type":"SimpleItem","command":16,"frame":3,"params":[0,0,0,null,)" +
         std::to_string(lat) + ",15.0,0]" + more + "}";
}

TEST(ForeignMissions, OneWaypointIsRefusedAndForeignFieldsArePassedOver) {
  EXPECT_THAT(refusal_of_route(plan_with(plan_item(55.0)), "a.plan"),
              HasSubstr("'a.plan' holds one waypoint: a route needs at least two"));
  EXPECT_THAT(refusal_of_route(plan_with(""), "a.plan"), HasSubstr("holds no waypoints"));
  EXPECT_EQ(
      refusal_of_route(plan_with(plan_item(55.0, R"(,"mood":"calm")") + "," + plan_item(55.001)),
                       "a.plan"),
      "accepted");
  EXPECT_THAT(refusal_of_route(plan_with(plan_item(55.0) + R"(,{"type":"ComplexItem",)"
                                                           R"("complexItemType":"garden"})"),
                               "a.plan"),
              HasSubstr("'garden' holds an area but none of its lines"));
  const auto rtz = [](const std::string& waypoints) {
    return R"(<route xmlns="http://www.cirm.org/RTZ/1/0" version="1.0"><routeInfo routeName="a"/>)"
           "<waypoints>" +
           waypoints + "</waypoints></route>";
  };
  const std::string first =
      R"(<waypoint id="1" mood="calm"><position lat="55" lon="15"/></waypoint>)";
  const std::string second =
      R"(<waypoint id="2"><garden/><position lat="55.001" lon="15"/></waypoint>)";
  EXPECT_THAT(refusal_of_route(rtz(first), "a.rtz"), HasSubstr("'a.rtz' holds one waypoint"));
  EXPECT_EQ(refusal_of_route(rtz(first + second), "a.rtz"), "accepted");
  EXPECT_NE(refusal_of_route(rtz(first + R"(<waypoint id="2"/>)"), "a.rtz"), "accepted");
}

}  // namespace
}  // namespace swathplan
