#include <gtest/gtest.h>

#include <random>

#include "io/report/pictures_internal.h"

namespace swathplan {
namespace {

TEST(CoveragePicture, KeepsToItsBudget) {
  const Area area{{.outer = {{0, 0}, {150, 0}, {150, 150}, {0, 150}}, .holes = {}}};
  CoverageGrid grid(area, 0.1);
  std::mt19937 random(9);
  for (std::uint32_t& word : grid.words()) word |= static_cast<std::uint32_t>(random() % 4);
  const internal::CoveragePicture made = internal::coverage_picture(grid, false, 200'000);
  EXPECT_LE(made.png.size(), 200'000U);
  EXPECT_GT(made.columns, 200U);
  EXPECT_GE(made.box.max.x(), 150.0 - 1e-9);
}

}  // namespace
}  // namespace swathplan
