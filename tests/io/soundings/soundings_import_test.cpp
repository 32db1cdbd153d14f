#include "io/soundings/soundings_import.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "io/files/crs.h"
#include "io/import_files.h"
#include "io/seafloor/surface_area.h"

namespace swathplan {
namespace {

using testing::HasSubstr;
using SoundingsImport = ImportFiles;

const std::vector<Vec3> kThree = {Vec3(500000.125, 6000000.5, -5.25), Vec3(500010.5, 6000001, -6),
                                  Vec3(500003, 6000009, -7)};

TEST_F(SoundingsImport, ReadsEveryCommonWayToWriteRows) {
  const std::vector<std::string> files = {
      "500000.125 6000000.5 -5.25\n500010.5 6000001 -6\n500003 6000009 -7\n",
      "# made by hand\r\n500000.125\t6000000.5\t-5.25\r\n500010.5\t6000001\t-6\r\n500003\t6000009"
      "\t-7",
      "500000.125,6000000.5,-5.25,9\n\n500010.5,6000001,-6,9\n500003,6000009,-7,9\n",
      "500000,125;6000000,5;-5,25\n500010,5;6000001;-6\n500003;6000009;-7\n",
      "500000,125 6000000,5 -5,25\n500010,5 6000001 -6\n500003 6000009 -7\n",
      "\xEF\xBB\xBFid,\"Northing (m)\",Easting,elevation\n1,6000000.5,500000.125,-5.25\n"
      "2,6000001,500010.5,-6\n3,6000009,500003,-7\n",
      "// x y z\n  500000.125   6000000.5   -5.25\n500010.5 6000001 -6\n500003 6000009 -7\n",
      "# z y x\n-5.25 6000000.5 500000.125\n-6 6000001 500010.5\n-7 6000009 500003\n",
  };
  for (const std::string& text : files) {
    const SurfaceData data = read_soundings(write("a.xyz", text));
    EXPECT_EQ(data.vertices, kThree) << text;
    EXPECT_FALSE(data.z_is_depth);
    EXPECT_TRUE(data.crs_wkt.empty());
  }
}

TEST_F(SoundingsImport, ColumnNamesTellDepthAndDegrees) {
  const SurfaceData data =
      read_soundings(write("a.csv", "lat_deg,lon_deg,depth_m\n55,10,5\n55.1,10,6\n55,10.1,7\n"));
  EXPECT_TRUE(data.z_is_depth);
  EXPECT_EQ(crs_name(data.crs_wkt), "EPSG:4326 (WGS 84)");
  EXPECT_EQ(data.vertices[1], Vec3(10, 55.1, 6));
  const SurfaceData up = read_soundings(write("b.csv", "x,y,depth\n0,0,-5\n7,1,-6\n3,9,-7\n"));
  EXPECT_FALSE(up.z_is_depth);
  EXPECT_THAT(up.notes, testing::Contains(HasSubstr("no positive value")));
}

TEST_F(SoundingsImport, ShoalestOfOnePlaceIsKept) {
  const std::string rows = "0 0 -5\n7 1 -6\n0 0 -3\n3 9 -7\n0 0 -4\n";
  const SurfaceData up = read_soundings(write("a.xyz", rows));
  ASSERT_EQ(up.vertices.size(), 3U);
  EXPECT_THAT(up.vertices, testing::Contains(Vec3(0, 0, -3)));
  EXPECT_THAT(up.notes, testing::Contains(HasSubstr("2 soundings")));
  const SurfaceData down =
      read_soundings(write("b.xyz", "0 0 5\n7 1 6\n0 0 3\n3 9 7\n"), {.z_positive_down = true});
  EXPECT_THAT(down.vertices, testing::Contains(Vec3(0, 0, 3)));
}

TEST_F(SoundingsImport, RegularRowsAreAGrid) {
  std::string rows;
  for (int j = 0; j < 30; ++j) {
    for (int i = 39; i >= 0; --i) {
      if (i == 20 && j == 10) continue;  // one node is missing: four cells without seafloor
      rows += fmt::format("{:.3f} {:.3f} {:.2f}\n", 500000.1 + i / 3.0, 6000000.2 + j / 3.0, -5.0);
    }
  }
  const SurfaceData data = read_soundings(write("a.xyz", rows));
  EXPECT_TRUE(data.is_clean);
  EXPECT_TRUE(test::all_faces_look_up(data));
  EXPECT_EQ(data.faces.size(), 2U * (39 * 29 - 4));
  EXPECT_NEAR(data.spacing, 1.0 / 3.0, 1e-3);
  EXPECT_NEAR(test::plan_area(data), (39 * 29 - 4) / 9.0, 0.01);
}

TEST_F(SoundingsImport, RefusesWhatMakesNoSurface) {
  const auto says = [&](std::string_view rows) {
    return refusal([&] { return read_soundings(write("a.xyz", rows)); });
  };
  EXPECT_THAT(says("0 0 -1\n1 1 -1\n"), HasSubstr("2 soundings"));
  EXPECT_THAT(says("0 0 -1\n1 1 -1\n2 x -1\n5 5 5\n"), HasSubstr("line 3: '2 x -1'"));
  EXPECT_THAT(says("0 0 -1\n1 1\n"), HasSubstr("line 2"));
  EXPECT_THAT(says("0 0 -1\n1 1 nan\n2 0 -1\n"), HasSubstr("2 soundings"));
  EXPECT_THAT(says("0 0 -1\n1 1 inf\n2 0 -1\n"), HasSubstr("not finite"));
  EXPECT_THAT(says("0 0 -1\n1 inf -1\n2 0 -1\n"), HasSubstr("line 2"));
  SurfaceData line;
  line.vertices = {Vec3(0, 0, -1), Vec3(1, 1, -1), Vec3(2, 2, -1)};
  EXPECT_THAT(refusal([&] { return join_soundings(line, {}); }), HasSubstr("straight line"));
  SurfaceData wide;
  wide.vertices = kThree;
  EXPECT_THAT(refusal([&] { return join_soundings(wide, 0.5); }), HasSubstr("<longest edge>"));
}

/// Soundings of 4 x 3 places 10 m apart, as a template of rows.
template <class Row>
std::string places(Row row) {
  std::string text;
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 4; ++i) text += row(i, j);
  }
  return text;
}

