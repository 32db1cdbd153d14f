#include "io/exports/line_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/sample_route.h"

namespace swathplan {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

TEST(LineTable, HasARowALine) {
  const std::string table = line_table(test::lawnmower(2), {});
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 3);
  EXPECT_THAT(table, HasSubstr(",line,1,20.000,0.000,20.000,100.000,,,,,0,100.000,60,60,2\r\n"));
  EXPECT_THAT(table, EndsWith(",line,1,40.000,100.000,40.000,0.000,,,,,180,100.000,60,60,2\r\n"));
}

TEST(LineTable, DividesALineWhereItsFanOrSpeedChanges) {
  Route route = test::lawnmower(1);
  for (std::size_t i = 100; i < route.waypoints.size(); ++i) {
    route.waypoints[i].fan = FanAngles{Angle::degrees(45.5), Angle::degrees(50)};
    route.waypoints[i].speed_mps = 1.8;
  }
  const std::string table = line_table(route, {});
  EXPECT_THAT(table, HasSubstr(",line,1,20.000,0.000,20.000,50.000,,,,,0,50.000,60,60,2\r\n"));
  EXPECT_THAT(table, EndsWith(",line,2,20.000,50.000,20.000,100.000,,,,,0,50.000,45.5,50,1.8\r\n"));
}

}  // namespace
}  // namespace swathplan
