#include "io/exports/exportable_route.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "io/files/atomic_file.h"
#include "io/files/lonlat.h"
#include "io/route/read_route.h"
#include "io/route/route_csv.h"
#include "io/route/route_geojson.h"
#include "io/sample_plan.h"
#include "io/sample_route.h"
#include "mesh/base/error.h"
#include "temporary_folder.h"

namespace swathplan {
namespace {

void expect_lonlat(const PlacedRoute& placed, const Route& route, const Frame& frame) {
  const auto read = LonLat(placed.frame).from_local(positions(placed.route.waypoints));
  const auto planned = LonLat(frame).from_local(positions(route.waypoints));
  ASSERT_EQ(read.size(), planned.size());
  for (std::size_t i = 0; i < read.size(); ++i) EXPECT_LT((read[i] - planned[i]).norm(), 2e-9) << i;
}

struct Files {
  test::TemporaryFolder folder;
  Route route = test::lawnmower(2);
  Frame frame = test::utm_frame();

  [[nodiscard]] std::filesystem::path csv(const Frame& in) const {
    write_route_csv(folder.path() / "route.csv", route, in);
    return folder.path() / "route.csv";
  }
};

TEST(ExportableRoute, OurCsvSaysAllItself) {
  const Files files;
  const ExportableRoute read = read_exportable_route(files.csv(files.frame), "");
  expect_lonlat(read.geographic, files.route, files.frame);
  EXPECT_LT((read.planar.frame.to_file(read.planar.route.waypoints[5].position) -
             files.frame.to_file(files.route.waypoints[5].position))
                .norm(),
            1e-5);
  EXPECT_TRUE(read.notes.empty());
  EXPECT_EQ(legs(read.geographic.route).size(), legs(files.route).size());
}

TEST(ExportableRoute, MetresNeedACrsForDegrees) {
  const Files files;
  Frame local = files.frame;
  local.crs_wkt.clear();
  const auto csv = files.csv(local);
  EXPECT_TRUE(read_exportable_route(csv, "").geographic.frame.crs_wkt.empty());
  expect_lonlat(read_exportable_route(csv, files.frame.crs_wkt).geographic, files.route,
                files.frame);
  EXPECT_THROW((void)read_exportable_route(csv, wgs84_crs()), UsageError);
}

TEST(ExportableRoute, AnotherCrsThanThatOfTheFileIsRefused) {
  const Files files;
  const auto csv = files.csv(files.frame);
  EXPECT_NO_THROW((void)read_exportable_route(csv, files.frame.crs_wkt));
  try {
    (void)read_exportable_route(csv, parse_crs("EPSG:32632"));
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("<CRS>"));
  }
}

TEST(ExportableRoute, GeoJsonIsInDegreesUnlessItSaysOtherwise) {
  const Files files;
  const auto geojson = write_route_geojson(files.folder.path(), files.route, files.frame);
  const ExportableRoute read = read_exportable_route(geojson, "");
  expect_lonlat(read.geographic, files.route, files.frame);
  EXPECT_EQ(read.notes.size(), 1U) << "which eastings those are";
  Frame local = files.frame;
  local.crs_wkt.clear();
  const auto metres = write_route_geojson(files.folder.path(), files.route, local);
  EXPECT_TRUE(read_exportable_route(metres, "").geographic.frame.crs_wkt.empty());
}

TEST(ExportableRoute, CsvOfOthersMayLackFans) {
  const Files files;
  write_text_atomically(files.folder.path() / "lines.csv", "x,y\n0,0\n50,0\n");
  const ExportableRoute read = read_exportable_route(files.folder.path() / "lines.csv", "");
  EXPECT_EQ(read.planar.route.waypoints.size(), 2U);
  for (const std::string& note : read.notes) EXPECT_EQ(note.find(" fan"), std::string::npos);
}

TEST(ExportableRoute, DropsTheNoteOnFansAndKeepsAllOthers) {
  const Files files;
  const std::filesystem::path path = files.folder.path() / "lines.csv";
  write_text_atomically(path, "x,y,kind\n0,0,line\n50,0,line\n");
  const RouteDefaults defaults{.fan = FanAngles{Angle::degrees(60), Angle::degrees(60)}};
  const ImportedRoute imported = read_route(path, {}, defaults);
  EXPECT_TRUE(imported.fan_note.has_value());
  ASSERT_EQ(imported.leg_notes.size(), 1U);  // no speed
  ASSERT_EQ(imported.notes.size(), 1U);      // the last row is no end
  EXPECT_EQ(read_exportable_route(path, "").notes,
            (std::vector{imported.leg_notes[0], imported.notes[0]}));
}

}  // namespace
}  // namespace swathplan
