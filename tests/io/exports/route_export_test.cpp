#include "io/exports/route_export.h"

#include <cpl_minixml.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "io/exports/geographic_route.h"
#include "io/exports/route_rtz.h"
#include "io/files/lonlat.h"
#include "io/files/xml.h"
#include "io/sample_plan.h"
#include "io/sample_route.h"
#include "mesh/base/error.h"
#include "temporary_folder.h"

namespace swathplan {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Exports a route as one format under the name 'north & south'.
struct Exported {
  explicit Exported(ExportFormat format, const Route& planned = test::lawnmower(3))
      : route(planned) {
    const PlacedRoute placed{route, frame, nullptr};
    done = export_route(folder.path(), "north & south", placed, placed, {{format}, 0.1, 0}).at(0);
  }
  [[nodiscard]] const fs::path& file() const { return done.files.at(0); }
  [[nodiscard]] GDALDatasetUniquePtr open() const {
    GDALAllRegister();
    return GDALDatasetUniquePtr(GDALDataset::Open(file().c_str(), GDAL_OF_VECTOR));
  }
  test::TemporaryFolder folder;
  Route route;
  Frame frame = test::utm_frame();
  ExportedRoute done{};
};

TEST(RouteGpx, IsReadByOgrWithNamesAndOrder) {
  const Exported gpx(ExportFormat::gpx);
  const GDALDatasetUniquePtr read = gpx.open();
  ASSERT_TRUE(read);
  OGRLayer* layer = read->GetLayerByName("route_points");
  ASSERT_NE(layer, nullptr);
  std::vector<Vec2> lonlat;
  std::vector<std::string> names;
  for (const auto& feature : layer) {
    const OGRPoint* p = feature->GetGeometryRef()->toPoint();
    lonlat.emplace_back(p->getX(), p->getY());
    names.emplace_back(feature->GetFieldAsString("name"));
  }
  EXPECT_EQ(lonlat.size(), gpx.done.waypoints);
  EXPECT_EQ(gpx.done.of, gpx.route.waypoints.size());
  EXPECT_LE(test::largest_distance(gpx.route, internal::LonLat(gpx.frame).to_local(lonlat)), 0.101);
  EXPECT_EQ(names.front(), "line 1 start");
  EXPECT_EQ(names.back(), "line 3 end");
  OGRLayer* routes = read->GetLayerByName("routes");
  ASSERT_EQ(routes->GetFeatureCount(), 1);
  EXPECT_STREQ(OGRFeatureUniquePtr(routes->GetNextFeature())->GetFieldAsString("name"),
               "north & south");
}

TEST(RouteRtz, HoldsWhatTheSchemaAsksFor) {
  const Exported rtz(ExportFormat::rtz);
  const std::unique_ptr<CPLXMLNode, decltype(&CPLDestroyXMLNode)> document(
      CPLParseXMLFile(rtz.file().c_str()), &CPLDestroyXMLNode);
  ASSERT_TRUE(document);
  const CPLXMLNode* route = CPLGetXMLNode(document.get(), "=route");
  ASSERT_NE(route, nullptr);
  EXPECT_STREQ(CPLGetXMLValue(route, "xmlns", ""), "http://www.cirm.org/RTZ/1/0");
  EXPECT_STREQ(CPLGetXMLValue(route, "version", ""), "1.0");
  EXPECT_STREQ(CPLGetXMLValue(route, "routeInfo.routeName", ""), "north & south")
      << "must be that of the file";
  std::vector<Vec2> lonlat;
  std::set<std::string> ids;
  std::vector<double> knots;
  for (const CPLXMLNode* w = CPLGetXMLNode(route, "waypoints.waypoint"); w != nullptr;
       w = w->psNext) {
    lonlat.emplace_back(CPLAtof(CPLGetXMLValue(w, "position.lon", "999")),
                        CPLAtof(CPLGetXMLValue(w, "position.lat", "999")));
    ids.insert(CPLGetXMLValue(w, "id", ""));
    const bool first = lonlat.size() == 1;
    EXPECT_EQ(CPLGetXMLNode(w, "leg") == nullptr, first) << "a leg leads to its waypoint";
    if (first) continue;
    EXPECT_STREQ(CPLGetXMLValue(w, "leg.geometryType", ""), "Loxodrome");
    knots.push_back(CPLAtof(CPLGetXMLValue(w, "leg.speedMax", "0")));
  }
  EXPECT_EQ(lonlat.size(), rtz.done.waypoints);
  EXPECT_EQ(ids.size(), lonlat.size());
  EXPECT_LE(test::largest_distance(rtz.route, internal::LonLat(rtz.frame).to_local(lonlat)), 0.101);
  EXPECT_NEAR(knots.front(), 2.0 * 3600 / 1852, 0.001);
  EXPECT_NEAR(knots[1], 1.5 * 3600 / 1852, 0.001) << "the first leg of the turn";
}

TEST(RouteRtz, TurnsFitTheirLegsAndStayAtTheCorner) {
  const Frame frame = test::utm_frame();
  const GeographicRoute route = geographic_route(test::lawnmower(3), frame, 0.1);
  const std::string text = route_rtz(route, "r", 0.1);
  const auto& w = route.route.waypoints;
  std::size_t at = 0;
  for (std::size_t i = 1; i + 1 < w.size(); ++i) {
    at = text.find("radius=\"", at) + 8;
    const double radius_m = 1852.0 * std::stod(text.substr(at));
    const Vec2 in = w[i].position - w[i - 1].position;
    const Vec2 out = w[i + 1].position - w[i].position;
    const double half = 0.5 * std::acos(std::min(1.0, in.normalized().dot(out.normalized())));
    EXPECT_GT(radius_m, 0.2) << i;
    EXPECT_LE(radius_m * std::tan(half), 0.5 * std::min(in.norm(), out.norm()) + 0.01) << i;
    EXPECT_LE(radius_m * (1.0 / std::cos(half) - 1.0), 0.1 + 0.01) << i;
  }
  EXPECT_EQ(text.find("radius=\"", at), std::string::npos);
}

TEST(RouteLnw, HoldsTheLinesInFileCoordinates) {
  const test::TemporaryFolder folder;
  PlacedRoute placed{test::lawnmower(3), {}, nullptr};
  placed.frame = {.origin = Vec2(1000, 2000), .metres_per_unit = 0.3048, .crs_wkt = ""};
  const auto done =
      export_route(folder.path(), "route", placed, placed, {{ExportFormat::lnw}, 0.1, 0});
  std::istringstream in(text_of(done.at(0).files.at(0)));
  std::string word;
  int count = 0;
  in >> word >> count;
  ASSERT_EQ(word, "LNS");
  ASSERT_EQ(count, 3);
  for (int line = 1; line <= count; ++line) {
    int points = 0;
    in >> word >> points;
    ASSERT_EQ(word, "LIN");
    ASSERT_EQ(points, 2);
    for (int k = 0; k < points; ++k) {
      Vec2 p;
      in >> word >> p.x() >> p.y();
      ASSERT_EQ(word, "PTS");
      EXPECT_NEAR(p.x(), 1000 + 20.0 * line / 0.3048, 0.0006);
      EXPECT_NEAR(p.y(), 2000 + ((line + k) % 2 == 1 ? 0.0 : 100.0 / 0.3048), 0.0006);
    }
    std::string name;
    in >> word >> name;
    EXPECT_EQ(word + name, "LNN" + std::to_string(line));
    in >> word;
    EXPECT_EQ(word, "EOL");
  }
  EXPECT_FALSE(in >> word);
  EXPECT_EQ(done[0].waypoints, 6U);
  EXPECT_EQ(done[0].of, 3U * 201U);
}

TEST(RouteKmlAndDxf, AreReadByOgrLegByLeg) {
  for (const ExportFormat format : {ExportFormat::kml, ExportFormat::dxf}) {
    const Exported exported(format);
    const GDALDatasetUniquePtr read = exported.open();
    ASSERT_TRUE(read);
    std::map<std::string, int> lines;
    for (OGRLayer* layer : read->GetLayers()) {
      for (const auto& feature : layer) {
        const bool kml = format == ExportFormat::kml;
        ++lines[kml ? layer->GetName() : feature->GetFieldAsString("Layer")];
        const OGRLineString* line = feature->GetGeometryRef()->toLineString();
        for (int i = 0; i < line->getNumPoints(); ++i) {
          const Vec2 p(line->getX(i), line->getY(i));
          const Vec2 local =
              kml ? internal::LonLat(exported.frame).to_local({p})[0] : exported.frame.to_local(p);
          EXPECT_LT(test::distance_to_path(local, positions(exported.route.waypoints)), 0.002);
        }
      }
    }
    EXPECT_EQ(lines, (std::map<std::string, int>{{"line", 3}, {"turn", 2}}));
  }
}

TEST(XmlEscaped, LeavesNothingThatXmlCannotHold) {
  EXPECT_EQ(internal::xml_escaped("a&b<c>\"d'"), "a&amp;b&lt;c&gt;&quot;d&apos;");
  EXPECT_EQ(internal::xml_escaped("K\xC3\xB8ge\x01"), "K\xC3\xB8ge?");
  EXPECT_EQ(internal::xml_escaped("\xFF"), "?");
}

std::string why(const std::function<void()>& act) {
  try {
    act();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(ExportRoute, RefusesDegreesWithoutACrsAndWritesNothing) {
  const test::TemporaryFolder folder;
  const PlacedRoute placed{test::lawnmower(2), {}, nullptr};
  const auto act = [&] {
    (void)export_route(folder.path(), "route", placed, placed,
                       {{ExportFormat::lnw, ExportFormat::gpx}, 0.1, 0});
  };
  EXPECT_THROW(act(), InvalidInput);
  EXPECT_THAT(why(act), testing::AllOf(HasSubstr("gpx"), HasSubstr("--crs"), HasSubstr("lnw")));
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(ExportRoute, NamesOptionsThatBreakTheirRules) {
  EXPECT_THROW(check(ExportOptions{{}, 0.0, 0}), UsageError);
  EXPECT_THROW(check(ExportOptions{{}, -1.0, 0}), UsageError);
  EXPECT_THROW(check(ExportOptions{{}, std::nan(""), 0}), UsageError);
  EXPECT_THROW(check(ExportOptions{{}, 0.1, 3}), UsageError);
  EXPECT_NO_THROW(check(ExportOptions{{}, 0.1, 4}));
  EXPECT_THAT(why([] { (void)export_format("shp"); }),
              testing::AllOf(HasSubstr("shp"), HasSubstr("waypoints, gpx, rtz")));
  for (const ExportFormat format : all_export_formats()) {
    EXPECT_EQ(export_format(name(format)), format);
  }
}

TEST(ExportRoute, WarnsOfMissionsThatAutopilotsCannotHold) {
  const Route many = test::lawnmower(120);
  const Exported mission(ExportFormat::waypoints, many);
  ASSERT_EQ(mission.done.warnings.size(), 1U);
  EXPECT_THAT(mission.done.warnings[0], testing::AllOf(HasSubstr("724"), HasSubstr("tolerance")));
  EXPECT_TRUE(Exported(ExportFormat::waypoints).done.warnings.empty());
}

TEST(ExportRoute, RemovesOlderExportsAndNothingElse) {
  const test::TemporaryFolder folder;
  const PlacedRoute placed{test::lawnmower(9), test::utm_frame(), nullptr};
  (void)export_route(folder.path(), "route", placed, placed,
                     {{ExportFormat::waypoints, ExportFormat::gpx}, 0.1, 20});
  for (const char* other : {"route.csv", "route-old.waypoints", "other.gpx", "route-1.txt"}) {
    std::ofstream(folder.path() / other) << "kept";
  }
  EXPECT_TRUE(fs::exists(folder.path() / "route-1.waypoints") ||
              fs::exists(folder.path() / "route-01.waypoints"));
  remove_exports(folder.path(), "route", all_export_formats());
  std::set<std::string> left;
  for (const auto& entry : fs::directory_iterator(folder.path())) {
    left.insert(entry.path().filename().string());
  }
  EXPECT_EQ(left, (std::set<std::string>{"route.csv", "route-old.waypoints", "other.gpx",
                                         "route-1.txt"}));
}

}  // namespace
}  // namespace swathplan
