#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <set>

#include "io/exports/exported.h"
#include "io/files/lonlat.h"

namespace swathplan {
namespace {

TEST(RouteGpx, IsReadByOgrWithNamesAndOrder) {
  const test::Exported gpx(ExportFormat::gpx);
  const GDALDatasetUniquePtr read = gpx.open();
  ASSERT_TRUE(read);
  OGRLayer* layer = read->GetLayerByName("route_points");
  ASSERT_NE(layer, nullptr);
  std::vector<Vec2> lonlat;
  std::vector<std::string> names, in_full;
  for (const auto& feature : layer) {
    const OGRPoint* p = feature->GetGeometryRef()->toPoint();
    lonlat.emplace_back(p->getX(), p->getY());
    names.emplace_back(feature->GetFieldAsString("name"));
    in_full.emplace_back(feature->GetFieldAsString("desc"));
    EXPECT_LE(names.back().size(), 6U) << names.back();
  }
  EXPECT_EQ(lonlat.size(), gpx.done.waypoints);
  EXPECT_EQ(gpx.done.of, gpx.route.waypoints.size());
  EXPECT_LE(test::largest_distance(gpx.route, LonLat(gpx.frame).to_local(lonlat)), 0.101);
  EXPECT_EQ(names.front(), "S1");
  EXPECT_EQ(names.back(), "E3");
  EXPECT_EQ(in_full.front(), "line 1 start");
  EXPECT_EQ(in_full.back(), "line 3 end");
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
  OGRLayer* routes = read->GetLayerByName("routes");
  ASSERT_EQ(routes->GetFeatureCount(), 1);
  EXPECT_STREQ(OGRFeatureUniquePtr(routes->GetNextFeature())->GetFieldAsString("name"),
               "north & south");
}

}  // namespace
}  // namespace swathplan
