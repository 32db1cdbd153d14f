#include "io/grids/point_layers.h"

#include <gmock/gmock.h>

#include "io/import_files.h"

namespace swathplan {
namespace {

using testing::Contains;
using testing::HasSubstr;
using PointLayers = ImportFiles;

std::string feature(const std::string& shape, const std::string& properties = "{}") {
  return R"({"type":"Feature","properties":)" + properties + R"(,"geometry":)" + shape + "}";
}

std::string point(const std::string& coordinates, const std::string& properties = "{}") {
  return feature(R"({"type":"Point","coordinates":[)" + coordinates + "]}", properties);
}

std::string collection(const std::vector<std::string>& features) {
  std::string text = R"({"type":"FeatureCollection","features":[)";
  for (const std::string& f : features) text += (&f == &features.front() ? "" : ",") + f;
  return text + "]}";
}

TEST_F(PointLayers, ZOfThePointsIsAHeight) {
  const auto file = write("a.geojson", collection({point("15,36,-8"), point("15.1,36,-9"),
                                                   point("15,36.1,-10"), point("15,36,-7")}));
  ASSERT_TRUE(is_point_file(file));
  const SurfaceData data = read_point_file(file, false);
  ASSERT_EQ(data.vertices.size(), 3U);
  EXPECT_THAT(data.vertices, Contains(Vec3(15, 36, -7)));
  EXPECT_FALSE(data.z_is_depth);
  EXPECT_FALSE(data.crs_wkt.empty());
}

TEST_F(PointLayers, ADepthColumnIsPositiveDownInItsUnit) {
  const auto file =
      write("a.geojson", collection({point("15,36", R"({"id":1,"Depth_ft":"8"})"),
                                     point("15.1,36", R"({"id":2,"Depth_ft":"9"})"),
                                     point("15,36.1", R"({"id":3,"Depth_ft":"10"})"),
                                     point("15.1,36.1", R"({"id":4,"Depth_ft":null})")}));
  const SurfaceData data = read_point_file(file, false);
  EXPECT_EQ(data.vertices.size(), 3U);
  EXPECT_TRUE(data.z_is_depth);
  EXPECT_EQ(data.z_unit_m, 0.3048);
  EXPECT_THAT(data.warnings, Contains(HasSubstr("1 features")));
}

TEST_F(PointLayers, WithoutDepthsOrPointsAreRefused) {
  const auto says = [&](const std::string& text) {
    return refusal([&] { return read_point_file(write("a.geojson", text), false); });
  };
  EXPECT_THAT(says(collection({point("15,36", R"({"name":"a"})"), point("15.1,36")})),
              HasSubstr("no z"));
  EXPECT_THAT(says(collection(
                  {feature(R"({"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1],[0,0]]]})")})),
              HasSubstr("holds no points"));
}

TEST_F(PointLayers, OtherFilesAreNone) {
  EXPECT_FALSE(is_point_file(write("a.gpx", "500000 4000000 -8\n")));
  EXPECT_FALSE(is_point_file(write("a.xyz", "500000 4000000 -8\n")));
}

}  // namespace
}  // namespace swathplan
