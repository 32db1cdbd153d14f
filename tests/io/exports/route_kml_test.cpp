#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <map>

#include "io/exports/exported.h"
#include "io/files/lonlat.h"

namespace swathplan {
namespace {

TEST(RouteKml, IsReadByOgrLegByLeg) {
  const test::Exported exported(ExportFormat::kml);
  const GDALDatasetUniquePtr read = exported.open();
  ASSERT_TRUE(read);
  std::map<std::string, int> lines;
  for (OGRLayer* layer : read->GetLayers()) {
    for (const auto& feature : layer) {
      ++lines[layer->GetName()];
      const OGRLineString* line = feature->GetGeometryRef()->toLineString();
      for (int i = 0; i < line->getNumPoints(); ++i) {
        const Vec2 p(line->getX(i), line->getY(i));
        const Vec2 local = LonLat(exported.frame).to_local({p})[0];
        EXPECT_LT(test::distance_to_path(local, positions(exported.route.waypoints)), 0.002);
      }
    }
  }
  EXPECT_EQ(lines, (std::map<std::string, int>{{"line", 3}, {"turn", 2}}));
}

}  // namespace
}  // namespace swathplan
