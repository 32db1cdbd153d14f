#include "io/seafloor/inspection.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/results/provenance_json.h"
#include "mesh/synthetic.h"

namespace swathplan {
namespace {

using testing::Contains;
using testing::HasSubstr;

ImportedSeafloor as_imported(Seafloor seafloor) {
  ImportedSeafloor r;
  r.file = "sea.obj";
  r.kind = "mesh";
  r.format = "OBJ";
  r.crs_name = "none";
  r.health = assess(seafloor);
  r.seafloor = std::move(seafloor);
  return r;
}

TEST(Inspection, SaysWhatIsInTheFile) {
  const ImportedSeafloor r = as_imported(saddle());
  const nlohmann::json figures = inspection_json(r);
  EXPECT_DOUBLE_EQ(figures.at("depth_min_m"), 10.0);
  EXPECT_DOUBLE_EQ(figures.at("depth_max_m"), 60.0);
  EXPECT_NEAR(figures.at("depth_mean_m").get<double>(), 35.0, 0.01);
  EXPECT_NEAR(figures.at("area_m2").get<double>(), 6400.0, 1e-6);
  EXPECT_DOUBLE_EQ(figures.at("width_m"), 80.0);
  EXPECT_EQ(figures.at("health").at("components"), 1);
  EXPECT_EQ(figures.at("health").at("boundary_loops"), 1);
  const std::string text = inspection_text(r);
  EXPECT_THAT(text, HasSubstr("10.00 to 60.00 m"));
  EXPECT_THAT(text, HasSubstr("<depth bands> 3"));
}

TEST(Inspection, SuggestsCellsThatTheFanFills) {
  // 256 beams over 100 degrees leave gaps of 2 t sec^2(t) d / 256 = 0.0165 d.
  EXPECT_DOUBLE_EQ(suggest_settings(flat(100, 100, 6.0)).resolution_m, 0.1);
  EXPECT_DOUBLE_EQ(suggest_settings(flat(100, 100, 30.0)).resolution_m, 0.5);
  // Neither more cells than a plan takes nor one larger than the area.
  Seafloor wide = flat(100, 100, 6.0);
  for (Vec3& v : wide.vertices) v.head<2>() *= 400.0;
  EXPECT_DOUBLE_EQ(suggest_settings(wide).resolution_m, 1.0);
  EXPECT_DOUBLE_EQ(suggest_settings(flat(4, 2, 2000.0)).resolution_m, 2.0);
  const SuggestedSettings s = suggest_settings(flat(256, 100, 6.0));
  // Lines lie by what the fan sweeps, not by beams x cell: 2 x 6 m x tan 50, less 10 % overlap.
  EXPECT_NEAR(s.swath_m, 14.301, 1e-3);
  EXPECT_NEAR(s.line_spacing_m, 12.871, 1e-3);
  EXPECT_EQ(s.depth_bands, 1);
  EXPECT_EQ(s.lines, 8U);
  EXPECT_NEAR(s.line_km, 1.989, 1e-3);
  EXPECT_LT(suggest_settings(flat(10, 10, 0.5)).safe_depth_m, 0.5);
}

TEST(Inspection, WarnsOfDataThatLookWrong) {
  EXPECT_THAT(warnings_of(as_imported(flat(50, 50, 5))), Contains(HasSubstr("hardly any relief")));
  Seafloor millimetres = saddle();
  for (Vec3& v : millimetres.vertices) v.z() *= 1000.0;
  EXPECT_THAT(warnings_of(as_imported(millimetres)), Contains(HasSubstr("millimetres")));
  ImportedSeafloor land = as_imported(saddle());
  land.land_share = 0.99;
  EXPECT_THAT(warnings_of(land), Contains(HasSubstr("<z positive> down")));
  ImportedSeafloor parts = as_imported(saddle());
  parts.health.components = 3;
  parts.health.non_manifold_edges = 2;
  EXPECT_THAT(warnings_of(parts), Contains(HasSubstr("3 separate parts")));
  EXPECT_THAT(warnings_of(parts), Contains(HasSubstr("2 edges")));
  ImportedSeafloor fine = as_imported(saddle());
  fine.crs_name = "EPSG:32633 (WGS 84 / UTM zone 33N)";
  EXPECT_THAT(warnings_of(fine), testing::IsEmpty());
}

TEST(Inspection, JsonSurvivesAFileNameThatIsNotUtf8) {
  ImportedSeafloor r = as_imported(saddle());
  r.file = "r\xF8nne.obj";
  const std::string text = json_text(inspection_json(r));
  ASSERT_TRUE(nlohmann::json::accept(text));
  EXPECT_THAT(nlohmann::json::parse(text).at("file").get<std::string>(),
              testing::AllOf(testing::StartsWith("r"), testing::EndsWith("nne.obj")));
}

}  // namespace
}  // namespace swathplan
