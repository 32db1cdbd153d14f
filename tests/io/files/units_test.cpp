#include "io/files/units.h"

#include <gtest/gtest.h>

namespace swathplan {
namespace {

TEST(Units, AreKnownByTheNamesThatFilesUse) {
  EXPECT_EQ(metres_in("m"), 1.0);
  EXPECT_EQ(metres_in("Metre"), 1.0);
  EXPECT_EQ(metres_in(" feet "), 0.3048);
  EXPECT_EQ(metres_in("US_survey_foot"), 1200.0 / 3937.0);
  EXPECT_EQ(metres_in("fathoms"), 1.8288);
  EXPECT_EQ(metres_in("mile"), 1609.344);
  EXPECT_EQ(metres_in("mm"), 0.001);
  EXPECT_FALSE(metres_in(""));
  EXPECT_FALSE(metres_in("m/s"));
}

TEST(Units, NamesOfColumnsSayWhatACoordinateCountsIn) {
  EXPECT_EQ(unit_mark(1.0), "m");
  EXPECT_EQ(unit_mark(0.3048), "ft");
  EXPECT_EQ(unit_mark(0.3048006096), "us_ft");
  EXPECT_EQ(unit_mark(1000.0), "crs");
  EXPECT_EQ(metres_of_mark("us_ft"), 1200.0 / 3937.0);
  EXPECT_EQ(metres_of_mark("crs"), std::nullopt);
}

}  // namespace
}  // namespace swathplan
