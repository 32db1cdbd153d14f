#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/import_files.h"
#include "io/seafloor/polygon_soup_internal.h"

namespace swathplan {
namespace {

/// What a soup holds.
struct ReadSoup {
  std::vector<Vec3> vertices;
  std::vector<SoupPolygon> polygons;
};

class PolygonSoup : public ImportFiles {
 protected:
  [[nodiscard]] ReadSoup read(const std::string& name, SoupFormat format,
                              std::string_view text) const {
    ReadSoup soup;
    read_soup(write(name, text), format, soup.vertices, soup.polygons);
    return soup;
  }
};

TEST_F(PolygonSoup, OffKeepsDoublesAndPolygons) {
  const ReadSoup soup =
      read("a.off", SoupFormat::off,
           "OFF\n4 1 0\n585000.123 4797000.456 -1.1\n1 0 -1\n1 1 -1\n0 1 -1\n4 0 1 2 3\n");
  ASSERT_EQ(soup.vertices.size(), 4U);
  EXPECT_EQ(soup.vertices[0], Vec3(585000.123, 4797000.456, -1.1));
  EXPECT_THAT(soup.polygons, testing::ElementsAre(SoupPolygon{0, 1, 2, 3}));
}

TEST_F(PolygonSoup, RefusesWhatTheReaderWouldHangOn) {
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
      "property double z\nelement face 1\nproperty list uchar int vertex_indices\n";
  const auto says = [&](const std::string& name, SoupFormat format, std::string_view text) {
    return refusal([&] { return read(name, format, text); });
  };
  EXPECT_THAT(says("a.ply", SoupFormat::ply, head), testing::HasSubstr("end_header"));
  EXPECT_THAT(says("a.ply", SoupFormat::ply, head + "end_header\n0 0 -1\n"),
              testing::HasSubstr("truncated"));
  EXPECT_THAT(says("a.stl", SoupFormat::ascii_stl, "solid s\nfacet normal 0 0 1\n"),
              testing::HasSubstr("endsolid"));
}

}  // namespace
}  // namespace swathplan
