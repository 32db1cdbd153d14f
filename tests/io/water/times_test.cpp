#include "io/water/times.h"

#include <gtest/gtest.h>

namespace swathplan {
namespace {

TEST(Times, AreReadWithZonesAndWrittenInUtc) {
  EXPECT_EQ(time_of("1970-01-01T00:00"), 0.0);
  EXPECT_EQ(time_of("2026-05-01 06:30:15Z"), time_of("2026-05-01T08:30:15+02:00"));
  EXPECT_EQ(time_of("2026-05-01T06:30-0130"), time_of("2026-05-01T08:00"));
  for (const char* text : {"", "06:30", "2026-13-01T00:00", "2026-02-30T00:00", "2026-05-01",
                           "2026-05-01T25:00", "2026-05-01T06:30 CET", "01.05.2026 06:30"}) {
    EXPECT_FALSE(time_of(text)) << text;
  }
  for (const char* text :
       {"2026-05-01T06:30:15Z", "1969-12-31T23:59:59Z", "2024-02-29T00:00:00Z"}) {
    EXPECT_EQ(time_text(*time_of(text)), text);
  }
}

}  // namespace
}  // namespace swathplan
