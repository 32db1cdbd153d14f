// Files that once gave a wrong seafloor without a word: upside down, packed, of other programs.
#include <cpl_vsi.h>
#include <gmock/gmock.h>

#include "io/files/crs.h"
#include "io/import_files.h"
#include "io/seafloor/import_seafloor.h"
#include "io/seafloor/inspection.h"

namespace swathplan {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using ForeignFiles = ImportFiles;

constexpr std::string_view kHead = "ncols 3\nnrows 4\nxllcorner 0\nyllcorner 0\ncellsize 10\n";

void put_foreign(const std::string& target, const std::string& text) {
  VSILFILE* file = VSIFOpenL(target.c_str(), "wb");
  ASSERT_NE(file, nullptr) << target;
  EXPECT_EQ(VSIFWriteL(text.data(), 1, text.size(), file), text.size());
  EXPECT_EQ(VSIFCloseL(file), 0);
}

TEST_F(ForeignFiles, DepthsWithNegativeLandAreWarnedAboutBeforeMostIsLand) {
  const auto file =
      write("a.asc", std::string(kHead) + "9 9 9\n10 11 9\n-1.5 -1.5 -1.5\n-1.5 -1.5 -1.5\n");
  const ImportedSeafloor up = import_seafloor(file);
  EXPECT_LT(up.land_share, 0.9);
  EXPECT_THAT(warnings_of(up), Contains(AllOf(HasSubstr("looks like depths, positive down"),
                                              HasSubstr("<z positive> down"))));
  const ImportedSeafloor down =
      import_seafloor(file, {.z_positive = ImportOptions::ZPositive::down});
  EXPECT_THAT(warnings_of(down), Not(Contains(HasSubstr("looks like depths"))));
  EXPECT_DOUBLE_EQ(down.raw_z_max, 11.0);
}

TEST_F(ForeignFiles, UnitOfAVectorColumnIsUsedUnlessAnotherIsGiven) {
  std::string text = R"({"type":"FeatureCollection","features":[)";
  for (int i = 0; i < 9; ++i) {
    text += std::string(i == 0 ? "" : ",") + R"({"type":"Feature","properties":{"depth_ft":)" +
            std::to_string(10 + i) + R"(},"geometry":{"type":"Point","coordinates":[)" +
            std::to_string(15.0 + 0.001 * (i % 3)) + "," + std::to_string(36.0 + 0.001 * (i / 3)) +
            "]}}";
  }
  const auto file = write("a.geojson", text + "]}");
  const ImportedSeafloor r = import_seafloor(file);
  EXPECT_EQ(r.kind, "soundings");
  EXPECT_NEAR(depth_range(r.seafloor).max, 18 * 0.3048, 1e-9);
  EXPECT_NEAR(depth_range(import_seafloor(file, {.z_unit_m = 2.0}).seafloor).max, 36.0, 1e-9);
  // Metres, where they are asked for, are an answer too.
  const ImportedSeafloor metres = import_seafloor(file, {.z_unit_m = 1.0});
  EXPECT_NEAR(depth_range(metres.seafloor).max, 18.0, 1e-9);
  EXPECT_THAT(metres.notes, Contains(HasSubstr("not of 0.3048 m")));
}

TEST_F(ForeignFiles, PackedFilesAreReadAsTheyAre) {
  const std::string grid = std::string(kHead) + "-9 -9 -9\n-10 -11 -9\n-8 -9 -9\n-7 -7 -7\n";
  const ImportedSeafloor plain = import_seafloor(write("a.asc", grid));
  put_foreign("/vsigzip/" + path("a.asc.gz").string(), grid);
  const ImportedSeafloor packed = import_seafloor(path("a.asc.gz"));
  EXPECT_EQ(packed.kind, "grid");
  EXPECT_EQ(packed.file, path("a.asc.gz").string());
  EXPECT_EQ(packed.seafloor.vertices, plain.seafloor.vertices);
  EXPECT_NE(packed.input_hash, plain.input_hash);
  put_foreign("/vsigzip/" + path("b.xyz.gz").string(), "0 0 -8\n10 0 -9\n0 10 -8\n10 10 -9\n");
  EXPECT_EQ(import_seafloor(path("b.xyz.gz")).kind, "soundings");
  put_foreign("/vsigzip/" + path("c.xyz.gz").string(), "0 0 -8\nhello\n");
  EXPECT_THAT(refusal([&] { return import_seafloor(path("c.xyz.gz")); }),
              HasSubstr(path("c.xyz.gz").string() + "/c.xyz"));
}

TEST_F(ForeignFiles, RawSonarFilesAreNamed) {
  const auto file =
      write("a.kmall", std::string("\x40\x01\x00\x00#IIP", 8) + std::string(400, '\0'));
  EXPECT_THAT(refusal([&] { return import_seafloor(file); }),
              AllOf(HasSubstr("raw multibeam"), Not(HasSubstr("garbled"))));
}

/// A sheet of 4 faces, `depth` deep at its corner, as OBJ; `first` is its first vertex.
std::string sheet(double depth, int first) {
  std::string text;
  for (int i = 0; i < 9; ++i) {
    text += "v " + std::to_string(10 * (i % 3)) + " " + std::to_string(10 * (i / 3)) + " " +
            std::to_string(-depth - 0.1 * i) + "\n";
  }
  for (const int i : {0, 1, 3, 4}) {
    const int a = first + i;
    text += "f " + std::to_string(a) + " " + std::to_string(a + 1) + " " + std::to_string(a + 4) +
            " " + std::to_string(a + 3) + "\n";
  }
  return text;
}

TEST_F(ForeignFiles, ALayerBelowTheSeafloorDoesNotCount) {
  const auto file = write("a.obj", sheet(10, 1) + sheet(15, 10));
  const std::string text = inspection_text(import_seafloor(file));
  EXPECT_THAT(text, HasSubstr("400 m2"));
  EXPECT_THAT(text, HasSubstr("10.00 to 10.80 m"));
  EXPECT_THAT(text, HasSubstr("8 of 16 faces lie below others"));
  EXPECT_THAT(inspection_text(import_seafloor(write("b.obj", sheet(10, 1)))),
              Not(HasSubstr("below others")));
}

TEST_F(ForeignFiles, AMeshWithYUpIsAskedAbout) {
  std::string text;
  for (int i = 0; i < 9; ++i) {
    text += "v " + std::to_string(10 * (i % 3)) + " " + std::to_string(-10 - 0.1 * i) + " " +
            std::to_string(-10 * (i / 3)) + "\n";
  }
  text += "f 1 2 5 4\nf 2 3 6 5\nf 4 5 8 7\nf 5 6 9 8\n";
  EXPECT_THAT([&] { (void)import_seafloor(write("a.obj", text)); },
              testing::ThrowsMessage<InvalidInput>(HasSubstr("looks y up")));
  EXPECT_THAT(warnings_of(import_seafloor(write("b.obj", sheet(10, 1)))),
              Not(Contains(HasSubstr("y up"))));
}

/// Scattered soundings, 8 to 12 m deep, in metres around 500000, 4000000.
std::string scattered_rows() {
  std::string text;
  for (int i = 0; i < 60; ++i) {
    const int x = i * 37 % 100;
    const int y = i * 61 % 97;
    text += std::to_string(500000 + x) + "." + std::to_string(i % 10) + " " +
            std::to_string(4000000 + y) + " -" + std::to_string(8 + i % 4) + ".5\n";
  }
  return text;
}

TEST_F(ForeignFiles, SoundingsAreReadUnderAnyExtension) {
  const ImportedSeafloor plain = import_seafloor(write("a.xyz", scattered_rows()));
  for (const char* name :
       {"a.asc", "a.ascii", "a.emo", "a.pnt", "a.sdp", "a.dat", "a.all", "a.gpx", "a.grd", "a"}) {
    const ImportedSeafloor r = import_seafloor(write(name, scattered_rows()));
    EXPECT_EQ(r.kind, "soundings") << name;
    EXPECT_EQ(r.seafloor.vertices, plain.seafloor.vertices) << name;
  }
}

TEST_F(ForeignFiles, SoundingsAcrossTheAntimeridianKeepTogether) {
  std::string rows = "lon,lat,depth\n";
  std::string bare;
  for (const char* lat : {"52.0000", "52.0001", "52.0002"}) {
    for (const char* lon : {"179.9994", "179.9996", "179.9998", "-180", "-179.9998", "-179.9996"}) {
      rows += std::string(lon) + "," + lat + ",8.5\n";
      bare += std::string(lon) + " " + lat + " -8.5\n";
    }
  }
  const ImportedSeafloor named = import_seafloor(write("a.csv", rows));
  const ImportedSeafloor by_crs = import_seafloor(write("a.xyz", bare), {.crs = "EPSG:4326"});
  for (const ImportedSeafloor* r : {&named, &by_crs}) {
    EXPECT_THAT(r->crs_name, testing::AnyOf(HasSubstr("zone 60N"), HasSubstr("zone 1N")));
    EXPECT_LT(extent(r->seafloor).size().x(), 100.0);
  }
}

TEST_F(ForeignFiles, DegreesAreSeenInBothOrders) {
  const std::string rows = "52.00 170.00 -8\n52.01 170.00 -9\n52.00 170.01 -8\n52.01 170.01 -8\n";
  const auto file = write("a.xyz", rows);
  EXPECT_THAT(refusal([&] { return import_seafloor(file); }),
              AllOf(HasSubstr("look like degrees"), HasSubstr("<columns>")));
  const ImportedSeafloor r = import_seafloor(file, {.crs = "EPSG:4326"});
  EXPECT_THAT(r.crs_name, HasSubstr("zone 59N"));
  // Spacing of half a degree: far too deep and too far from the origin for
  // metres.
  const auto coarse = write("b.xyz", "15 36 -900\n15.5 36 -950\n15 36.5 -950\n15.5 36.5 -900\n");
  EXPECT_THAT(refusal([&] { return import_seafloor(coarse); }), HasSubstr("look like degrees"));
}

TEST_F(ForeignFiles, UnitsOfColumnNamesScaleDepthsAndPlaces) {
  std::string rows;
  for (int i = 0; i < 16; ++i) {
    rows += std::to_string(10 * (i % 4)) + "," + std::to_string(10 * (i / 4)) + "," +
            std::to_string(30 + i) + "\n";
  }
  const auto file = write("a.csv", "x_ft,y_ft,depth_ft\n" + rows);
  const ImportedSeafloor r = import_seafloor(file);
  EXPECT_NEAR(depth_range(r.seafloor).max, 45 * 0.3048, 1e-9);
  EXPECT_NEAR(extent(r.seafloor).size().x(), 30 * 0.3048, 1e-9);
  EXPECT_NEAR(depth_range(import_seafloor(file, {.z_unit_m = 2.0}).seafloor).max, 90.0, 1e-9);
  EXPECT_NEAR(depth_range(import_seafloor(file, {.z_unit_m = 1.0}).seafloor).max, 45.0, 1e-9);
  const ImportedSeafloor chosen = import_seafloor(file, {.columns = "x=2,y=1,z=3"});
  EXPECT_NEAR(depth_range(chosen.seafloor).max, 45 * 0.3048, 1e-9);
  EXPECT_THROW((void)import_seafloor(file, {.columns = "x=1"}), UsageError);
}

TEST_F(ForeignFiles, CoordinatesTooLargeForMetresAreFeetAndSoAreDepths) {
  std::string rows;
  for (int i = 0; i < 16; ++i) {
    rows += std::to_string(3250000 + 25 * (i % 4)) + " " + std::to_string(13800000 + 25 * (i / 4)) +
            " -38\n";
  }
  const auto file = write("a.xyz", rows);
  constexpr double kUsFoot = 1200.0 / 3937.0;
  const ImportedSeafloor feet = import_seafloor(file);
  EXPECT_THAT(feet.warnings,
              Contains(AllOf(HasSubstr("US survey feet, and so was z"), HasSubstr("<z unit>"))));
  EXPECT_NEAR(depth_range(feet.seafloor).max, 38.0 * kUsFoot, 1e-9);
  EXPECT_NEAR(extent(feet.seafloor).size().x(), 75.0 * kUsFoot, 1e-6);
  const ImportedSeafloor metres = import_seafloor(file, {.z_unit_m = 1.0, .xy_unit_m = 1.0});
  EXPECT_THAT(metres.warnings, Not(Contains(HasSubstr("US survey feet"))));
  EXPECT_NEAR(depth_range(metres.seafloor).max, 38.0, 1e-9);
}

TEST_F(ForeignFiles, MeshesThatLookYUpAreAskedAbout) {
  const auto file = write("a.obj",
                          "v 0 -10 0\nv 100 -10 0\nv 100 -12 -100\nv 0 -12 -100\n"
                          "f 1 2 3\nf 1 3 4\n");
  EXPECT_THAT(refusal([&] { return import_seafloor(file); }),
              AllOf(HasSubstr("looks y up"), HasSubstr("<up> y")));
  const ImportedSeafloor turned = import_seafloor(file, {.up = ImportOptions::Up::y});
  EXPECT_NEAR(plan_area_m2(turned.seafloor), 10'000.0, 1e-6);
  EXPECT_NEAR(depth_range(turned.seafloor).max, 12.0, 1e-9);
  EXPECT_NEAR(extent(turned.seafloor).max.y(), 100.0, 1e-9);
  EXPECT_EQ(import_seafloor(file, {.up = ImportOptions::Up::z}).raw_z_min, -100.0);
}

TEST_F(ForeignFiles, StartsAndEndsInTheFilesOwnDegrees) {
  std::string rows = "lon,lat,depth\n";
  for (int i = 0; i < 25; ++i) {
    rows += std::to_string(12.5 + 0.0002 * (i % 5)) + "," +
            std::to_string(60.0 + 0.0001 * (i / 5)) + ",9\n";
  }
  const ImportedSeafloor r = import_seafloor(write("a.csv", rows));
  const Vec2 local = local_of(r, Vec2(12.5004, 60.0002));
  EXPECT_LT((local - 0.5 * (extent(r.seafloor).min + extent(r.seafloor).max)).norm(), 1.0);
  EXPECT_NEAR((in_file_of(r, local) - Vec2(12.5004, 60.0002)).norm(), 0.0, 1e-9);
  EXPECT_NEAR(r.convergence_deg, -2.165, 0.01);
  EXPECT_THAT(refusal([&] { return local_of(r, Vec2(361'000.0, 6'654'000.0)); }),
              HasSubstr("is in degrees"));
}

TEST_F(ForeignFiles, ReadableTextIsNeverCalledGarbled) {
  const auto says = [&](const std::string& text) {
    return refusal([&] { return import_seafloor(write("a.asc", text)); });
  };
  EXPECT_THAT(says(std::string("\xFF\xFE"
                               "1\0 \0",
                               6)),
              HasSubstr("UTF-16"));
  EXPECT_THAT(says("Read me first.\n"), AllOf(HasSubstr("line 1"), Not(HasSubstr("garbled"))));
}

TEST_F(ForeignFiles, AGridBehindAByteOrderMarkIsReadWithItsCrs) {
  const std::string grid =
      "ncols 3\nnrows 2\nxllcorner 500000\nyllcorner 4000000\ncellsize 10\n"
      "-5 -6 -7\n-5 -6 -8\n";
  write("plain.prj", parse_crs("EPSG:32633"));
  write("bom.prj", parse_crs("EPSG:32633"));
  const ImportedSeafloor plain = import_seafloor(write("plain.asc", grid));
  const ImportedSeafloor marked = import_seafloor(write("bom.asc", "\xEF\xBB\xBF" + grid));
  EXPECT_EQ(marked.seafloor.vertices, plain.seafloor.vertices);
  EXPECT_EQ(marked.crs_name, plain.crs_name);
  EXPECT_EQ(marked.raw_z_min, -8.0);
}

}  // namespace
}  // namespace swathplan