std::string xyz_rows() {
  return places([](int i, int j) {
    return fmt::format("{} {} {:.1f}\n", 500000 + 10 * i, 4000000 + 10 * j, -8.0 - 0.3 * i - j);
  });
}

TEST_F(SoundingsImport, NamesOfOtherProgramsAreKnown) {
  const auto first = [&](const std::string& header, const std::string& row) {
    const std::string rows = places(
        [&](int i, int j) { return fmt::format(fmt::runtime(row), i, j, 8.0 + i + j) + "\n"; });
    return read_soundings(write("a.csv", header + "\n" + rows));
  };
  const SurfaceData gis = first("OBJECTID,X_coord,Y_coord,Z_m", "{0},5{0}1,4{1}2,-{2:.1f}");
  EXPECT_EQ(gis.vertices[0], Vec3(501, 402, -8));
  EXPECT_FALSE(gis.z_is_depth);
  EXPECT_THAT(gis.notes, testing::Contains(HasSubstr("x is 'X_coord' (column 2)")));
  const SurfaceData esri = first("FID,POINT_X,POINT_Y,DEPTH", "{0},5{0}1,4{1}2,{2:.1f}");
  EXPECT_EQ(esri.vertices[0], Vec3(501, 402, 8));
  EXPECT_TRUE(esri.z_is_depth);
  const SurfaceData ogr = first("X,Y,RCID,DEPTH", "5{0}1,4{1}2,{0},{2:.1f}");
  EXPECT_EQ(ogr.vertices[0], Vec3(501, 402, 8));
  const SurfaceData nos =
      first("survey_id,lat,long,depth,quality_code,active", "H1,36.1{1},-75.{0},{2:.1f},1,1");
  EXPECT_EQ(nos.vertices[1], Vec3(-75.1, 36.1, 9));
  EXPECT_FALSE(nos.crs_wkt.empty());
  const SurfaceData quoted = first("name,lon,lat,depth", "\"Buoy, red\",15.{0},36.{1},{2:.1f}");
  EXPECT_EQ(quoted.vertices[1], Vec3(15.1, 36, 9));
}

