#include "io/seafloor/obj_import.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/import_files.h"

namespace swathplan {
namespace {

using ObjImport = ImportFiles;

TEST_F(ObjImport, KeepsDoublesPolygonsAndIndicesFromTheEnd) {
  std::vector<Vec3> vertices;
  std::vector<SoupPolygon> polygons;
  read_obj(write("a.obj",
                 "# comment\nv 585000.123 4797000.456 -1.1\nvn 0 0 1\nv 1 0 -1\nv 1 1 -1\n"
                 "v 0 1 -1\ng sea\nl 1 2\nf 1/1/1 2//1 3/2 4\nf -4 -3 -2\n"),
           vertices, polygons);
  ASSERT_EQ(vertices.size(), 4U);
  EXPECT_EQ(vertices[0], Vec3(585000.123, 4797000.456, -1.1));
  EXPECT_THAT(polygons, testing::ElementsAre(SoupPolygon{0, 1, 2, 3}, SoupPolygon{0, 1, 2}));
}

TEST_F(ObjImport, NamesTheLineThatCannotBeRead) {
  const auto says = [&](std::string_view text) {
    std::vector<Vec3> vertices;
    std::vector<SoupPolygon> polygons;
    return refusal([&] {
      read_obj(write("a.obj", text), vertices, polygons);
      return 0;
    });
  };
  EXPECT_THAT(says("v 0 0\n"), testing::HasSubstr("line 1"));
  EXPECT_THAT(says("v 0 0 -1\nv 0 inf -1\n"), testing::HasSubstr("line 2"));
  EXPECT_THAT(says("v 0 0 -1\nf 1 1 -2\n"), testing::HasSubstr("line 2"));
  EXPECT_THAT(says("v 0 0 -1\nf 1 1\n"), testing::HasSubstr("fewer than three"));
}

}  // namespace
}  // namespace swathplan
