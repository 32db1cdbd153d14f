#include "io/water/legs_csv.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/sample_route.h"

namespace swathplan {
namespace {

using testing::HasSubstr;

TEST(LegsCsv, HasARowALeg) {
  const Route route = test::lawnmower(2);
  std::vector<LegWater> water(2);
  water[0] = {legs(route)[0], 0.0, 50.0, 3.25, 2.25, false, {{0.0, 60.0}, {120.0, 180.0}}};
  water[1] = {legs(route)[1], 50.0, 71.5, std::nullopt, std::nullopt, std::nullopt, {}};
  const std::string text = legs_csv(route, water, 3600.0);
  EXPECT_THAT(text, HasSubstr("\r\n1,1,line,0.0,50.0,1970-01-01T01:00:00Z,1970-01-01T01:00:50Z,"
                              "3.25,2.25,0,1970-01-01T00:00:00Z/1970-01-01T00:01:00Z "
                              "1970-01-01T00:02:00Z/1970-01-01T00:03:00Z\r\n"));
  EXPECT_THAT(text, HasSubstr("\r\n2,,turn,50.0,71.5,"));
  EXPECT_THAT(legs_csv(route, water, std::nullopt), HasSubstr("\r\n1,1,line,0.0,50.0,,,3.25"));
}

}  // namespace
}  // namespace swathplan