TEST_F(SoundingsImport, DepthGoesBeforeAltitudeAndTheChoiceIsSaid) {
  const std::string rows = places([](int i, int j) {
    return fmt::format("12:00:0{},36.10{},15.00{},-1.{},{:.1f}\n", i, j, i, i, 8 + 0.3 * i + j);
  });
  const SurfaceData data =
      read_soundings(write("a.csv", "time,latitude,longitude,altitude,depth\n" + rows));
  EXPECT_EQ(data.vertices[0], Vec3(15, 36.1, 8));
  EXPECT_TRUE(data.z_is_depth);
  EXPECT_THAT(data.notes, testing::Contains(testing::AllOf(HasSubstr("'depth' (column 5)"),
                                                           HasSubstr("'altitude' not used"))));
}

TEST_F(SoundingsImport, UnitsOfTheHeaderCount) {
  const std::string rows =
      places([](int i, int j) { return fmt::format("{},{},{}\n", 10 * i, 10 * j, 30.0 + i + j); });
  const double us_foot = 1200.0 / 3937.0;
  const std::vector<std::pair<std::string, double>> headers = {
      {"x,y,Depth (ft)", 0.3048},       {"x,y,depth_ft", 0.3048},
      {"x,y,Depth_in_Feet", 0.3048},    {"x,y,Depth (US survey feet)", us_foot},
      {"x,y,depth_us-ft", us_foot},     {"X,Y,Z [fathoms]", 1.8288},
      {"x,y,Depth (ft, MLLW)", 0.3048}, {"x,y,depthft", 0.3048},
      {"x,y,depth\nm,m,ft", 0.3048},    {"x,y,Sounding_cm", 0.01}};
  for (const auto& [header, unit_m] : headers) {
    const SurfaceData data = read_soundings(write("a.csv", header + "\n" + rows));
    EXPECT_EQ(data.z_unit_m, std::optional<double>(unit_m)) << header;
    EXPECT_THAT(data.notes, testing::Contains(HasSubstr("converted"))) << header;
  }
  EXPECT_EQ(read_soundings(write("a.csv", "x_ft,y_ft,depth\n" + rows)).xy_unit_m, 0.3048);
  const SurfaceData given =
      read_soundings(write("a.csv", "x,y,depth_ft\n" + rows), {.z_unit_is_given = true});
  EXPECT_FALSE(given.z_unit_m);
  EXPECT_THAT(given.notes, testing::Contains(HasSubstr("given unit")));
}

