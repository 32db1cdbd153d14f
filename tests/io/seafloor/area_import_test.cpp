#include "io/seafloor/area_import.h"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <ogrsf_frmts.h>

#include <cmath>

#include "io/files/crs.h"
#include "io/import_files.h"

namespace swathplan {
namespace {

using testing::HasSubstr;
using AreaImport = ImportFiles;

Frame utm_frame() { return {.origin = Vec2(479000, 6104000), .crs_wkt = parse_crs("EPSG:32633")}; }

std::string geojson(const std::string& geometry) {
  return R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},"geometry":)" +
         geometry + "}]}";
}

/// A rectangle in UTM 33N as a GeoJSON polygon of longitudes and latitudes.
std::string lon_lat_rectangle(const Vec2& low, const Vec2& high) {
  const CrsTransform to_lon_lat(parse_crs("EPSG:32633"), wgs84_crs());
  std::string corners;
  for (const Vec2& p : {low, Vec2(high.x(), low.y()), high, Vec2(low.x(), high.y()), low}) {
    const Vec2 q = to_lon_lat(p);
    corners += fmt::format("{}[{:.12f},{:.12f}]", corners.empty() ? "" : ",", q.x(), q.y());
  }
  return geojson(R"({"type":"Polygon","coordinates":[[)" + corners + "]]}");
}

/// The rectangle with a square hole, written by OGR in the given format and CRS.
std::filesystem::path written(const std::filesystem::path& path, const char* driver_name,
                              const std::string& crs_wkt) {
  GDALAllRegister();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(driver_name);
  const GDALDatasetUniquePtr data(driver->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  OGRSpatialReference crs;
  crs.importFromWkt(crs_wkt.c_str());
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  OGRLayer* layer = data->CreateLayer("area", crs_wkt.empty() ? nullptr : &crs, wkbPolygon);
  const CrsTransform transform(parse_crs("EPSG:32633"),
                               crs_wkt.empty() ? parse_crs("EPSG:32633") : crs_wkt);
  OGRPolygon polygon;
  for (const auto& [low, size] : {std::pair{100.0, 400.0}, std::pair{200.0, 50.0}}) {
    OGRLinearRing ring;
    for (const Vec2& corner : {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1), Vec2(0, 0)}) {
      const Vec2 p = transform(Vec2(Vec2(479000 + low, 6104000 + low) + size * corner));
      ring.addPoint(p.x(), p.y());
    }
    polygon.addRing(&ring);
  }
  const OGRFeatureUniquePtr feature(OGRFeature::CreateFeature(layer->GetLayerDefn()));
  feature->SetGeometry(&polygon);
  EXPECT_EQ(OGRERR_NONE, layer->CreateFeature(feature.get()));
  return path;
}

TEST_F(AreaImport, GeoJsonDegreesBecomeLocalMetres) {
  const Area area =
      import_area(
          write("a.geojson", lon_lat_rectangle(Vec2(479100, 6104100), Vec2(479500, 6104300))),
          utm_frame())
          .area;
  ASSERT_EQ(area.size(), 1U);
  const Box2 box = extent(area);
  EXPECT_NEAR((box.min - Vec2(100, 100)).norm(), 0.0, 1e-3);
  EXPECT_NEAR((box.max - Vec2(500, 300)).norm(), 0.0, 1e-3);
  EXPECT_NEAR(area_m2(area), 400.0 * 200.0, 1.0);
}

