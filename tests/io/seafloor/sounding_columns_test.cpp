#include "io/seafloor/sounding_columns.h"

#include <gtest/gtest.h>

namespace swathplan {
namespace {

TEST(SoundingColumns, AreFoundByNameInAnyOrder) {
  const auto columns = named_columns("id;Depth (m);\"Northing\";Easting", ';');
  ASSERT_TRUE(columns);
  EXPECT_EQ(columns->x, 3U);
  EXPECT_EQ(columns->y, 2U);
  EXPECT_EQ(columns->z, 1U);
  EXPECT_TRUE(columns->z_is_depth);
  EXPECT_FALSE(columns->lon_lat);
}

TEST(SoundingColumns, NamesTellDegreesAndHeights) {
  const auto columns = named_columns("lon_deg,lat_deg,elevation", ',');
  ASSERT_TRUE(columns);
  EXPECT_TRUE(columns->lon_lat);
  EXPECT_FALSE(columns->z_is_depth);
  EXPECT_FALSE(named_columns("lon,lat,quality", ','));
  EXPECT_FALSE(named_columns("1,2,3", ','));
}

TEST(SoundingColumns, StyleIsThatOfTheRow) {
  const auto is = [](std::string_view row, char separator, bool decimal_comma) {
    const auto style = style_of(row);
    return style && style->separator == separator && style->decimal_comma == decimal_comma;
  };
  EXPECT_TRUE(is("1.5 2 -3", ' ', false));
  EXPECT_TRUE(is("1,5 2 -3,25", ' ', true));
  EXPECT_TRUE(is("1.5,2,-3,9", ',', false));
  EXPECT_TRUE(is("1,5;2;-3,25", ';', true));
  EXPECT_TRUE(is("1.5\t2\t-3", '\t', false));
  EXPECT_FALSE(style_of("1 2"));
  EXPECT_FALSE(style_of("x y z"));
}

}  // namespace
}  // namespace swathplan
