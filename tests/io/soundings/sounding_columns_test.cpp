#include "io/soundings/sounding_columns.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/base/error.h"

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

TEST(SoundingColumns, NamesAreMatchedLoosely) {
  using Role = ColumnName::Role;
  const std::vector<std::pair<const char*, Role>> names = {{"POINT_X", Role::x},
                                                           {"X_coord", Role::x},
                                                           {"xcoord", Role::x},
                                                           {"utm_e", Role::x},
                                                           {"Easting (m)", Role::x},
                                                           {"Point Y", Role::y},
                                                           {"Y Coordinate", Role::y},
                                                           {"NORTHING", Role::y},
                                                           {"lng", Role::lon},
                                                           {"Longitude_WGS84", Role::lon},
                                                           {"decimalLatitude", Role::lat},
                                                           {"lat_dd", Role::lat},
                                                           {"Z_m", Role::z},
                                                           {"Depth_in_Feet", Role::z},
                                                           {"WaterDepth", Role::z},
                                                           {"Corrected Depth (m)", Role::z},
                                                           {"point_z", Role::z},
                                                           {"OBJECTID", Role::none},
                                                           {"fid", Role::none},
                                                           {"id", Role::none},
                                                           {"point", Role::none},
                                                           {"date", Role::none},
                                                           {"time", Role::none},
                                                           {"depth_uncertainty", Role::none},
                                                           {"sonar depth", Role::none},
                                                           {"m", Role::none},
                                                           {"", Role::none}};
  for (const auto& [name, role] : names) EXPECT_EQ(column_name(name).role, role) << name;
  EXPECT_EQ(column_name("Depth (fathoms)").unit_m, 1.8288);
  EXPECT_EQ(column_name("Depth/m").unit_m, 1.0);
  EXPECT_FALSE(column_name("depth").unit_m);
}

TEST(SoundingColumns, PairsBelongTogether) {
  const auto mixed = named_columns("x,lat,lon,y,z", ',');
  ASSERT_TRUE(mixed);
  EXPECT_EQ(mixed->x, 0U);
  EXPECT_EQ(mixed->y, 3U);
  const auto count = named_columns("n,x,y,z,d", ',');
  ASSERT_TRUE(count);
  EXPECT_EQ(count->y, 2U);
  EXPECT_EQ(count->z, 3U);
  EXPECT_FALSE(named_columns("x,lat,z", ','));
  EXPECT_FALSE(named_columns("lat_deg,lat_min,lon_deg,lon_min,depth", ','));
}

TEST(SoundingColumns, ChoiceIsByNumberOrName) {
  const ColumnChoice by_number = parse_columns("x=3, y=2, z=5");
  EXPECT_EQ(by_number.x, "3");
  EXPECT_EQ(by_number.z, "5");
  EXPECT_FALSE(by_number.lon_lat);
  const ColumnChoice by_name = parse_columns("z=DEPTH,x=POINT_X,y=POINT_Y");
  EXPECT_EQ(by_name.y, "POINT_Y");
  const ColumnChoice degrees = parse_columns("lon=2,lat=1,depth=3");
  EXPECT_TRUE(degrees.lon_lat);
  EXPECT_TRUE(degrees.z_is_depth);
  EXPECT_FALSE(parse_columns("").given());
  for (const char* text : {"3,2,5", "x=1,y=2", "x=1,y=2,z=0", "x=1,y=1,z=3", "x=1,y=2,z=2.5",
                           "x=1,x=2,y=3,z=4", "x=,y=2,z=3", "lon=1,y=2,z=3", "a=1,y=2,z=3"}) {
    EXPECT_THROW((void)parse_columns(text), UsageError) << text;
  }
  EXPECT_EQ(find_column("depth ft", {"a", "Depth_FT"}), 1U);
  EXPECT_EQ(find_column("2", {}), 1U);
  EXPECT_FALSE(find_column("b", {"a"}));
}

TEST(SoundingColumns, AnglesAreReadWithTheirHemisphere) {
  const auto is = [](const char* text, double degrees, char hemisphere) {
    const auto angle = angle_of(text);
    return angle && std::abs(angle->degrees - degrees) < 1e-9 && angle->hemisphere == hemisphere;
  };
  EXPECT_TRUE(is("36.5N", 36.5, 'N'));
  EXPECT_TRUE(is("W75 30 00", -75.5, 'W'));
  EXPECT_TRUE(is("33:51:36", 33.86, ' '));
  EXPECT_TRUE(
      is("-33\xC2\xB0"
         "51'36\"",
         -33.86, ' '));
  for (const char* text : {"36.5", "2010-01-13", "12:61", "buoy", "GS", "N", "1 2 3 4", ""}) {
    EXPECT_FALSE(angle_of(text)) << text;
  }
}

}  // namespace
}  // namespace swathplan
