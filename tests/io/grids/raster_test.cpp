#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "io/grids/raster_internal.h"

namespace swathplan {
namespace {

using testing::Contains;
using testing::HasSubstr;

Raster raster(const std::vector<double>& values) {
  Raster r;
  r.columns = values.size() / 2;
  r.rows = 2;
  r.transform = {0, 1, 0, 2, 0, -1};
  r.raw = values;
  return r;
}

/// How many cells are left as data, and the warnings.
std::pair<std::size_t, std::vector<std::string>> left(const std::vector<double>& values) {
  Raster r = raster(values);
  std::vector<std::string> warnings;
  drop_undeclared_nodata(r, warnings);
  const auto count =
      std::count_if(r.raw.begin(), r.raw.end(), [&](double v) { return !r.is_nodata(v); });
  return {static_cast<std::size_t>(count), warnings};
}

TEST(Raster, UndeclaredNodataIsDroppedWithAWarning) {
  for (const double value : {-9999.0, 9999.0, -99999.0, -32768.0, 32767.0, 1e6, 1e20, 3.4028235e38,
                             -3.4028234663852886e38, 9.969209968386869e36, -999.0}) {
    const auto [count, warnings] = left({-8, -9, -10, -11, value, value});
    EXPECT_EQ(count, 4U) << value;
    ASSERT_EQ(warnings.size(), 1U) << value;
    EXPECT_THAT(warnings[0], HasSubstr("2 of 6 cells hold"));
  }
}

TEST(Raster, ValuesAmongOthersStay) {
  EXPECT_EQ(left({-8000, -9998, -9999, -10500, -10000, -9000}).first, 6U);
  EXPECT_TRUE(left({-8000, -9998, -9999, -10500, -10000, -9000}).second.empty());
  EXPECT_EQ(left({-900, -950, -999, -1100, -1000, -1005}).first, 6U);
  EXPECT_TRUE(left({-9999, -9999, -9999, -9999, -9999, -9999}).second.empty());
}

TEST(Raster, ValuesNotFarOutsideAreOnlyWarnedAbout) {
  const auto [count, warnings] = left({-5, -300, -600, -20, -999, -999});
  EXPECT_EQ(count, 6U);
  EXPECT_THAT(warnings, Contains(HasSubstr("set <nodata value> -999")));
}

TEST(Raster, ZerosApartFromADeepSeaAreWarnedAbout) {
  const auto [count, warnings] = left({0, -8, -8.5, -9, -8.2, -8.7});
  EXPECT_EQ(count, 6U) << "it may be land";
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_THAT(warnings[0], HasSubstr("1 of 6 cells hold exactly 0"));
  EXPECT_TRUE(left({0, -0.1, -8.5, -9, -4, -2}).second.empty()) << "a beach comes down to 0";
  EXPECT_TRUE(left({1, -1, 0, -9, -4, -2}).second.empty());
}

TEST(Raster, NodataMatchesAsRoundedTo32Bits) {
  Raster r = raster({1, 2, 3, 4});
  r.nodata = 0.1;
  EXPECT_TRUE(r.is_nodata(static_cast<double>(0.1F)));
  EXPECT_TRUE(r.is_nodata(0.1));
  EXPECT_TRUE(r.is_nodata(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(r.is_nodata(0.11));
}

}  // namespace
}  // namespace swathplan