TEST_F(SoundingsImport, ColumnsThatAreNotClearAreAskedFor) {
  const auto says = [&](const std::string& text) {
    return refusal([&] { return read_soundings(write("a.csv", text)); });
  };
  const auto asks = testing::AllOf(HasSubstr("<columns>"), HasSubstr("line "));
  EXPECT_THAT(says("foo,bar,baz\n0,0,-5\n7,1,-6\n3,9,-7\n"),
              testing::AllOf(asks, HasSubstr("'foo', 'bar', 'baz'")));
  EXPECT_THAT(says("lat_deg,lat_min,lon_deg,lon_min,depth\n36,6,15,1,8\n36,7,"
                   "15,1,8\n36,6,15,2,8\n"),
              asks);
  EXPECT_THAT(says("date x y z\n2010 1 13 5 5 -8\n2010 1 13 6 5 -8\n2010 1 13 5 7 -8\n"), asks);
  EXPECT_THAT(says("1,4000000.0,500000.0,-8.2,GS\n2,4000000.0,500010.0,-8.4,GS\n"
                   "3,4000010.0,500000.0,-8.1,GS\n4,4000010.0,500010.0,-8.0,GS\n"),
              testing::AllOf(asks, HasSubstr("numbers of points")));
  EXPECT_THAT(says("7 10.5 20 -8\n3 11.5 20 -9\n5 10.5 21 -8\n"), asks);
  EXPECT_THAT(says("2010 1 13 7 0 0 -37.0 -73.5 -8.0 1 2\n2010 1 13 7 1 1 -37.0 -73.4 -8.3 1 2\n"
                   "2010 1 14 7 1 1 -37.1 -73.4 -8.3 1 3\n"),
              testing::AllOf(asks, HasSubstr("date")));
  EXPECT_THAT(says("lat lon depth\n33 51 12.00 18 25 5.00 8.0\n33 51 15.50 18 25 7.00 8.3\n"
                   "33 52 15.00 18 26 7.00 8.3\n"),
              HasSubstr("degrees, minutes and seconds"));
  EXPECT_THAT(says("15.0;36.1;;;8.0;0.1;7\n15.1;36.1;;;8.3;0.1;7\n15.0;36.2;;;"
                   "8.2;0.1;7\n"),
              asks);
  EXPECT_THAT(says("5 6 0 -8.5\n6 6 0 -8.4\n5 7 0 -8.1\n"), asks);
  EXPECT_THAT(says("-5.0 -5.1 -5.2 -5.3\n-5.0 -5.1 -5.2 -5.3\n-5.5 -5.6 -5.7 -5.8\n"),
              HasSubstr("bare matrix"));
  EXPECT_THAT(says("All rights reserved.\nNo soundings here.\n"),
              testing::AllOf(HasSubstr("line 1"), testing::Not(HasSubstr("garbled"))));
}

TEST_F(SoundingsImport, MoreColumnsBehindXyzAreLeftAside) {
  std::string text;
  for (const Vec3& v : kThree) text += fmt::format("{},{},{},7,text\n", v.x(), v.y(), v.z());
  const SurfaceData data = read_soundings(write("a.csv", text));
  EXPECT_EQ(data.vertices, kThree);
  EXPECT_THAT(data.notes, testing::Contains(HasSubstr("<columns>")));
}

TEST_F(SoundingsImport, ColumnsCanBeChosen) {
  const std::string rows =
      "1,4000000,500000,9,-8.2\n2,4000000,500010,9,-8.4\n"
      "3,4000011,500003,9,-8.1\n";
  const SurfaceData number = read_soundings(write("a.csv", rows), {.columns = "x=3,y=2,z=5"});
  EXPECT_EQ(number.vertices[0], Vec3(500000, 4000000, -8.2));
  EXPECT_THAT(number.notes, testing::Contains(HasSubstr("x is column 3")));
  const SurfaceData named = read_soundings(write("a.csv", "a,b,c,d,Depth ft\n" + rows),
                                           {.columns = "x=c,y=B,z=depth_ft"});
  EXPECT_EQ(named.vertices[0], Vec3(500000, 4000000, -8.2));
  EXPECT_EQ(named.z_unit_m, 0.3048);
  EXPECT_THAT(refusal([&] {
                return read_soundings(write("a.csv", "a,b,c,d,e\n" + rows),
                                      {.columns = "x=c,y=b,z=f"});
              }),
              HasSubstr("no column 'f'"));
  EXPECT_THAT(
      refusal([&] { return read_soundings(write("a.csv", rows), {.columns = "x=c,y=b,z=f"}); }),
      HasSubstr("by number"));
  EXPECT_THAT(
      refusal([&] { return read_soundings(write("a.csv", rows), {.columns = "x=3,y=2,z=9"}); }),
      HasSubstr("no column 9"));
}

