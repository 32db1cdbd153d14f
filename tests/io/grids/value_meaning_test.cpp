#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <ogr_spatialref.h>

#include "io/files/crs.h"
#include "io/grids/grid_import.h"
#include "io/import_files.h"

namespace swathplan {
namespace {

using testing::Contains;
using testing::HasSubstr;
using ValueMeaning = ImportFiles;

/// What a 3 x 2 grid says about its z.
struct Said {
  std::string unit = {};
  int epsg = 32633;
  int vertical_epsg = 0;
  std::vector<double> values = {1, 2, 3, 4, 5, 6};
};

std::filesystem::path tiff(const std::filesystem::path& path, const Said& said) {
  GDALAllRegister();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  const GDALDatasetUniquePtr data(driver->Create(path.c_str(), 3, 2, 1, GDT_Float64, nullptr));
  std::array<double, 6> transform{500000, 10, 0, 4000000, 0, -10};
  data->SetGeoTransform(transform.data());
  OGRSpatialReference crs;
  crs.importFromEPSG(said.epsg);
  if (said.vertical_epsg != 0) {
    OGRSpatialReference vertical, both;
    vertical.importFromEPSG(said.vertical_epsg);
    both.SetCompoundCS("both", &crs, &vertical);
    crs = both;
  }
  data->SetSpatialRef(&crs);
  GDALRasterBand* band = data->GetRasterBand(1);
  band->SetUnitType(said.unit.c_str());
  std::vector<double> copy = said.values;
  EXPECT_EQ(CE_None, band->RasterIO(GF_Write, 0, 0, 3, 2, copy.data(), 3, 2, GDT_Float64, 0, 0));
  return path;
}

TEST_F(ValueMeaning, UnitOfTheBandIsHonoured) {
  const auto unit = [&](const std::string& name) {
    return read_grid(tiff(path("a.tif"), {.unit = name})).z_unit_m.value_or(1.0);
  };
  EXPECT_EQ(unit(""), 1.0);
  EXPECT_EQ(unit("metre"), 1.0);
  EXPECT_EQ(unit("ft"), 0.3048);
  EXPECT_DOUBLE_EQ(unit("US survey foot"), 1200.0 / 3937.0);
  EXPECT_EQ(unit("mm"), 0.001);
  const SurfaceData data = read_grid(tiff(path("b.tif"), {.unit = "ft"}));
  EXPECT_THAT(data.notes, Contains(HasSubstr("z is in ft")));
}

TEST_F(ValueMeaning, UnitThatNoOceanIsDeepEnoughForIsNotThatOfZ) {
  const auto miles = [&](double depth) {
    return read_grid(tiff(path("a.tif"), {.unit = "mile", .values = {1, 2, 3, 4, 5, depth}}));
  };
  EXPECT_EQ(miles(-7.0).z_unit_m, 1609.344);
  EXPECT_FALSE(miles(-8.0).z_unit_m);
  EXPECT_THAT(miles(-8.0).warnings, Contains(HasSubstr("taken as metres")));
}

TEST_F(ValueMeaning, UnknownUnitIsWarnedAbout) {
  const SurfaceData data = read_grid(tiff(path("a.tif"), {.unit = "mystery"}));
  EXPECT_FALSE(data.z_unit_m);
  EXPECT_THAT(data.warnings, Contains(HasSubstr("'mystery'")));
}

TEST_F(ValueMeaning, VerticalSystemMayBePositiveDown) {
  constexpr int kMllwDepth = 5866;
  const SurfaceData down = read_grid(tiff(path("a.tif"), {.vertical_epsg = kMllwDepth}));
  EXPECT_TRUE(down.z_is_depth);
  EXPECT_THAT(down.notes, Contains(HasSubstr("positive down")));
  EXPECT_THAT(crs_name(down.crs_wkt), HasSubstr("EPSG:32633"));
  constexpr int kNavd88Height = 5703;
  EXPECT_FALSE(read_grid(tiff(path("b.tif"), {.vertical_epsg = kNavd88Height})).z_is_depth);
}

TEST_F(ValueMeaning, HeightsUnderASystemOfDepthsStayHeights) {
  const SurfaceData data =
      read_grid(tiff(path("a.tif"), {.vertical_epsg = 5866, .values = {-1, -2, -3, -4, -5, 1}}));
  EXPECT_FALSE(data.z_is_depth);
  EXPECT_THAT(data.warnings, Contains(HasSubstr("taken as heights")));
}

TEST_F(ValueMeaning, BagHoldsElevationsAndMayNameItsCrsByABareCode) {
  constexpr const char* kTemplate = R"(<?xml version="1.0"?>
<gmi:MI_Metadata xmlns:gmi="http://www.isotc211.org/2005/gmi"
    xmlns:gmd="http://www.isotc211.org/2005/gmd" xmlns:gml="http://www.opengis.net/gml/3.2"
    xmlns:gco="http://www.isotc211.org/2005/gco">
<gmd:spatialRepresentationInfo><gmd:MD_Georectified>
<gmd:axisDimensionProperties><gmd:MD_Dimension><gmd:dimensionName>
<gmd:MD_DimensionNameTypeCode codeListValue="row">row</gmd:MD_DimensionNameTypeCode>
</gmd:dimensionName><gmd:dimensionSize><gco:Integer>2</gco:Integer></gmd:dimensionSize>
<gmd:resolution><gco:Measure uom="Metres">10</gco:Measure></gmd:resolution></gmd:MD_Dimension>
</gmd:axisDimensionProperties>
<gmd:axisDimensionProperties><gmd:MD_Dimension><gmd:dimensionName>
<gmd:MD_DimensionNameTypeCode codeListValue="column">column</gmd:MD_DimensionNameTypeCode>
</gmd:dimensionName><gmd:dimensionSize><gco:Integer>3</gco:Integer></gmd:dimensionSize>
<gmd:resolution><gco:Measure uom="Metres">10</gco:Measure></gmd:resolution></gmd:MD_Dimension>
</gmd:axisDimensionProperties>
<gmd:cornerPoints><gml:Point>
<gml:coordinates decimal="." cs="," ts=" ">${CORNER_POINTS}</gml:coordinates></gml:Point>
</gmd:cornerPoints></gmd:MD_Georectified></gmd:spatialRepresentationInfo>
<gmd:referenceSystemInfo><gmd:MD_ReferenceSystem><gmd:referenceSystemIdentifier><gmd:RS_Identifier>
<gmd:code><gco:CharacterString>32633</gco:CharacterString></gmd:code>
<gmd:codeSpace><gco:CharacterString>EPSG</gco:CharacterString></gmd:codeSpace>
</gmd:RS_Identifier></gmd:referenceSystemIdentifier></gmd:MD_ReferenceSystem>
</gmd:referenceSystemInfo></gmi:MI_Metadata>)";
  const auto source = tiff(path("a.tif"), {.values = {1, 2, 3, -4, 5, 6}});
  const std::string option = "TEMPLATE=" + write("t.xml", kTemplate).string();
  const GDALDatasetUniquePtr in(GDALDataset::Open(source.c_str()));
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("BAG");
  const char* options[] = {option.c_str(), nullptr};
  GDALClose(driver->CreateCopy(path("a.bag").c_str(), in.get(), 0, const_cast<char**>(options),
                               nullptr, nullptr));
  const SurfaceData data = read_grid(path("a.bag"));
  EXPECT_FALSE(data.z_is_depth);
  EXPECT_EQ(data.vertices.size(), 6U);
  EXPECT_THAT(crs_name(data.crs_wkt), HasSubstr("EPSG:32633"));
}

}  // namespace
}  // namespace swathplan
