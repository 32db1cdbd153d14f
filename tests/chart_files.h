#pragma once

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace swathplan::test {

/// One feature of a layer: fields and a geometry as WKT; without one where that is empty.
struct ChartFeature {
  std::map<std::string, std::string> fields;
  std::string wkt;
};
using ChartLayers = std::map<std::string, std::vector<ChartFeature>>;

inline void add_chart_layer(GDALDataset& file, OGRSpatialReference& crs, const std::string& name,
                            const std::vector<ChartFeature>& features) {
  OGRLayer* layer = file.CreateLayer(name.c_str(), &crs, wkbUnknown, nullptr);
  ASSERT_TRUE(layer != nullptr);
  for (const ChartFeature& f : features) {
    for (const auto& [field, text] : f.fields) {
      if (layer->GetLayerDefn()->GetFieldIndex(field.c_str()) >= 0) continue;
      OGRFieldDefn column(field.c_str(), OFTString);
      ASSERT_EQ(layer->CreateField(&column), OGRERR_NONE);
    }
  }
  for (const ChartFeature& f : features) {
    const OGRFeatureUniquePtr feature(OGRFeature::CreateFeature(layer->GetLayerDefn()));
    for (const auto& [field, text] : f.fields) feature->SetField(field.c_str(), text.c_str());
    if (!f.wkt.empty()) {
      OGRGeometry* shape = nullptr;
      ASSERT_EQ(OGRGeometryFactory::createFromWkt(f.wkt.c_str(), nullptr, &shape), OGRERR_NONE);
      feature->SetGeometryDirectly(shape);
    }
    ASSERT_EQ(layer->CreateFeature(feature.get()), OGRERR_NONE);
  }
}

/// A GeoPackage with layers as S-57 names them, in the CRS of an EPSG number.
inline std::filesystem::path write_chart(const std::filesystem::path& path,
                                         const ChartLayers& layers, int epsg = 4326) {
  GDALAllRegister();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GPKG");
  const std::unique_ptr<GDALDataset> file(
      driver->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  EXPECT_TRUE(file);
  OGRSpatialReference crs;
  crs.importFromEPSG(epsg);
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  for (const auto& [name, features] : layers) add_chart_layer(*file, crs, name, features);
  return path;
}

/// Water of 1200 x 600 m in UTM 33N: shoal (2 to 5 m) in the west, deep (5 to 10 m) in the east,
/// with an island of 100 m in the deep part and land along the north. Soundings of 8 m in the deep
/// part only.
inline ChartLayers small_chart() {
  return {
      {"DEPARE",
       {{{{"DRVAL1", "2"}, {"DRVAL2", "5"}},
         "POLYGON((500000 4000000,500600 4000000,500600 4000600,500000 4000600,500000 4000000))"},
        {{{"DRVAL1", "5"}, {"DRVAL2", "10"}},
         "POLYGON((500600 4000000,501200 4000000,501200 4000600,500600 4000600,500600 4000000),"
         "(500850 4000250,500850 4000350,500950 4000350,500950 4000250,500850 4000250))"}}},
      {"DEPCNT", {{{{"VALDCO", "5"}}, "LINESTRING(500600 4000000,500600 4000600)"}}},
      {"LNDARE",
       {{{{"OBJNAM", "The Island"}},
         "POLYGON((500850 4000250,500950 4000250,500950 4000350,500850 4000350,500850 4000250))"},
        {{},
         "POLYGON((500000 4000600,501200 4000600,501200 4000700,500000 4000700,500000 "
         "4000600))"}}},
      {"SOUNDG",
       {{{{"DEPTH", "8"}}, "POINT(500750 4000100)"}, {{{"DEPTH", "8"}}, "POINT(501100 4000500)"}}},
      {"WRECKS",
       {{{{"VALSOU", "6.1"}, {"QUAPOS", "4"}}, "POINT(501050 4000150)"},
        {{{"VALSOU", "3"}, {"POSACC", "5"}}, "POINT(500300 4000300)"}}},
  };
}

}  // namespace swathplan::test