TEST_F(SoundingsImport, StrayLinesAreSkippedAndCounted) {
  const SurfaceData plain = read_soundings(write("a.xyz", xyz_rows()));
  const std::vector<std::string> strays = {"Harbour, north\n", "x y z\n", "500050 4000000 NaN\n",
                                           "> segment 2\n", "m m m\n"};
  for (const std::string& stray : strays) {
    std::string text = xyz_rows();
    text.insert(text.find('\n', 60) + 1, stray);
    const SurfaceData data = read_soundings(write("a.xyz", text));
    EXPECT_EQ(data.vertices, plain.vertices) << stray;
    EXPECT_THAT(data.notes, testing::Contains(HasSubstr("skipped"))) << stray;
  }
  const SurfaceData titled = read_soundings(write("a.xyz", "Survey of May\nx y z\n" + xyz_rows()));
  EXPECT_EQ(titled.vertices, plain.vertices);
  EXPECT_THAT(titled.notes, testing::Contains(HasSubstr("1 line that holds no sounding")));
  std::string many = xyz_rows();
  for (int i = 0; i < 9; ++i) many += "label\n";
  EXPECT_THAT(refusal([&] { return read_soundings(write("a.xyz", many)); }), HasSubstr("line 13"));
}

TEST_F(SoundingsImport, LinesMayEndWithCarriageReturns) {
  std::string text = xyz_rows();
  std::replace(text.begin(), text.end(), '\n', '\r');
  EXPECT_EQ(read_soundings(write("a.xyz", text)).vertices,
            read_soundings(write("b.xyz", xyz_rows())).vertices);
}

TEST_F(SoundingsImport, AnglesWithHemispheresAreDegrees) {
  const std::string rows = "33:51:00S,18:25:30E,8\n33:51:36S,18:25:30E,9\n33:51:00S,18:27:00E,8\n";
  const SurfaceData data = read_soundings(write("a.csv", "lat,lon,depth\n" + rows));
  EXPECT_NEAR(data.vertices[0].x(), 18.425, 1e-12);
  EXPECT_NEAR(data.vertices[0].y(), -33.85, 1e-12);
  EXPECT_THAT(refusal([&] { return read_soundings(write("a.csv", "lon,lat,depth\n" + rows)); }),
              HasSubstr("line 2"));
}

TEST_F(SoundingsImport, LatitudesStayWithinNinetyAndLongitudesTogether) {
  const SurfaceData swapped =
      read_soundings(write("a.csv", "lon,lat,depth\n52,170,8\n52.1,170,9\n52,170.1,8\n"));
  EXPECT_EQ(swapped.vertices[0], Vec3(170, 52, 8));
  EXPECT_THAT(swapped.notes, testing::Contains(HasSubstr("beyond 90")));
  const SurfaceData pacific = read_soundings(
      write("a.csv", "lon,lat,depth\n179.9994,52,8\n-179.9994,52,9\n179.9994,52.001,8\n"));
  EXPECT_NEAR(pacific.vertices[1].x(), 180.0006, 1e-9);
}

TEST_F(SoundingsImport, UndeclaredFillValuesAreNoDepths) {
  const SurfaceData data = read_soundings(write("a.xyz", xyz_rows() + "500050 4000000 -9999\n"));
  EXPECT_EQ(data.vertices.size(), 12U);
  EXPECT_THAT(data.warnings, testing::Contains(HasSubstr("-9999")));
}

TEST_F(SoundingsImport, CoordinatesBeyondAnyMapAreRefused) {
  EXPECT_THAT(refusal([&] {
                return read_soundings(write("a.xyz", "0 0 -12\n5e300 0 -14\n0 5e300 -12\n"));
              }),
              testing::AllOf(HasSubstr("line 2"), HasSubstr("no map has")));
  SurfaceData wide;
  wide.vertices = {Vec3(9e307, 1e308, -5), Vec3(6e307, 1e308, -5), Vec3(1.5e308, -1.5e308, -5)};
  EXPECT_THAT(refusal([&] { return join_soundings(wide, {}); }), HasSubstr("no map has"));
}

