#include "io/mosaic/mosaic.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "io/import_files.h"
#include "io/mosaic/file_date.h"

namespace swathplan {
namespace {

using testing::Contains;
using testing::HasSubstr;

const char* const kUtm33 =
    R"(PROJCS["WGS 84 / UTM zone 33N",GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,)"
    R"(298.257223563]],PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]],)"
    R"(PROJECTION["Transverse_Mercator"],PARAMETER["latitude_of_origin",0],)"
    R"(PARAMETER["central_meridian",15],PARAMETER["scale_factor",0.9996],)"
    R"(PARAMETER["false_easting",500000],PARAMETER["false_northing",0],UNIT["metre",1]])";

class Mosaic : public ImportFiles {
 protected:
  /// An Esri grid of one depth from a corner, in metres without a CRS.
  [[nodiscard]] std::filesystem::path grid(const std::string& name, double x, double y, double cell,
                                           int columns, int rows, double depth,
                                           const std::string& prj = "") const {
    std::string text = fmt::format("ncols {}\nnrows {}\nxllcorner {}\nyllcorner {}\ncellsize {}\n",
                                   columns, rows, x, y, cell);
    for (int j = 0; j < rows; ++j) {
      for (int i = 0; i < columns; ++i) text += fmt::format("{} ", -depth);
      text += "\n";
    }
    const auto file = write(name, text);
    if (!prj.empty()) {
      write(file.stem().string() + ".prj", prj);
    }
    return file;
  }
  static double depth(const ImportedSeafloor& data, const Vec2& at) {
    return DepthQuery(data.seafloor).depth(local_of(data, at)).value_or(-1.0);
  }
};

TEST_F(Mosaic, TheFinestCountsWhereverItIsNamed) {
  const auto coarse = grid("coarse.asc", 0, 0, 10, 12, 12, 8);
  const auto fine = grid("fine.asc", 40, 40, 1, 30, 30, 7);
  const ImportedSeafloor both = import_mosaic({coarse, fine}, MosaicPriority::finest, {});
  EXPECT_DOUBLE_EQ(depth(both, {55, 55}), 7.0);
  EXPECT_DOUBLE_EQ(depth(both, {10, 10}), 8.0);
  EXPECT_NEAR(plan_area_m2(both.seafloor), 110.0 * 110.0, 1e-6);
  EXPECT_THAT(both.notes, Contains(HasSubstr("841 m2 from 'fine.asc' (1 m apart)")));
  EXPECT_THAT(both.notes, Contains(HasSubstr("differ by 1.00 m (median) and up to 1.00 m")));
  EXPECT_THAT(both.input_hash, HasSubstr("+sha1:"));
  EXPECT_DOUBLE_EQ(both.spacing_m, 1.0);
}

TEST_F(Mosaic, TheOrderOrTheDateMayCountInstead) {
  const auto coarse = grid("a_2024-05-01.asc", 0, 0, 10, 12, 12, 8);
  const auto fine = grid("b_20230501.asc", 40, 40, 1, 30, 30, 7);
  EXPECT_DOUBLE_EQ(depth(import_mosaic({fine, coarse}, MosaicPriority::newest, {}), {55, 55}), 8.0);
  EXPECT_DOUBLE_EQ(depth(import_mosaic({fine, coarse}, MosaicPriority::order, {}), {55, 55}), 7.0);
  EXPECT_DOUBLE_EQ(depth(import_mosaic({coarse, fine}, MosaicPriority::order, {}), {55, 55}), 8.0);
  const auto undated = grid("c.asc", 0, 0, 10, 12, 12, 8);
  EXPECT_THAT(refusal([&] {
                return import_mosaic({fine, undated}, MosaicPriority::newest, {});
              }),
              HasSubstr("c.asc' has no date"));
}

TEST_F(Mosaic, WithAndWithoutACrsDoNotGoTogether) {
  const auto plain = grid("a.asc", 500000, 4000000, 10, 12, 12, 8);
  const auto placed = grid("b.asc", 500000, 4000000, 5, 12, 12, 8, kUtm33);
  EXPECT_THAT(refusal([&] {
                return import_mosaic({plain, placed}, MosaicPriority::order, {});
              }),
              HasSubstr("one has a coordinate reference system"));
  // A CRS that is typed is that of the files that say nothing.
  const ImportedSeafloor both =
      import_mosaic({plain, placed}, MosaicPriority::order, {.crs = "EPSG:32633"});
  EXPECT_DOUBLE_EQ(depth(both, {500055, 4000055}), 8.0);
}

TEST(FileDate, TheLastDateInANameCounts) {
  EXPECT_EQ(last_date_in("H13340_20210320_20220101.bag"), "20220101");
  EXPECT_EQ(last_date_in("survey-2023-09-05.tif"), "20230905");
  EXPECT_EQ(last_date_in("2025:09:23 10:00:00"), "20250923");
  EXPECT_FALSE(last_date_in("H13340_12345678_20231399.bag"));
}

}  // namespace
}  // namespace swathplan
