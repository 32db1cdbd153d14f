#include "io/seafloor/import_seafloor.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "io/import_files.h"

namespace swathplan {
namespace {

using testing::Contains;
using testing::HasSubstr;
using ImportSeafloor = ImportFiles;

/// What every importer promises, see Seafloor.
testing::AssertionResult is_valid(const Seafloor& s) {
  if (s.faces.empty()) return testing::AssertionFailure() << "no faces";
  for (const Vec3& v : s.vertices) {
    if (!v.allFinite() || v.z() > 0.0) return testing::AssertionFailure() << v.transpose();
  }
  for (const Seafloor::Face& f : s.faces) {
    for (const std::uint32_t v : f) {
      if (v >= s.vertices.size()) return testing::AssertionFailure() << "index " << v;
    }
    const Vec2 ab = (s.vertices[f[1]] - s.vertices[f[0]]).head<2>();
    const Vec2 ac = (s.vertices[f[2]] - s.vertices[f[0]]).head<2>();
    if (ab.x() * ac.y() - ab.y() * ac.x() < 0.0) return testing::AssertionFailure() << "face down";
  }
  return testing::AssertionSuccess();
}

/// x, y, z rows of a bumpy 10 x 10 patch that is no lattice.
std::string rows(double x0, double y0, double step, double z_scale) {
  std::string text;
  for (int j = 0; j < 10; ++j) {
    for (int i = 0; i < 10; ++i) {
      text += fmt::format("{:.9f} {:.9f} {:.4f}\n", x0 + step * (i + 0.1 * (j % 3)),
                          y0 + step * (j + 0.1 * (i % 2)), z_scale * (5.0 + 0.1 * i + 0.05 * j));
    }
  }
  return text;
}

TEST_F(ImportSeafloor, UtmCoordinatesComeBackExactly) {
  const ImportedSeafloor r = import_seafloor(
      write("a.obj",
            "v 585000.123 4797000.456 -1.1\nv 585010.123 4797000.456 -1\nv 585010 4797010.7 -1\n"
            "f 1 2 3\n"),
      {.crs = "EPSG:32633"});
  EXPECT_TRUE(is_valid(r.seafloor));
  EXPECT_EQ(r.kind, "mesh");
  EXPECT_EQ(r.crs_name, "EPSG:32633 (WGS 84 / UTM zone 33N)");
  EXPECT_EQ(r.seafloor.frame.origin, Vec2(585000, 4797000));
  EXPECT_EQ(r.seafloor.frame.to_file(r.seafloor.vertices[0].head<2>()),
            Vec2(585000.123, 4797000.456));
  EXPECT_EQ(r.seafloor.frame.to_file(r.seafloor.vertices[2].head<2>()), Vec2(585010, 4797010.7));
  EXPECT_THAT(r.input_hash, testing::MatchesRegex("sha1:[0-9a-f]+"));
}

TEST_F(ImportSeafloor, SmallLocalCoordinatesKeepTheirOrigin) {
  const ImportedSeafloor r =
      import_seafloor(write("a.obj", "v -40 -30 -1\nv 50 0 -2\nv 0 60 -3\nf 1 2 3\n"));
  EXPECT_EQ(r.seafloor.frame.origin, Vec2(0, 0));
  EXPECT_EQ(r.seafloor.vertices[0], Vec3(-40, -30, -1));
  EXPECT_EQ(r.crs_name, "none");
}

TEST_F(ImportSeafloor, SenseUnitAndWaterLevelOfDepths) {
  const auto file = write("a.xyz", rows(0, 0, 1, 1.0));  // 5 to 6.35, positive down
  using ZPositive = ImportOptions::ZPositive;
  const DepthRange metres =
      depth_range(import_seafloor(file, {.z_positive = ZPositive::down}).seafloor);
  EXPECT_NEAR(metres.min, 5.0, 1e-12);
  EXPECT_NEAR(metres.max, 6.35, 1e-12);
  const DepthRange feet = depth_range(
      import_seafloor(file, {.z_positive = ZPositive::down, .z_unit_m = 0.3048}).seafloor);
  EXPECT_NEAR(feet.max, 6.35 * 0.3048, 1e-12);
  const DepthRange tide = depth_range(
      import_seafloor(file, {.water_level_m = 1.5, .z_positive = ZPositive::down}).seafloor);
  EXPECT_NEAR(tide.min, 6.5, 1e-12);
  const DepthRange flooded = depth_range(import_seafloor(file, {.water_level_m = 10.0}).seafloor);
  EXPECT_NEAR(flooded.min, 10.0 - 6.35, 1e-12);
}

TEST_F(ImportSeafloor, FeetOfTheCrsAreScaled) {
  const ImportedSeafloor r =
      import_seafloor(write("a.xyz", rows(980000, 190000, 10, -1)), {.crs = "EPSG:2263"});
  const double foot = 1200.0 / 3937.0;
  EXPECT_NEAR(r.seafloor.frame.metres_per_unit, foot, 1e-12);
  EXPECT_NEAR(extent(r.seafloor).size().x(), 92.0 * foot, 1e-9);
  EXPECT_THAT(r.warnings, Contains(HasSubstr("<z unit>")));
  const ImportedSeafloor by_hand =
      import_seafloor(write("b.xyz", rows(0, 0, 10, -1)), {.xy_unit_m = 0.3048});
  EXPECT_NEAR(extent(by_hand.seafloor).size().x(), 92.0 * 0.3048, 1e-9);
}

TEST_F(ImportSeafloor, LandIsClippedAndSaid) {
  // A beach: z = x - 5 over [0, 10] x [0, 10].
  const ImportedSeafloor r =
      import_seafloor(write("a.obj", "v 0 0 -5\nv 10 0 5\nv 10 10 5\nv 0 10 -5\nf 1 2 3 4\n"));
  EXPECT_TRUE(is_valid(r.seafloor));
  EXPECT_NEAR(r.land_share, 0.5, 1e-12);
  EXPECT_THAT(r.notes, Contains(HasSubstr("50 %")));
  EXPECT_NEAR(extent(r.seafloor).max.x(), 5.0, 1e-12);
}

TEST_F(ImportSeafloor, DegreesAreProjectedToUtm) {
  const ImportedSeafloor r =
      import_seafloor(write("a.csv", "lon lat depth\n" + rows(14.7, 55.1, 1e-4, 1.0)));
  EXPECT_TRUE(is_valid(r.seafloor));
  EXPECT_EQ(r.crs_name, "EPSG:32633 (WGS 84 / UTM zone 33N)");
  // One degree of latitude is about 111.3 km there, one of longitude 63.8 km.
  EXPECT_NEAR(extent(r.seafloor).size().x(), 92e-5 * 63'800.0, 1.0);
  EXPECT_NEAR(extent(r.seafloor).size().y(), 91e-5 * 111'340.0, 1.0);
  EXPECT_THAT(r.notes, Contains(HasSubstr("projected")));
  EXPECT_NEAR(depth_range(r.seafloor).min, 5.0, 1e-9);
}

TEST_F(ImportSeafloor, DegreesThatPoseAsMetresAreRefused) {
  const auto file = write("a.xyz", rows(14.7, 55.1, 1e-4, -1.0));
  const auto says = [&](const ImportOptions& options) {
    return refusal([&] { return import_seafloor(file, options); });
  };
  EXPECT_THAT(says({}), HasSubstr("look like degrees"));
  EXPECT_THAT(says({.crs = "EPSG:32633"}), HasSubstr("look like degrees"));
  EXPECT_EQ(says({.crs = "EPSG:4326"}), "accepted");
  EXPECT_EQ(says({.xy_unit_m = 1.0}), "accepted");
  const auto metres = write("b.xyz", rows(479000, 6104000, 5, -1.0));
  EXPECT_THAT(refusal([&] { return import_seafloor(metres, {.crs = "EPSG:4326"}); }),
              HasSubstr("are no degrees"));
}

TEST_F(ImportSeafloor, FloatsThatAreTooCoarseAreNoted) {
  std::string bytes(80, 'x');
  const std::uint32_t count = 1;
  bytes.append(reinterpret_cast<const char*>(&count), 4);
  const float facet[12] = {0,         0,          1,  585000.0F, 4797000.0F, -1,
                           585010.0F, 4797000.0F, -2, 585000.0F, 4797010.0F, -3};
  bytes.append(reinterpret_cast<const char*>(facet), sizeof facet).append(2, '\0');
  const ImportedSeafloor r = import_seafloor(write("a.stl", bytes));
  EXPECT_THAT(r.notes, Contains(HasSubstr("32-bit floats, which resolve only 0.5 m")));
}

TEST_F(ImportSeafloor, RefusesWhatCannotBeUsed) {
  const auto says = [&](const std::filesystem::path& file, const ImportOptions& options = {}) {
    return refusal([&] { return import_seafloor(file, options); });
  };
  EXPECT_THAT(says(path("none.obj")), HasSubstr("does not exist"));
  EXPECT_THAT(says(path("")), HasSubstr("is a folder"));
  EXPECT_THAT(says(write("e.xyz", "")), HasSubstr("is empty"));
  for (const char* name : {"g.xyz", "g.csv", "g.asc", "g.tif", "g.bag", "g.bin", "g", "g.obj"}) {
    EXPECT_THAT(says(write(name, garbage(3000))), HasSubstr("garbled")) << name;
  }
  EXPECT_THAT(says(write("up.xyz", rows(0, 0, 1, 1.0))), HasSubstr("<z positive> down"));
  EXPECT_THAT(says(write("v.obj", "v 0 0 -1\nv 1 0.1 -1\nv 3 0.3 -5\nf 1 2 3\n")),
              HasSubstr("looks y up"));
  const auto fine = write("f.xyz", rows(0, 0, 1, -1.0));
  EXPECT_THROW((void)import_seafloor(fine, {.crs = "EPSG:nothing"}), UsageError);
  EXPECT_THROW((void)import_seafloor(fine, {.z_unit_m = 0.0}), UsageError);
  EXPECT_THROW((void)import_seafloor(fine, {.xy_unit_m = -1.0}), UsageError);
  EXPECT_THROW((void)import_seafloor(fine, {.longest_edge_m = NAN}), UsageError);
  EXPECT_THROW((void)import_seafloor(fine, {.water_level_m = INFINITY}), UsageError);
}

TEST_F(ImportSeafloor, RealMeshInUtmIsExact) {
  const auto file = shared_dataset("odense_fjord_mesh/odense_utm33n.obj");
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no shared datasets";
  const ImportedSeafloor r = import_seafloor(file, {.crs = "EPSG:32633"});
  EXPECT_TRUE(is_valid(r.seafloor));
  EXPECT_EQ(r.health.vertices, 399U);
  EXPECT_EQ(r.health.faces, 654U);
  EXPECT_EQ(r.health.boundary_loops, 2U);
  const Vec2 first(218234.754788, 6158181.032688);
  EXPECT_TRUE(
      std::any_of(r.seafloor.vertices.begin(), r.seafloor.vertices.end(),
                  [&](const Vec3& v) { return r.seafloor.frame.to_file(v.head<2>()) == first; }));
}

TEST_F(ImportSeafloor, RealHarbourAsGridAndAsTurnedSoundings) {
  const auto file = shared_dataset("ronne_harbour_dhi/ronne_local_5m.asc");
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no shared datasets";
  const ImportedSeafloor grid = import_seafloor(file);
  EXPECT_EQ(grid.kind, "grid");
  EXPECT_EQ(grid.nodes, 21110U);
  EXPECT_TRUE(is_valid(grid.seafloor));
  const ImportedSeafloor xyz =
      import_seafloor(shared_dataset("ronne_harbour_dhi/ronne_utm33n.xyz"), {.crs = "EPSG:32633"});
  EXPECT_EQ(xyz.kind, "soundings");
  EXPECT_TRUE(is_valid(xyz.seafloor));
  // Turned, every cell is there again; only corners with three nodes of four come on top.
  EXPECT_GE(xyz.health.faces, grid.health.faces);
  EXPECT_LE(xyz.health.faces, grid.health.faces + 800);
  EXPECT_EQ(xyz.health.components, 1U);
}

TEST_F(ImportSeafloor, RealLakeLeavesItsStraysApart) {
  const auto file = shared_dataset("ela_lake_soundings/227_LA.csv");
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no shared datasets";
  const ImportedSeafloor csv = import_seafloor(file, {.crs = "EPSG:4326"});
  const ImportedSeafloor xyz =
      import_seafloor(shared_dataset("ela_lake_soundings/lake227_utm15n.xyz"));
  for (const ImportedSeafloor* r : {&csv, &xyz}) {
    EXPECT_TRUE(is_valid(r->seafloor));
    EXPECT_EQ(r->health.components, 1U);
    EXPECT_EQ(r->health.vertices, 1027U);
    EXPECT_NEAR(extent(r->seafloor).size().x(), 262.7, 0.1);
    EXPECT_NEAR(depth_range(r->seafloor).max, 11.07, 1e-9);
  }
  EXPECT_NEAR(csv.seafloor.frame.to_file(extent(csv.seafloor).min).x(),
              xyz.seafloor.frame.to_file(extent(xyz.seafloor).min).x(), 0.01);
}

}  // namespace
}  // namespace swathplan