TEST_F(SoundingsImport, AnglesInPartsAreDegreesAndTheLatitudeComesFirst) {
  const std::string rows =
      "33 51 12.00 -18 25 5.00 8.0\n33 51 15.00 -18 25 5.00 8.3\n33 51 12.00 -18 25 7.20 8.6\n";
  const SurfaceData data = read_soundings(write("dms.xyz", rows));
  ASSERT_EQ(data.vertices.size(), 3U);
  EXPECT_NEAR(data.vertices[0].x(), -(18.0 + 25.0 / 60.0 + 5.0 / 3600.0), 1e-9);
  EXPECT_NEAR(data.vertices[0].y(), 33.0 + 51.0 / 60.0 + 12.0 / 3600.0, 1e-9);
  EXPECT_EQ(data.vertices[1].z(), 8.3);
  EXPECT_FALSE(data.crs_wkt.empty());
  ASSERT_EQ(data.warnings.size(), 1U);
  EXPECT_THAT(data.warnings[0],
              testing::AllOf(HasSubstr("columns 1 to 3 are the latitude and 4 to 6 the longitude"),
                             HasSubstr("lon=1,lat=4,z=7")));
  SoundingsOptions chosen;
  chosen.columns = "lon=1,lat=4,z=7";
  const SurfaceData other = read_soundings(write("dms.xyz", rows), chosen);
  EXPECT_NEAR(other.vertices[0].x(), data.vertices[0].y(), 1e-12);
  EXPECT_NEAR(other.vertices[0].y(), data.vertices[0].x(), 1e-12);
  EXPECT_TRUE(other.warnings.empty());
  const SurfaceData minutes = read_soundings(
      write("dm.xyz", "33;51,2;18;25,5;8,0\n33;51,3;18;25,5;8,3\n33;51,2;18;25,6;8,6\n"));
  EXPECT_NEAR(minutes.vertices[0].y(), 33.0 + 51.2 / 60.0, 1e-9);
  EXPECT_THAT(
      refusal([&] { return read_soundings(write("short.xyz", rows + "33 51 12 -18 25 8.0\n")); }),
      HasSubstr("line 4"));
}

TEST_F(SoundingsImport, ADateBeforeThreeColumnsIsPassedOver) {
  const SurfaceData metres =
      read_soundings(write("log.txt",
                           "2010 1 13 500000.5 4000000 -8.0\n2010 1 13 500010.5 4000000 -8.3\n"
                           "2010 1 14 500000.5 4000010 -8.6\n"));
  ASSERT_EQ(metres.vertices.size(), 3U);
  EXPECT_EQ(metres.vertices[0], Vec3(500000.5, 4000000.0, -8.0));
  EXPECT_TRUE(metres.crs_wkt.empty());
  EXPECT_TRUE(metres.warnings.empty());
  const SurfaceData degrees =
      read_soundings(write("log.txt",
                           "2010 1 13 7 0 0 -37.0 -73.5 -8.0\n2010 1 13 7 1 1 -37.0 -73.4 -8.3\n"
                           "2010 1 14 7 1 1 -37.1 -73.4 -8.3\n"));
  EXPECT_EQ(degrees.vertices[0], Vec3(-73.5, -37.0, -8.0));
  EXPECT_FALSE(degrees.crs_wkt.empty());
  ASSERT_EQ(degrees.warnings.size(), 1U);
  EXPECT_THAT(degrees.warnings[0],
              testing::AllOf(HasSubstr("latitude and longitude"), HasSubstr("lon=7,lat=8,z=9")));
}

}  // namespace
}  // namespace swathplan
