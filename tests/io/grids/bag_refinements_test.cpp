#include "io/grids/bag_refinements.h"

#include <gdal_priv.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>

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

/// Each refinement as GDAL's own driver gives it, a raster of its own.
std::vector<Vec3> nodes_by_supergrids(const std::filesystem::path& bag) {
  GDALAllRegister();
  const char* const list[] = {"MODE=LIST_SUPERGRIDS", nullptr};
  const GDALDatasetUniquePtr file(
      GDALDataset::Open(bag.c_str(), GDAL_OF_RASTER, nullptr, list, nullptr));
  std::vector<Vec3> nodes;
  char** names = file->GetMetadata("SUBDATASETS");
  for (int i = 1;; ++i) {
    const char* name =
        CSLFetchNameValue(names, ("SUBDATASET_" + std::to_string(i) + "_NAME").c_str());
    if (name == nullptr) return nodes;
    const GDALDatasetUniquePtr grid(GDALDataset::Open(name, GDAL_OF_RASTER));
    std::array<double, 6> to_map{};
    grid->GetGeoTransform(to_map.data());
    const int columns = grid->GetRasterXSize();
    const int rows = grid->GetRasterYSize();
    std::vector<float> values(static_cast<std::size_t>(columns * rows));
    EXPECT_EQ(grid->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, columns, rows, values.data(), columns,
                                               rows, GDT_Float32, 0, 0, nullptr),
              CE_None);
    for (int r = 0; r < rows; ++r) {
      for (int c = 0; c < columns; ++c) {
        const double z = static_cast<double>(values[static_cast<std::size_t>(r * columns + c)]);
        if (z == 1e6) continue;
        nodes.emplace_back(to_map[0] + (c + 0.5) * to_map[1], to_map[3] + (r + 0.5) * to_map[5], z);
      }
    }
  }
}

TEST(BagRefinements, DepthsAreThoseOfTheFileToAMillimetre) {
  const auto bag = std::filesystem::path(SWATHPLAN_SOURCE_DIR) / "tests" / "corpus" / "import" /
                   "vr_pinnacle.bag";
  std::vector<Vec3> wanted = nodes_by_supergrids(bag);
  std::vector<Vec3> found = read_refinements(bag).vertices;
  ASSERT_GT(wanted.size(), 100U);
  ASSERT_EQ(found.size(), wanted.size());
  const auto by_place = [](const Vec3& a, const Vec3& b) {
    return std::pair(std::llround(1e3 * a.x()), std::llround(1e3 * a.y())) <
           std::pair(std::llround(1e3 * b.x()), std::llround(1e3 * b.y()));
  };
  std::sort(wanted.begin(), wanted.end(), by_place);
  std::sort(found.begin(), found.end(), by_place);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    ASSERT_LT((found[i] - wanted[i]).cwiseAbs().maxCoeff(), 1e-3) << i;
  }
}

TEST(BagRefinements, WithoutASurfaceAreRefused) {
  Refinements all = refined({1, 2, 4, 2});
  std::fill(all.heights.begin(), all.heights.end(), 1e6);
  EXPECT_THAT(refusal([&] { return join_refinements(all, "v.bag"); }), HasSubstr("no three nodes"));
}

}  // namespace
}  // namespace swathplan
