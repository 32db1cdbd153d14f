#include <gdal_priv.h>
#include <gmock/gmock.h>

#include "io/files/crs.h"
#include "io/grids/grid_import.h"
#include "io/import_files.h"

namespace swathplan {
namespace {

using testing::Contains;
using testing::HasSubstr;
using GridSourceOf = ImportFiles;

/// A netCDF variable along (lat, lon), or (time, lat, lon).
struct Variable {
  std::string name;
  std::string positive = {};
  double factor = -1.0;
  std::size_t steps = 0;
};

/// Values are `factor` times 1 .. 6, in 2 rows from 54 north.
std::filesystem::path netcdf(const std::filesystem::path& path,
                             const std::vector<Variable>& variables) {
  GDALAllRegister();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("netCDF");
  const std::unique_ptr<GDALDataset> file(
      driver->CreateMultiDimensional(path.c_str(), nullptr, nullptr));
  const auto root = file->GetRootGroup();
  const auto number = GDALExtendedDataType::Create(GDT_Float64);
  const auto axis = [&](const std::string& name, std::vector<double> values,
                        const std::string& unit) {
    const auto dimension = root->CreateDimension(name, "", "", values.size());
    const auto array = root->CreateMDArray(name, {dimension}, number);
    EXPECT_TRUE(array->SetUnit(unit));
    const GUInt64 start = 0;
    const std::size_t count = values.size();
    EXPECT_TRUE(array->Write(&start, &count, nullptr, nullptr, number, values.data()));
    return dimension;
  };
  const auto lat = axis("lat", {54.0, 54.05}, "degrees_north");
  const auto lon = axis("lon", {10.0, 10.05, 10.1}, "degrees_east");
  const auto time = axis("time", {0, 1}, "days since 2000-01-01");
  for (const Variable& v : variables) {
    auto dimensions = std::vector{lat, lon};
    std::vector<std::size_t> count{2, 3};
    std::vector<double> values = {1, 2, 3, 4, 5, 6};
    if (v.steps > 0) {
      dimensions.insert(dimensions.begin(), time);
      count.insert(count.begin(), 2);
      values.insert(values.end(), {7, 8, 9, 10, 11, 12});
    }
    for (double& value : values) value *= v.factor;
    const auto array = root->CreateMDArray(v.name, dimensions, number);
    const std::vector<GUInt64> start(count.size(), 0);
    EXPECT_TRUE(array->Write(start.data(), count.data(), nullptr, nullptr, number, values.data()));
    if (v.positive.empty()) continue;
    const auto text = array->CreateAttribute("positive", {}, GDALExtendedDataType::CreateString());
    EXPECT_TRUE(text && text->Write(v.positive.c_str()));
  }
  return path;
}

double highest(const SurfaceData& data) {
  double z = data.vertices.front().z();
  for (const Vec3& v : data.vertices) z = std::max(z, v.z());
  return z;
}

TEST_F(GridSourceOf, DegreesEastAreLongitudes) {
  const SurfaceData data = read_grid(netcdf(path("a.nc"), {{"z"}}));
  EXPECT_EQ(crs_name(data.crs_wkt), crs_name(wgs84_crs()));
  EXPECT_EQ(data.vertices.size(), 6U);
  EXPECT_FALSE(data.z_is_depth);
}

TEST_F(GridSourceOf, PositiveDownIsHonoured) {
  EXPECT_TRUE(read_grid(netcdf(path("a.nc"), {{"depth", "down", 1.0}})).z_is_depth);
  EXPECT_FALSE(read_grid(netcdf(path("b.nc"), {{"depth", "up", 1.0}})).z_is_depth);
}

TEST_F(GridSourceOf, VariableNamedAsAHeightIsPreferred) {
  const auto file = netcdf(path("a.nc"), {{"quality"}, {"elevation", "", -2.0}});
  const SurfaceData data = read_grid(file);
  EXPECT_EQ(highest(data), -2.0);
  EXPECT_THAT(data.notes, Contains(HasSubstr("layer 'elevation' of 2")));
  EXPECT_EQ(highest(read_grid(file, {}, "other,QUALITY")), -1.0);
}

TEST_F(GridSourceOf, SeveralVariablesAreListed) {
  const auto file = netcdf(path("a.nc"), {{"first"}, {"second", "", -2.0}});
  EXPECT_THAT(refusal([&] { return read_grid(file); }),
              HasSubstr("2 layers (first, second); choose one with <layer>"));
  EXPECT_EQ(highest(read_grid(file, {}, "second")), -2.0);
}

TEST_F(GridSourceOf, TimeStepIsSaid) {
  const auto file = netcdf(path("a.nc"), {{"z", "", -1.0, 2}});
  const SurfaceData data = read_grid(file);
  EXPECT_EQ(highest(data), -1.0);
  EXPECT_THAT(data.warnings, Contains(HasSubstr("along 'time' too: step 1 of 2")));
  EXPECT_EQ(highest(read_grid(file, {}, "2")), -7.0);
}

/// Bytes in bands of these colours.
std::filesystem::path coloured(const std::filesystem::path& path,
                               const std::vector<GDALColorInterp>& colours) {
  GDALAllRegister();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  const int bands = static_cast<int>(colours.size());
  const GDALDatasetUniquePtr data(driver->Create(path.c_str(), 2, 2, bands, GDT_Byte, nullptr));
  std::array<double, 6> transform{500000, 10, 0, 4000000, 0, -10};
  data->SetGeoTransform(transform.data());
  for (int i = 1; i <= bands; ++i) {
    GDALRasterBand& band = *data->GetRasterBand(i);
    if (colours[static_cast<std::size_t>(i - 1)] == GCI_PaletteIndex) {
      GDALColorTable table;
      const GDALColorEntry blue{0, 0, 255, 255};
      table.SetColorEntry(1, &blue);
      band.SetColorTable(&table);
    }
    band.SetColorInterpretation(colours[static_cast<std::size_t>(i - 1)]);
    band.Fill(7);
  }
  return path;
}

TEST_F(GridSourceOf, PicturesAreRefused) {
  const auto says = [&](const std::vector<GDALColorInterp>& colours) {
    return refusal([&] { return read_grid(coloured(path("a.tif"), colours)); });
  };
  EXPECT_THAT(says({GCI_RedBand, GCI_GreenBand, GCI_BlueBand}), HasSubstr("is a picture"));
  EXPECT_THAT(says({GCI_RedBand, GCI_GreenBand, GCI_BlueBand, GCI_AlphaBand}),
              HasSubstr("is a picture"));
  EXPECT_THAT(says({GCI_PaletteIndex}), HasSubstr("colours of a palette"));
  const SurfaceData grey = read_grid(coloured(path("g.tif"), {GCI_GrayIndex}));
  EXPECT_THAT(grey.warnings, Contains(HasSubstr("grey picture")));
}

}  // namespace
}  // namespace swathplan
