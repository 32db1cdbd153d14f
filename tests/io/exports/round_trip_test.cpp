#include <gtest/gtest.h>

#include "io/exports/exported.h"
#include "io/route/read_route.h"

namespace swathplan {
namespace {

const RouteDefaults kRoundTripFan{.fan = FanAngles{Angle::degrees(60.0), Angle::degrees(60.0)},
                                  .speed_mps = 0.25};

ImportedRoute read_back(const test::Exported& exported) {
  return read_route(exported.file(), exported.frame, kRoundTripFan);
}

bool holds_lines_only(ExportFormat format) {
  return format == ExportFormat::lnw || format == ExportFormat::rln ||
         format == ExportFormat::asciiplan;
}

/// The tolerance that routes are exported with and a millimetre of rounding.
constexpr double kWithin = 0.101;

TEST(RoundTrip, EveryFormatComesBackWithinItsRounding) {
  for (const ExportFormat format : all_export_formats()) {
    SCOPED_TRACE(name(format));
    const test::Exported exported(format);
    const ImportedRoute back = read_back(exported);
    EXPECT_EQ(back.route.waypoints.size(), exported.done.waypoints);
    if (holds_lines_only(format)) continue;
    EXPECT_LE(test::largest_distance(exported.route, positions(back.route.waypoints)), kWithin);
    EXPECT_NEAR(length_m(back.route), length_m(exported.route), 0.5);
  }
}

TEST(RoundTrip, PlannedLinesComeBackWhereTheyWere) {
  for (const ExportFormat format :
       {ExportFormat::lnw, ExportFormat::rln, ExportFormat::asciiplan}) {
    SCOPED_TRACE(name(format));
    const test::Exported exported(format);
    const ImportedRoute back = read_back(exported);
    ASSERT_EQ(back.route.waypoints.size(), 6U);
    for (std::size_t i = 0; i < 6; i += 2) {
      const Waypoint& w = back.route.waypoints[i];
      EXPECT_EQ(w.line, static_cast<int>(i / 2 + 1));
      EXPECT_NEAR(w.position.x(), 20.0 * (static_cast<double>(i) / 2 + 1), 2e-3);
      EXPECT_NEAR((back.route.waypoints[i + 1].position - w.position).norm(), 100.0, 3e-3);
    }
  }
}

TEST(RoundTrip, KindsComeBackWhereTheFormatNamesThem) {
  for (const ExportFormat format : {ExportFormat::gpx, ExportFormat::rtz, ExportFormat::kml,
                                    ExportFormat::dxf, ExportFormat::gpkg}) {
    SCOPED_TRACE(name(format));
    const test::Exported exported(format);
    const ImportedRoute back = read_back(exported);
    const auto planned = legs(exported.route);
    const auto read = legs(back.route);
    ASSERT_EQ(read.size(), planned.size());
    for (std::size_t i = 0; i < read.size(); ++i) {
      const Waypoint& w = exported.route.waypoints[planned[i].first];
      const Waypoint& r = back.route.waypoints[read[i].first];
      EXPECT_EQ(r.kind, w.kind) << i;
      EXPECT_EQ(r.log, w.log) << i;
      if (format != ExportFormat::dxf) {
        EXPECT_EQ(r.line, w.line) << i;
      }
    }
  }
}

TEST(RoundTrip, SpeedsComeBackWhereTheFormatHoldsThem) {
  for (const ExportFormat format :
       {ExportFormat::waypoints, ExportFormat::plan, ExportFormat::rtz}) {
    SCOPED_TRACE(name(format));
    const test::Exported exported(format);
    const ImportedRoute back = read_back(exported);
    EXPECT_NEAR(back.route.waypoints[0].speed_mps, 2.0, 1e-3);
    EXPECT_NEAR(back.route.waypoints[1].speed_mps, 1.5, 1e-3) << "the first leg of the turn";
  }
}

}  // namespace
}  // namespace swathplan
