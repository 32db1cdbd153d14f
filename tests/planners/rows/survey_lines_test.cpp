#include "planners/rows/survey_lines.h"

#include <gtest/gtest.h>

#include <optional>

#include "mesh/shapes.h"

namespace swathplan {
namespace {

using test::box_area;

TEST(SurveyLines, FillARectangleEvenly) {
  const auto lines =
      parallel_lines(box_area(0, 0, 100, 40), {.azimuth = Angle::degrees(90), .spacing_m = 10});
  ASSERT_EQ(lines.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    // Across is to the right of the azimuth, so the rows of eastward lines go south.
    EXPECT_NEAR(lines[i].from.y(), 35.0 - 10.0 * static_cast<double>(i), 1e-9);
    EXPECT_NEAR((lines[i].to - lines[i].from).norm(), 100.0, 1e-6);
  }
  EXPECT_NEAR(best_azimuth(box_area(0, 0, 100, 40), 10).deg(), 90.0, 1e-9);
}

TEST(SurveyLines, AreCutAtHolesAndSailedToAndFro) {
  const Area area = subtract(box_area(0, 0, 100, 40), box_area(40, 10, 60, 30));
  const auto lines =
      parallel_lines(area, {.azimuth = Angle::degrees(90), .spacing_m = 10, .inset_m = 1});
  EXPECT_EQ(lines.size(), 6U);
  const auto order = to_and_fro(lines, Vec2(0, 40));
  ASSERT_EQ(order.size(), lines.size());
  double sailed = 0.0;
  for (const SurveyLine& line : order) sailed += (line.to - line.from).norm();
  EXPECT_NEAR(sailed, 2 * 98 + 4 * 38, 1e-6);
  EXPECT_LT((order[0].from - Vec2(0, 40)).norm(), 10.0);
}

}  // namespace
}  // namespace swathplan
