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

using Names = std::set<std::string>;

/// Elements in their order; attributes must be among those allowed.
std::vector<const CPLXMLNode*> elements(const CPLXMLNode* parent, const Names& attributes) {
  std::vector<const CPLXMLNode*> found;
  for (const CPLXMLNode* n = parent->psChild; n != nullptr; n = n->psNext) {
    if (n->eType == CXT_Element) found.push_back(n);
    if (n->eType == CXT_Attribute) {
      EXPECT_TRUE(attributes.contains(n->pszValue)) << parent->pszValue << " " << n->pszValue;
    }
    EXPECT_TRUE(n->eType != CXT_Text) << parent->pszValue << " holds text";
  }
  return found;
}

void expect_decimal(const CPLXMLNode* node, const char* attribute, double least, double below,
                    bool required) {
  const char* text = CPLGetXMLValue(node, attribute, nullptr);
  EXPECT_TRUE(text != nullptr || !required) << node->pszValue << " lacks " << attribute;
  if (text == nullptr) return;
  EXPECT_EQ(std::string(text).find_first_not_of("-0123456789."), std::string::npos) << text;
  EXPECT_GE(std::stod(text), least) << attribute;
  EXPECT_LT(std::stod(text), below) << attribute;
}

/// The rules of the schema of RTZ 1.0 (IEC 61174:2015, annex S) for what is written here.
TEST(RouteRtz, KeepsToTheTypesOfTheSchema) {
  const test::Exported rtz(ExportFormat::rtz);
  const std::unique_ptr<CPLXMLNode, decltype(&CPLDestroyXMLNode)> document(
      CPLParseXMLFile(rtz.file().c_str()), &CPLDestroyXMLNode);
  const CPLXMLNode* route = CPLGetXMLNode(document.get(), "=route");
  const auto top = elements(route, {"xmlns", "version"});
  ASSERT_EQ(top.size(), 2U);
  EXPECT_STREQ(top[0]->pszValue, "routeInfo");
  EXPECT_STREQ(top[1]->pszValue, "waypoints");
  EXPECT_TRUE(elements(top[0], {"routeName", "routeAuthor"}).empty());
  const auto waypoints = elements(top[1], {});
  ASSERT_GE(waypoints.size(), 2U);
  Names ids;
  for (const CPLXMLNode* w : waypoints) {
    EXPECT_STREQ(w->pszValue, "waypoint");
    const auto parts = elements(w, {"id", "revision", "name", "radius"});
    expect_decimal(w, "id", 0.0, 1e9, true);
    EXPECT_TRUE(ids.insert(CPLGetXMLValue(w, "id", "")).second);
    expect_decimal(w, "radius", 0.0, 10.0, false);
    ASSERT_GE(parts.size(), 1U);
    EXPECT_STREQ(parts[0]->pszValue, "position");
    EXPECT_TRUE(elements(parts[0], {"lat", "lon"}).empty());
    expect_decimal(parts[0], "lat", -90.0, 90.000001, true);
    expect_decimal(parts[0], "lon", -180.0, 180.0, true);
    if (parts.size() == 1) continue;
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_STREQ(parts[1]->pszValue, "leg");
    EXPECT_TRUE(elements(parts[1], {"geometryType", "speedMax", "legInfo"}).empty());
    const Names geometries{"Loxodrome", "Orthodrome"};
    EXPECT_TRUE(geometries.contains(CPLGetXMLValue(parts[1], "geometryType", "")));
    expect_decimal(parts[1], "speedMax", 0.0, 1000.0, false);
  }
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