TEST_F(AreaImport, EveryFormatAndCrsGivesTheSameArea) {
  const std::vector<std::tuple<const char*, const char*, std::string>> files = {
      {"a.gpkg", "GPKG", parse_crs("EPSG:32633")},
      {"b.gpkg", "GPKG", parse_crs("EPSG:32632")},
      {"c.gpkg", "GPKG", wgs84_crs()},
      {"d.shp", "ESRI Shapefile", wgs84_crs()},
      {"e.shp", "ESRI Shapefile", ""},
      {"f.kml", "KML", wgs84_crs()},
      {"g.geojson", "GeoJSON", parse_crs("EPSG:32633")}};
  for (const auto& [name, driver, crs] : files) {
    const Area area = import_area(written(path(name), driver, crs), utm_frame()).area;
    ASSERT_EQ(area.size(), 1U) << name;
    EXPECT_EQ(area[0].holes.size(), 1U) << name;
    EXPECT_NEAR(area_m2(area), 400.0 * 400.0 - 50.0 * 50.0, 1.0) << name;
    EXPECT_NEAR((extent(area).min - Vec2(100, 100)).norm(), 0.0, 0.01) << name;
    EXPECT_FALSE(contains(area, Vec2(225, 225))) << name;
  }
}

TEST_F(AreaImport, LocalCoordinatesStayLocal) {
  const std::string square =
      geojson(R"({"type":"Polygon","coordinates":[[[0,0],[40,0],[40,30],[0,30],[0,0]]]})");
  EXPECT_NEAR(area_m2(import_area(write("a.geojson", square), Frame{}).area), 1200.0, 1e-6);
  const std::string eastings = geojson(
      R"({"type":"Polygon","coordinates":[[[479100,6104000],[479140,6104000],[479140,6104030],[479100,6104000]]]})");
  EXPECT_NEAR(area_m2(import_area(write("b.geojson", eastings), utm_frame()).area), 600.0, 1e-6);
}

TEST_F(AreaImport, OverlappingPolygonsAreUnited) {
  const std::string two = geojson(
      R"({"type":"MultiPolygon","coordinates":[[[[0,0],[4,0],[4,4],[0,4],[0,0]]],[[[20,0],[24,0],[24,4],[20,4],[20,0]]]]})");
  EXPECT_EQ(import_area(write("a.geojson", two), Frame{}).area.size(), 2U);
  const std::string both =
      R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":[[[0,0],[4,0],[4,4],[0,4],[0,0]]]}},{"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":[[[2,2],[6,2],[6,6],[2,6],[2,2]]]}}]})";
  const Area united = import_area(write("b.geojson", both), Frame{}).area;
  EXPECT_EQ(united.size(), 1U);
  EXPECT_NEAR(area_m2(united), 28.0, 1e-6);
}

