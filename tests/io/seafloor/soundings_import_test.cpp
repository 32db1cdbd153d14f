#include "io/seafloor/soundings_import.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>

#include "io/files/crs.h"
#include "io/import_files.h"
#include "io/seafloor/surface_area.h"

namespace swathplan {
namespace {

using testing::HasSubstr;
using SoundingsImport = ImportFiles;

const std::vector<Vec3> kThree = {Vec3(500000.125, 6000000.5, -5.25), Vec3(500010.5, 6000001, -6),
                                  Vec3(500003, 6000009, -7)};

TEST_F(SoundingsImport, ReadsEveryCommonWayToWriteRows) {
  const std::vector<std::string> files = {
      "500000.125 6000000.5 -5.25\n500010.5 6000001 -6\n500003 6000009 -7\n",
      "# made by hand\r\n500000.125\t6000000.5\t-5.25\r\n500010.5\t6000001\t-6\r\n500003\t6000009"
      "\t-7",
      "500000.125,6000000.5,-5.25,9\n\n500010.5,6000001,-6,9\n500003,6000009,-7,9\n",
      "500000,125;6000000,5;-5,25\n500010,5;6000001;-6\n500003;6000009;-7\n",
      "500000,125 6000000,5 -5,25\n500010,5 6000001 -6\n500003 6000009 -7\n",
      "\xEF\xBB\xBFid,\"Northing (m)\",Easting,elevation\n1,6000000.5,500000.125,-5.25\n"
      "2,6000001,500010.5,-6\n3,6000009,500003,-7\n",
      "// x y z\n  500000.125   6000000.5   -5.25\n500010.5 6000001 -6\n500003 6000009 -7\n",
      "# z y x\n-5.25 6000000.5 500000.125\n-6 6000001 500010.5\n-7 6000009 500003\n",
  };
  for (const std::string& text : files) {
    const SurfaceData data = read_soundings(write("a.xyz", text), false);
    EXPECT_EQ(data.vertices, kThree) << text;
    EXPECT_FALSE(data.z_is_depth);
    EXPECT_TRUE(data.crs_wkt.empty());
  }
}

TEST_F(SoundingsImport, ColumnNamesTellDepthAndDegrees) {
  const SurfaceData data = read_soundings(
      write("a.csv", "lat_deg,lon_deg,depth_m\n55,10,5\n55.1,10,6\n55,10.1,7\n"), false);
  EXPECT_TRUE(data.z_is_depth);
  EXPECT_EQ(crs_name(data.crs_wkt), "EPSG:4326 (WGS 84)");
  EXPECT_EQ(data.vertices[1], Vec3(10, 55.1, 6));
  const SurfaceData up =
      read_soundings(write("b.csv", "x,y,depth\n0,0,-5\n7,1,-6\n3,9,-7\n"), false);
  EXPECT_FALSE(up.z_is_depth);
  EXPECT_THAT(up.notes, testing::Contains(HasSubstr("no positive value")));
  const SurfaceData unknown =
      read_soundings(write("c.csv", "foo,bar,baz\n0,0,-5\n7,1,-6\n3,9,-7\n"), false);
  EXPECT_THAT(unknown.notes, testing::Contains(HasSubstr("foo,bar,baz")));
}

TEST_F(SoundingsImport, ShoalestOfOnePlaceIsKept) {
  const std::string rows = "0 0 -5\n7 1 -6\n0 0 -3\n3 9 -7\n0 0 -4\n";
  const SurfaceData up = read_soundings(write("a.xyz", rows), false);
  ASSERT_EQ(up.vertices.size(), 3U);
  EXPECT_THAT(up.vertices, testing::Contains(Vec3(0, 0, -3)));
  EXPECT_THAT(up.notes, testing::Contains(HasSubstr("2 soundings")));
  const SurfaceData down = read_soundings(write("b.xyz", "0 0 5\n7 1 6\n0 0 3\n3 9 7\n"), true);
  EXPECT_THAT(down.vertices, testing::Contains(Vec3(0, 0, 3)));
}

TEST_F(SoundingsImport, RegularRowsAreAGrid) {
  std::string rows;
  for (int j = 0; j < 30; ++j) {
    for (int i = 39; i >= 0; --i) {
      if (i == 20 && j == 10) continue;  // one node is missing: four cells without seafloor
      rows += fmt::format("{:.3f} {:.3f} {:.2f}\n", 500000.1 + i / 3.0, 6000000.2 + j / 3.0, -5.0);
    }
  }
  const SurfaceData data = read_soundings(write("a.xyz", rows), false);
  EXPECT_TRUE(data.is_clean);
  EXPECT_TRUE(test::all_faces_look_up(data));
  EXPECT_EQ(data.faces.size(), 2U * (39 * 29 - 4));
  EXPECT_NEAR(data.spacing, 1.0 / 3.0, 1e-3);
  EXPECT_NEAR(test::plan_area(data), (39 * 29 - 4) / 9.0, 0.01);
}

TEST_F(SoundingsImport, RefusesWhatMakesNoSurface) {
  const auto says = [&](std::string_view rows) {
    return refusal([&] { return read_soundings(write("a.xyz", rows), false); });
  };
  EXPECT_THAT(says("0 0 -1\n1 1 -1\n"), HasSubstr("2 soundings"));
  EXPECT_THAT(says("0 0 -1\n1 1 -1\n2 x -1\n5 5 5\n"), HasSubstr("line 3: '2 x -1'"));
  EXPECT_THAT(says("0 0 -1\n1 1\n"), HasSubstr("line 2"));
  EXPECT_THAT(says("0 0 -1\n1 1 nan\n2 0 -1\n"), HasSubstr("not finite"));
  EXPECT_THAT(says("0 0 -1\n1 inf -1\n2 0 -1\n"), HasSubstr("line 2"));
  SurfaceData line;
  line.vertices = {Vec3(0, 0, -1), Vec3(1, 1, -1), Vec3(2, 2, -1)};
  EXPECT_THAT(refusal([&] { return join_soundings(line, {}); }), HasSubstr("straight line"));
  SurfaceData wide;
  wide.vertices = kThree;
  EXPECT_THAT(refusal([&] { return join_soundings(wide, 0.5); }), HasSubstr("<longest edge>"));
}

}  // namespace
}  // namespace swathplan
