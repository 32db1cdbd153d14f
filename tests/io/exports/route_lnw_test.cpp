#include <gtest/gtest.h>

#include <sstream>

#include "io/exports/exported.h"

namespace swathplan {
namespace {

TEST(RouteLnw, HoldsTheLinesInFileCoordinates) {
  const test::TemporaryFolder folder;
  PlacedRoute placed{test::lawnmower(3), {}, nullptr};
  placed.frame = {.origin = Vec2(1000, 2000), .metres_per_unit = 0.3048, .crs_wkt = ""};
  const auto done =
      export_route(folder.path(), "route", placed, placed, {{ExportFormat::lnw}, 0.1, 0});
  std::istringstream in(test::text_of(done.at(0).files.at(0)));
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

}  // namespace
}  // namespace swathplan