TEST_F(AreaImport, RefusesWhatIsNoArea) {
  const auto says = [&](const std::string& text, std::optional<Box2> data = {}) {
    return refusal(
        [&] { return import_area(write("a.geojson", text), Frame{}, {.data_extent = data}); });
  };
  EXPECT_THAT(refusal([&] { return import_area(path("no.geojson"), Frame{}); }),
              HasSubstr("does not exist"));
  EXPECT_THAT(says(garbage(500)), HasSubstr("cannot be read"));
  EXPECT_THAT(says(R"({"type":"FeatureColl)"), HasSubstr("cannot be read"));
  EXPECT_THAT(says(geojson(R"({"type":"LineString","coordinates":[[0,0],[1,1]]})")),
              HasSubstr("no polygon"));
  EXPECT_THAT(
      says(geojson(R"({"type":"Polygon","coordinates":[[[0,0],[4,4],[4,0],[0,4],[0,0]]]})")),
      HasSubstr("crosses"));
  const std::string square =
      geojson(R"({"type":"Polygon","coordinates":[[[0,0],[4,0],[4,4],[0,4],[0,0]]]})");
  EXPECT_EQ(says(square, Box2{Vec2(3, 3), Vec2(9, 9)}), "accepted");
  EXPECT_THAT(says(square, Box2{Vec2(5, 0), Vec2(9, 4)}), HasSubstr("do not meet"));
}

TEST_F(AreaImport, ClosedLinesCountWhereThereIsNoPolygon) {
  const std::string ring = R"({"type":"LineString","coordinates":[[0,0],[4,0],[4,4],[0,4],[0,0]]})";
  const ImportedArea read = import_area(write("a.geojson", geojson(ring)), Frame{});
  EXPECT_NEAR(area_m2(read.area), 16.0, 1e-9);
  ASSERT_EQ(read.notes.size(), 1U);
  EXPECT_THAT(read.notes[0], HasSubstr("holds no polygon: its 1 closed line was taken as such"));
  const ImportedArea room = import_area(path("a.geojson"), Frame{}, {.buffer_m = 0.5});
  EXPECT_GT(area_m2(room.area), 15.0) << "with a buffer it stays a line";
  EXPECT_LT(area_m2(room.area), 16.1);
}

TEST_F(AreaImport, UnclosedPolygonsAreClosed) {
  const std::string open =
      "<kml xmlns=\"http://www.opengis.net/kml/2.2\"><Placemark><Polygon><outerBoundaryIs>"
      "<LinearRing><coordinates>0,0 4,0 4,4 0,4</coordinates></LinearRing></outerBoundaryIs>"
      "</Polygon></Placemark></kml>";
  EXPECT_NEAR(area_m2(import_area(write("a.kml", open), Frame{}).area), 16.0, 1e-9);
}

TEST_F(AreaImport, SaysWhatIsReallyWrong) {
  const std::string sliver =
      geojson(R"({"type":"Polygon","coordinates":[[[0,0],[4,0],[0,0],[4,0],[0,0]]]})");
  EXPECT_THAT(refusal([&] { return import_area(write("a.geojson", sliver), Frame{}); }),
              HasSubstr("fewer than three corners"));
  const std::string good = lon_lat_rectangle({479100, 6104100}, {479500, 6104500});
  const Box2 data{Vec2(0, 0), Vec2(1000, 1000)};
  EXPECT_NO_THROW((void)import_area(write("b.geojson", good), utm_frame(), {.data_extent = data}));
  std::string swapped = good;
  for (std::size_t at = swapped.find("[14."); at != std::string::npos;
       at = swapped.find("[14.", at + 1)) {
    const std::size_t comma = swapped.find(',', at);
    const std::size_t end = swapped.find(']', at);
    swapped.replace(at, end - at,
                    "[" + swapped.substr(comma + 1, end - comma - 1) + "," +
                        swapped.substr(at + 1, comma - at - 1));
  }
  ASSERT_NE(swapped, good);
  EXPECT_THAT(refusal([&] {
                return import_area(write("c.geojson", swapped), utm_frame(), {.data_extent = data});
              }),
              HasSubstr("with latitude and longitude exchanged they would"));
  std::filesystem::copy_file(written(path("d.shp"), "ESRI Shapefile", ""), path("e.shp"));
  EXPECT_THAT(refusal([&] { return import_area(path("e.shp"), Frame{}); }),
              HasSubstr(".shx is not beside it"));
}

std::string feature_of(const std::string& geometry) {
  return R"({"type":"Feature","properties":{},"geometry":)" + geometry + "}";
}

std::string mixed_features() {
  return R"({"type":"FeatureCollection","features":[)" +
         feature_of(R"({"type":"Polygon","coordinates":[[[0,0],[40,0],[40,40],[0,40],[0,0]]]})") +
         "," + feature_of(R"({"type":"LineString","coordinates":[[100,0],[200,0]]})") + "," +
         feature_of(R"({"type":"Point","coordinates":[300,0]})") + "]}";
}

TEST_F(AreaImport, NamesLinesAndPointsThatDoNotCount) {
  const ImportedArea read = import_area(write("m.geojson", mixed_features()), Frame{});
  EXPECT_NEAR(area_m2(read.area), 1600.0, 1e-6);
  ASSERT_EQ(read.notes.size(), 1U);
  EXPECT_THAT(read.notes[0], HasSubstr("1 line and 1 point do not count"));
}

TEST_F(AreaImport, GivesLinesAndPointsRoomWithABuffer) {
  const ImportedArea read =
      import_area(write("m.geojson", mixed_features()), Frame{}, {.buffer_m = 5.0});
  const double disc = 3.14159265 * 25.0;  // a circle of 64 chords has 0.2 % less
  EXPECT_NEAR(area_m2(read.area), 1600.0 + (100.0 * 10.0 + disc) + disc, 0.005 * disc);
  EXPECT_TRUE(contains(read.area, Vec2(150, 4.9)));
  EXPECT_FALSE(contains(read.area, Vec2(150, 5.1)));
  EXPECT_TRUE(contains(read.area, Vec2(304.9, 0)));
}

TEST_F(AreaImport, CountsShapesOffTheData) {
  const ImportedArea read =
      import_area(write("m.geojson", mixed_features()), Frame{},
                  {.data_extent = Box2{Vec2(0, 0), Vec2(210, 50)}, .buffer_m = 1.0});
  EXPECT_THAT(read.notes.back(), HasSubstr("1 of 3 shapes lie off the seafloor's data"));
}

TEST_F(AreaImport, SimplifiesOutlinesOfVeryManyCornersOnTheSafeSide) {
  constexpr int kCorners = 5000;
  std::string corners;
  for (int k = 0; k <= kCorners; ++k) {
    const double a = 2.0 * 3.14159265358979 * (k % kCorners) / kCorners;
    const double r = 50.0 + 0.02 * std::sin(900.0 * a);
    corners += fmt::format("{}[{},{}]", k > 0 ? "," : "", r * std::cos(a), r * std::sin(a));
  }
  const auto file =
      write("s.geojson", geojson(R"({"type":"Polygon","coordinates":[[)" + corners + "]]}"));
  const Area exact = import_area(file, Frame{}).area;
  const ImportedArea within = import_area(file, Frame{}, {.tolerance_m = 0.1});
  const ImportedArea around =
      import_area(file, Frame{}, {.tolerance_m = 0.1, .rounding = Rounding::around});
  EXPECT_LT(area_m2(subtract(within.area, exact)), 1e-6);
  EXPECT_LT(area_m2(subtract(exact, around.area)), 1e-6);
  EXPECT_LT(around.area.front().outer.size(), 500U);
  ASSERT_EQ(around.notes.size(), 1U);
  EXPECT_THAT(around.notes[0], HasSubstr("within 0.1 m; the area used contains the file's"));
}

TEST_F(AreaImport, RipplesOfAShorelineAreSimplifiedAsFarAsAllowed) {
  constexpr int kCorners = 40000;
  std::string corners;
  for (int k = 0; k <= kCorners; ++k) {
    const double a = 2.0 * 3.14159265358979 * (k % kCorners) / kCorners;
    const double r = 500.0 + (k % 2 == 0 ? 0.0 : 0.06);
    corners += fmt::format("{}[{},{}]", k > 0 ? "," : "", r * std::cos(a), r * std::sin(a));
  }
  const auto file =
      write("r.geojson", geojson(R"({"type":"Polygon","coordinates":[[)" + corners + "]]}"));
  const ImportedArea within =
      import_area(file, Frame{}, {.tolerance_m = 0.05, .most_tolerance_m = 0.5});
  ASSERT_EQ(within.area.size(), 1U);
  EXPECT_LT(within.area.front().outer.size(), 2 * kFewEnough);
  EXPECT_GT(area_m2(within.area), 3.14159 * 499.5 * 499.5);
  EXPECT_LT(area_m2(within.area), 3.14160 * 500.06 * 500.06);
  ASSERT_EQ(within.notes.size(), 1U);
  EXPECT_THAT(within.notes[0], HasSubstr("within 0.2 m; the area used lies inside the file's"));
}

TEST_F(AreaImport, RefusesDegreesOnASeafloorWithoutACrs) {
  const std::string tiny = geojson(
      R"({"type":"Polygon","coordinates":[[[10,50],[10.001,50],[10.001,50.001],[10,50],[10,50]]]})");
  EXPECT_THAT(refusal([&] { return import_area(write("a.geojson", tiny), Frame{}); }),
              HasSubstr("look like degrees"));
}

}  // namespace
}  // namespace swathplan
