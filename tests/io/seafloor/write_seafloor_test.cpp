#include "io/seafloor/write_seafloor.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "io/grids/grid_import.h"
#include "io/import_files.h"
#include "io/seafloor/mesh_import.h"
#include "mesh/synthetic.h"

namespace swathplan {
namespace {

using WriteSeafloor = ImportFiles;

TEST_F(WriteSeafloor, ObjKeepsEveryVertexAndFace) {
  const Seafloor seafloor = saddle();
  write_seafloor(path("a.obj"), seafloor);
  const SurfaceData read = read_mesh(path("a.obj"));
  ASSERT_EQ(read.vertices.size(), seafloor.vertices.size());
  EXPECT_EQ(read.faces, seafloor.faces);
  for (std::size_t i = 0; i < read.vertices.size(); ++i) {
    const Vec2 p = seafloor.frame.to_file(seafloor.vertices[i].head<2>());
    ASSERT_EQ(read.vertices[i], Vec3(p.x(), p.y(), seafloor.vertices[i].z()));
  }
}

TEST_F(WriteSeafloor, GridsKeepAsManyNodesAndDepths) {
  const Seafloor seafloor = tilted(20.0, 10.0, 5.0, Angle::degrees(20.0));
  const auto lowest = [](const std::vector<Vec3>& vertices) {
    return std::min_element(vertices.begin(), vertices.end(),
                            [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); })
        ->z();
  };
  for (const char* name : {"a.asc", "a.tif"}) {
    write_seafloor(path(name), seafloor);
    const SurfaceData read = read_grid(path(name));
    EXPECT_EQ(read.vertices.size(), seafloor.vertices.size()) << name;
    EXPECT_NEAR(lowest(read.vertices), lowest(seafloor.vertices), 1e-3) << name;
  }
}

TEST_F(WriteSeafloor, RefusesUnevenNodesAndOtherFormats) {
  Seafloor seafloor = saddle();
  EXPECT_THROW(write_seafloor(path("a.xyz"), seafloor), UsageError);
  seafloor.vertices[7].x() += 0.1;
  EXPECT_THROW(write_seafloor(path("a.asc"), seafloor), UsageError);
  EXPECT_FALSE(std::filesystem::exists(path("a.asc")));
}

}  // namespace
}  // namespace swathplan
