#include "io/exports/route_rtz.h"

#include <cpl_minixml.h>
#include <gtest/gtest.h>

#include <memory>
#include <set>

#include "io/exports/exported.h"
#include "io/exports/geographic_route.h"
#include "io/files/lonlat.h"

namespace swathplan {
namespace {

TEST(RouteRtz, HoldsWhatTheSchemaAsksFor) {
  const test::Exported rtz(ExportFormat::rtz);
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
  EXPECT_LE(test::largest_distance(rtz.route, LonLat(rtz.frame).to_local(lonlat)), 0.101);
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

}  // namespace
}  // namespace swathplan
