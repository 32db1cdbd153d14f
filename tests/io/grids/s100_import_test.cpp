#include "io/grids/s100_import.h"

#include <gmock/gmock.h>

#include "io/files/crs.h"
#include "io/grids/grid_import.h"
#include "io/grids/hdf5_files.h"
#include "io/import_files.h"

namespace swathplan {
namespace {

using testing::HasSubstr;
using S100Import = ImportFiles;

/// Coverages of 3 x 2 depths from 1 m, 10 m apart, the last without data.
void write_s102(const std::filesystem::path& path, const std::vector<std::string>& instances,
                const std::string& product = "INT.IHO.S-102.2.2") {
  const Hdf5Writer file(path);
  Hdf5Writer::attribute(file.root(), "productSpecification", product);
  Hdf5Writer::code(file.root(), "horizontalCRS", 32633);
  if (instances.empty()) return;
  const auto coverage = Hdf5Writer::group(file.root(), "BathymetryCoverage");
  for (const std::string& name : instances) {
    const auto instance = Hdf5Writer::group(coverage, name);
    Hdf5Writer::attribute(instance, "gridOriginLongitude", 500000.0);
    Hdf5Writer::attribute(instance, "gridOriginLatitude", 4000000.0);
    Hdf5Writer::attribute(instance, "gridSpacingLongitudinal", 10.0);
    Hdf5Writer::attribute(instance, "gridSpacingLatitudinal", 10.0);
    (void)Hdf5Writer::records(Hdf5Writer::group(instance, "Group_001"), "values", {2, 3},
                              {"depth", "uncertainty"}, 0, {1, 0, 2, 0, 3, 0, 4, 0, 5, 0, 1e6F, 0});
  }
}

TEST_F(S100Import, ReadsDepthsFromTheSouth) {
  write_s102(path("a.h5"), {"BathymetryCoverage.01"});
  ASSERT_TRUE(is_s100(path("a.h5")));
  const SurfaceData data = read_grid(path("a.h5"));
  ASSERT_EQ(data.vertices.size(), 5U);
  EXPECT_EQ(data.vertices.front(), Vec3(500000, 4000000, 1));
  EXPECT_EQ(data.vertices.back(), Vec3(500010, 4000010, 5));
  EXPECT_EQ(data.faces.size(), 2U);
  EXPECT_TRUE(data.z_is_depth);
  EXPECT_EQ(data.format, "S-102");
  EXPECT_THAT(crs_name(data.crs_wkt), HasSubstr("EPSG:32633"));
}

TEST_F(S100Import, DepthsAreThoseOfTheFileToAMillimetre) {
  constexpr std::size_t kRows = 40;
  constexpr std::size_t kColumns = 50;
  std::vector<float> records;
  for (std::size_t i = 0; i < kRows * kColumns; ++i) {
    records.push_back(3.0F + 0.0137F * static_cast<float>((i * 7919) % 4001));
    records.push_back(0.2F);
  }
  {
    const Hdf5Writer file(path("a.h5"));
    Hdf5Writer::attribute(file.root(), "productSpecification", std::string("INT.IHO.S-102.3.0.0"));
    Hdf5Writer::code(file.root(), "horizontalCRS", 32633);
    const auto coverage = Hdf5Writer::group(file.root(), "BathymetryCoverage");
    const auto instance = Hdf5Writer::group(coverage, "BathymetryCoverage.01");
    Hdf5Writer::attribute(instance, "gridOriginLongitude", 500000.5);
    Hdf5Writer::attribute(instance, "gridOriginLatitude", 4000000.5);
    Hdf5Writer::attribute(instance, "gridSpacingLongitudinal", 1.0);
    Hdf5Writer::attribute(instance, "gridSpacingLatitudinal", 1.0);
    (void)Hdf5Writer::records(Hdf5Writer::group(instance, "Group_001"), "values", {kRows, kColumns},
                              {"depth", "uncertainty"}, 0, records);
  }
  const SurfaceData data = read_grid(path("a.h5"));
  ASSERT_EQ(data.vertices.size(), kRows * kColumns);
  for (const Vec3& v : data.vertices) {
    const auto column = static_cast<std::size_t>(v.x() - 500000.0);
    const auto row = static_cast<std::size_t>(v.y() - 4000000.0);
    ASSERT_NEAR(v.z(), static_cast<double>(records[2 * (row * kColumns + column)]), 1e-3);
  }
}

TEST_F(S100Import, AsksWhichOfSeveralCoverages) {
  write_s102(path("a.h5"), {"BathymetryCoverage.01", "BathymetryCoverage.02"});
  EXPECT_THAT(refusal([&] { return read_s100(path("a.h5")); }),
              HasSubstr("(BathymetryCoverage.01, BathymetryCoverage.02); choose one with <layer>"));
  EXPECT_EQ(read_s100(path("a.h5"), {}, "BathymetryCoverage.02").vertices.size(), 5U);
}

TEST_F(S100Import, NamesAnotherProduct) {
  write_s102(path("a.h5"), {}, "INT.IHO.S-111.1.0");
  EXPECT_THAT(refusal([&] { return read_grid(path("a.h5")); }), HasSubstr("INT.IHO.S-111.1.0"));
}

TEST_F(S100Import, OtherFilesAreNone) { EXPECT_FALSE(is_s100(write("a.h5", "not HDF5"))); }

}  // namespace
}  // namespace swathplan
