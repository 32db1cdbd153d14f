#include "io/grids/bag_refinements.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "io/grids/bag_refinements_internal.h"
#include "io/import_files.h"

namespace swathplan {
namespace {

using testing::Contains;
using testing::HasSubstr;

/// Two by two cells of 8 m, each refined to `steps[i]` metres: 20 m deep, the first node of each 3
/// m.
Refinements refined(const std::vector<double>& steps) {
  Refinements all;
  all.overview.nodata = 1e6;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double step = steps[i];
    Refinement r;
    r.first = all.heights.size();
    r.columns = r.rows = static_cast<std::size_t>(8.0 / step);
    r.step = Vec2(step, step);
    r.south_west = Vec2(500000.0 + 8.0 * static_cast<double>(i % 2) + 0.5 * step,
                        4000000.0 + 8.0 * static_cast<double>(i / 2) + 0.5 * step);
    all.heights.resize(r.first + r.columns * r.rows, -20.0);
    all.heights[r.first] = -3.0;
    all.cells.push_back(r);
  }
  return all;
}

double area(const SurfaceData& data) {
  double sum = 0.0;
  for (const auto& f : data.faces) {
    const Vec2 ab = (data.vertices[f[1]] - data.vertices[f[0]]).head<2>();
    const Vec2 ac = (data.vertices[f[2]] - data.vertices[f[0]]).head<2>();
    const double face = 0.5 * (ab.x() * ac.y() - ab.y() * ac.x());
    EXPECT_GT(face, 0.0);
    sum += face;
  }
  return sum;
}

TEST(BagRefinements, OfOneSizeAreJoinedAsOneGrid) {
  const SurfaceData data = join_refinements(refined({2, 2, 2, 2}), "v.bag");
  EXPECT_EQ(data.vertices.size(), 64U);
  EXPECT_EQ(data.faces.size(), 2U * 49U);
  EXPECT_DOUBLE_EQ(data.spacing, 2.0);
  EXPECT_DOUBLE_EQ(area(data), 14.0 * 14.0);
  EXPECT_EQ(data.vertices.front(), Vec3(500001, 4000001, -3));
  EXPECT_TRUE(data.is_clean);
}

TEST(BagRefinements, OfSeveralSizesAreJoinedAtTheirNodes) {
  const SurfaceData data = join_refinements(refined({1, 2, 4, 2}), "v.bag");
  EXPECT_EQ(data.vertices.size(), 64U + 16U + 4U + 16U);
  EXPECT_THAT(data.vertices, Contains(Vec3(500000.5, 4000000.5, -3)));
  EXPECT_THAT(data.vertices, Contains(Vec3(500002, 4000010, -3)));
  EXPECT_DOUBLE_EQ(data.spacing, 1.0);
  EXPECT_GT(area(data), 190.0);  // from node to node, without a seam
  EXPECT_LT(area(data), 15.5 * 15.5);
  EXPECT_THAT(data.notes, Contains(HasSubstr("1 to 4 a cell")));
}

TEST(BagRefinements, ANodeWithoutDataIsAHole) {
  Refinements all = refined({1, 2, 4, 2});
  const double whole = area(join_refinements(all, "v.bag"));
  all.heights[3 * 8 + 3] = 1e6;
  const SurfaceData data = join_refinements(all, "v.bag");
  EXPECT_EQ(data.vertices.size(), 99U);
  EXPECT_DOUBLE_EQ(area(data), whole - 2.0);  // the square between its four neighbours
}

TEST(BagRefinements, WithoutASurfaceAreRefused) {
  Refinements all = refined({1, 2, 4, 2});
  std::fill(all.heights.begin(), all.heights.end(), 1e6);
  EXPECT_THAT(refusal([&] { return join_refinements(all, "v.bag"); }), HasSubstr("no three nodes"));
}

}  // namespace
}  // namespace swathplan
