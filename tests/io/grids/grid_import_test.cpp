#include "io/grids/grid_import.h"

#include <cpl_conv.h>
#include <gdal_priv.h>
#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "io/files/crs.h"
#include "io/import_files.h"

namespace swathplan {
namespace {

using testing::HasSubstr;
using GridImport = ImportFiles;

constexpr std::string_view kGridHead =
    "ncols 3\nnrows 3\nxllcorner 100\nyllcorner 200\ncellsize 2\nNODATA_value -9999\n";

/// A GeoTIFF of 3 x 2 doubles: -1 .. -6 in file order.
std::filesystem::path tiff(const std::filesystem::path& path, std::array<double, 6> transform,
                           const std::vector<double>& values = {-1, -2, -3, -4, -5, -6},
                           double scale = 1.0, double offset = 0.0) {
  GDALAllRegister();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  const GDALDatasetUniquePtr data(driver->Create(path.c_str(), 3, 2, 1, GDT_Float64, nullptr));
  data->SetGeoTransform(transform.data());
  GDALRasterBand* band = data->GetRasterBand(1);
  band->SetScale(scale);
  band->SetOffset(offset);
  std::vector<double> copy = values;
  EXPECT_EQ(CE_None, band->RasterIO(GF_Write, 0, 0, 3, 2, copy.data(), 3, 2, GDT_Float64, 0, 0));
  return path;
}

double height_at(const SurfaceData& data, const Vec2& place) {
  for (const Vec3& v : data.vertices) {
    if ((v.head<2>() - place).norm() < 1e-9) return v.z();
  }
  return std::numeric_limits<double>::quiet_NaN();
}

bool all_counter_clockwise(const SurfaceData& data) {
  for (const auto& f : data.faces) {
    const Vec2 ab = (data.vertices[f[1]] - data.vertices[f[0]]).head<2>();
    const Vec2 ac = (data.vertices[f[2]] - data.vertices[f[0]]).head<2>();
    if (ab.x() * ac.y() - ab.y() * ac.x() <= 0.0) return false;
  }
  return true;
}

TEST_F(GridImport, NodesAreCellCentresAndDiagonalsRunSouthWestToNorthEast) {
  const SurfaceData data =
      read_grid(write("a.asc", std::string(kGridHead) + "-1 -2 -3\n-4 -5 -6\n-7 -8 -9\n"));
  ASSERT_EQ(data.vertices.size(), 9U);
  EXPECT_EQ(height_at(data, Vec2(101, 205)), -1.0);
  EXPECT_EQ(height_at(data, Vec2(105, 201)), -9.0);
  ASSERT_EQ(data.faces.size(), 8U);
  EXPECT_TRUE(all_counter_clockwise(data));
  std::size_t diagonals = 0;
  for (const auto& f : data.faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec2 d = (data.vertices[f.at((i + 1) % 3)] - data.vertices[f.at(i)]).head<2>();
      if (d.x() != 0.0 && d.y() != 0.0) {
        EXPECT_GT(d.x() * d.y(), 0.0);
        ++diagonals;
      }
    }
  }
  EXPECT_EQ(diagonals, 8U);
  EXPECT_DOUBLE_EQ(data.spacing, 2.0);
}

TEST_F(GridImport, CellWithANodataCornerIsNoSeafloor) {
  const SurfaceData data =
      read_grid(write("a.asc", std::string(kGridHead) + "-9999 -2 -3\n-4 -5 -6\n-7 -8 -9\n"));
  EXPECT_EQ(data.vertices.size(), 8U);
  EXPECT_EQ(data.faces.size(), 6U);
  const SurfaceData extra =
      read_grid(write("b.asc", std::string(kGridHead) + "-9999 -2 -3\n-4 -5 -6\n-7 -8 -9\n"), -9.0);
  EXPECT_EQ(extra.faces.size(), 4U);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const SurfaceData holes =
      read_grid(tiff(path("c.tif"), {0, 1, 0, 2, 0, -1}, {nan, -2, -3, -4, -5, -6}));
  EXPECT_EQ(holes.faces.size(), 2U);
}

TEST_F(GridImport, ScaleAndOffsetAreApplied) {
  const SurfaceData data =
      read_grid(tiff(path("a.tif"), {0, 1, 0, 2, 0, -1}, {1, 2, 3, 4, 5, 6}, -0.5, -10.0));
  EXPECT_DOUBLE_EQ(height_at(data, Vec2(0.5, 1.5)), -10.5);
}

TEST_F(GridImport, AnyOrderOfRowsAndColumnsGivesTheSameSurface) {
  const SurfaceData north_up = read_grid(tiff(path("a.tif"), {0, 1, 0, 2, 0, -1}));
  const SurfaceData south_up =
      read_grid(tiff(path("b.tif"), {0, 1, 0, 0, 0, 1}, {-4, -5, -6, -1, -2, -3}));
  const SurfaceData mirrored =
      read_grid(tiff(path("c.tif"), {3, -1, 0, 2, 0, -1}, {-3, -2, -1, -6, -5, -4}));
  EXPECT_EQ(north_up.vertices, south_up.vertices);
  EXPECT_EQ(north_up.vertices, mirrored.vertices);
  EXPECT_EQ(north_up.faces, south_up.faces);
  EXPECT_EQ(north_up.faces, mirrored.faces);
}

TEST_F(GridImport, TurnedGridsLookUp) {
  for (double degrees = 0.0; degrees < 360.0; degrees += 22.5) {
    const double c = std::cos(degrees * M_PI / 180.0);
    const double s = std::sin(degrees * M_PI / 180.0);
    const SurfaceData data = read_grid(tiff(path("a.tif"), {500, c, s, 600, s, -c}));
    EXPECT_TRUE(all_counter_clockwise(data)) << degrees;
    EXPECT_NEAR(height_at(data, Vec2(500 + 0.5 * c + 0.5 * s, 600 + 0.5 * s - 0.5 * c)), -1.0, 0.0)
        << degrees;
  }
}

TEST_F(GridImport, RefusesWhatHoldsNoSurface) {
  const auto says = [&](const std::string& rows) {
    return refusal([&] { return read_grid(write("a.asc", std::string(kGridHead) + rows)); });
  };
  const std::string none = "-9999 -9999 -9999\n";
  EXPECT_THAT(says(none + none + none), HasSubstr("all 9 cells are nodata"));
  EXPECT_THAT(says("-1 -9999 -1\n" + none + "-1 -9999 -1\n"), HasSubstr("no surface"));
  EXPECT_THAT(says("-1 -1\n"), HasSubstr("truncated"));
  EXPECT_THAT(refusal([&] { return read_grid(write("g.tif", garbage(4000))); }),
              HasSubstr("g.tif"));
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_THAT(
      refusal([&] {
        return read_grid(tiff(path("i.tif"), {0, 1, 0, 2, 0, -1}, {-1, -2, -3, -4, inf, -6}));
      }),
      HasSubstr("row 2, column 2"));
}

TEST_F(GridImport, BagAndGeoTiffOfOneSurveyAreEqual) {
  const auto bag = shared_dataset("admiralty_inlet_f00788/F00788_SR_8m.bag");
  if (!std::filesystem::exists(bag)) GTEST_SKIP() << "no shared datasets";
  const SurfaceData a = read_grid(bag);
  const SurfaceData b = read_grid(shared_dataset("admiralty_inlet_f00788/F00788_SR_8m.tif"));
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.faces, b.faces);
  EXPECT_THAT(crs_name(a.crs_wkt), HasSubstr("EPSG:26910"));
  EXPECT_THAT(crs_name(b.crs_wkt), HasSubstr("EPSG:26910"));
}

TEST_F(GridImport, HarbourGridHasItsWaterCells) {
  const auto file = shared_dataset("ronne_harbour_dhi/ronne_local_5m.asc");
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no shared datasets";
  EXPECT_EQ(read_grid(file).vertices.size(), 21110U);
}

}  // namespace
}  // namespace swathplan
