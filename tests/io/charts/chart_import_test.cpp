#include "io/charts/chart_import.h"

#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

#include "chart_files.h"
#include "io/import_files.h"
#include "io/seafloor/import_seafloor.h"

namespace swathplan {
namespace {

using test::small_chart;
using test::write_chart;
using testing::Contains;
using testing::HasSubstr;
using ChartImport = ImportFiles;

TEST_F(ChartImport, ReadsLayersNamedAsInS57) {
  const auto file = write_chart(path("c.gpkg"), small_chart(), 32633);
  ASSERT_TRUE(is_chart(file));
  const ImportedSeafloor chart = import_seafloor(file);
  EXPECT_EQ(chart.kind, "chart");
  // The island and the land are no seafloor.
  EXPECT_NEAR(plan_area_m2(chart.seafloor), 1200.0 * 600.0 - 1e4, 1e-3);
  const DepthQuery depths(chart.seafloor);
  const auto at = [&](double x, double y) { return depths.depth(local_of(chart, Vec2(x, y))); };
  EXPECT_NEAR(at(500750, 4000100).value(), 8.0, 1e-9);
  EXPECT_NEAR(at(500600, 4000300).value(), 5.0, 1e-9);
  EXPECT_FALSE(at(500900, 4000300));
  EXPECT_THAT(chart.notes, Contains(HasSubstr("2 soundings, 1 contours and 2 depth areas")));
  EXPECT_THAT(chart.notes, Contains(HasSubstr("2 LNDARE, 2 WRECKS")));
}

TEST_F(ChartImport, SoundingsAloneStayAFileOfPoints) {
  test::ChartLayers layers = small_chart();
  layers["SOUNDG"].push_back({{{"DEPTH", "9"}}, "POINT(500700 4000500)"});
  const auto file = write_chart(path("c.gpkg"), layers, 32633);
  EXPECT_EQ(import_seafloor(file, {.layer = "SOUNDG"}).kind, "soundings");
}

TEST_F(ChartImport, AreasWithoutARangeAreUnknownGround) {
  test::ChartLayers layers = small_chart();
  layers["DEPARE"][0].fields.erase("DRVAL1");
  const auto some = write_chart(path("some.gpkg"), layers, 32633);
  EXPECT_THAT(read_chart(some).warnings, Contains(HasSubstr("1 depth areas do not say how deep")));
  layers["DEPARE"][1].fields.erase("DRVAL1");
  const auto none = write_chart(path("none.gpkg"), layers, 32633);
  EXPECT_THAT(refusal([&] { return read_chart(none); }), HasSubstr("no depth area"));
}

TEST_F(ChartImport, WhatIsNoCellIsRefused) {
  EXPECT_THAT(refusal([&] { return read_chart(write("A.000", garbage(500))); }),
              HasSubstr("cannot be read as an S-57 cell"));
}

/// The cell with its updates, copied to where it may be damaged. Skips the test without it.
class RealCell : public ImportFiles {
 protected:
  void SetUp() override {
    const auto from = shared_dataset("chesapeake_enc_us4md81m");
    if (!std::filesystem::exists(from / "US4MD81M.000")) {
      GTEST_SKIP() << "no cell beside the checkout";
    }
    for (const char* end : {".000", ".001", ".002", ".003"}) {
      std::filesystem::copy_file(from / (std::string("US4MD81M") + end),
                                 cell().replace_extension(end));
      std::filesystem::permissions(cell().replace_extension(end),
                                   std::filesystem::perms::owner_all);
    }
  }
  [[nodiscard]] std::filesystem::path cell() const { return path("US4MD81M.000"); }
  /// INTU stands before the cell's name in its first record.
  void set_usage_band(char band) const {
    std::ostringstream text;
    text << std::ifstream(cell(), std::ios::binary).rdbuf();
    std::string bytes = text.str();
    bytes.at(bytes.find("US4MD81M.000") - 1) = band;
    write("US4MD81M.000", bytes);
  }
};

TEST_F(RealCell, IsReadWithItsUpdates) {
  const SurfaceData chart = read_chart(cell());
  EXPECT_THAT(chart.notes, Contains(HasSubstr("US4MD81M, edition 31 with updates to 3 (20250923), "
                                              "approach, 1:80000")));
  EXPECT_THAT(chart.notes, Contains(HasSubstr("mean lower low water")));
  EXPECT_THAT(chart.notes, Contains(HasSubstr("from 3326 soundings")));
  const ImportedSeafloor seafloor = import_seafloor(cell());
  EXPECT_NEAR(depth_range(seafloor.seafloor).max, 41.4, 1e-9);
  EXPECT_NEAR(plan_area_m2(seafloor.seafloor) / 1e6, 1622.0, 2.0);
}

TEST_F(RealCell, AMissingUpdateIsNamed) {
  std::filesystem::remove(cell().replace_extension(".002"));
  EXPECT_THAT(refusal([&] { return read_chart(cell()); }), HasSubstr("US4MD81M.002 is missing"));
  std::filesystem::remove(cell().replace_extension(".003"));
  EXPECT_THAT(read_chart(cell()).notes, Contains(HasSubstr("with updates to 1")));
}

TEST_F(RealCell, ItsHashCoversItsUpdates) {
  const std::string all = chart_hash(cell());
  EXPECT_EQ(import_seafloor(cell()).input_hash, all);
  EXPECT_EQ(std::count(all.begin(), all.end(), '+'), 3);
  std::filesystem::remove(cell().replace_extension(".003"));
  const std::string fewer = chart_hash(cell());
  EXPECT_EQ(all.substr(0, fewer.size()), fewer);
  EXPECT_LT(fewer.size(), all.size());
}

TEST_F(RealCell, IsReadFromAZipWithItsUpdates) {
  const std::string whole = "/vsizip/" + path("US4MD81M.zip").string();
  VSILFILE* archive = VSIFOpenL(whole.c_str(), "wb");
  for (const char* end : {".000", ".001", ".002", ".003"}) {
    const std::string name = "/ENC_ROOT/US4MD81M/US4MD81M" + std::string(end);
    ASSERT_EQ(CPLCopyFile((whole + name).c_str(), cell().replace_extension(end).c_str()), 0);
  }
  VSIFCloseL(archive);
  const ImportedSeafloor seafloor = import_seafloor(path("US4MD81M.zip"));
  EXPECT_EQ(seafloor.kind, "chart");
  EXPECT_THAT(seafloor.notes, Contains(HasSubstr("edition 31 with updates to 3")));
}

TEST_F(RealCell, OverviewAndGeneralChartsAreTooCoarse) {
  set_usage_band(2);
  EXPECT_THAT(refusal([&] { return read_chart(cell()); }),
              HasSubstr("usage band 2 (general, 1:80000): too coarse"));
  set_usage_band(5);
  EXPECT_THAT(read_chart(cell()).notes, Contains(HasSubstr("harbour")));
}

}  // namespace
}  // namespace swathplan
