#include "io/grids/grid_import.h"

#include <fmt/format.h>
#include <gdal_priv.h>

#include <cmath>
#include <limits>
#include <string_view>

#include "io/files/gdal_at_home.h"
#include "io/files/quiet_gdal.h"
#include "io/grids/bag_refinements.h"
#include "io/grids/grid_source_internal.h"
#include "io/grids/raster_internal.h"
#include "io/grids/s100_import.h"
#include "io/grids/value_meaning_internal.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

namespace fs = std::filesystem;

Raster shape_of(GDALDataset& data, const fs::path& path) {
  Raster raster;
  raster.columns = static_cast<std::size_t>(data.GetRasterXSize());
  raster.rows = static_cast<std::size_t>(data.GetRasterYSize());
  if (data.GetGeoTransform(raster.transform.data()) != CE_None) {
    throw InvalidInput(fmt::format(
        "'{}' is a picture without a georeference: where it lies is unknown; give it one with "
        "gdal_translate -a_ullr",
        path.string()));
  }
  check_shape(raster, path);
  return raster;
}

void add_scale(GDALRasterBand& band, std::optional<double> more_nodata, Raster& raster) {
  int has = 0;
  raster.scale = band.GetScale(&has);
  if (has == 0 || raster.scale == 0.0) raster.scale = 1.0;
  raster.offset = band.GetOffset(&has);
  if (has == 0) raster.offset = 0.0;
  const double value = band.GetNoDataValue(&has);
  if (has != 0) raster.nodata = value;
  raster.more_nodata = more_nodata;
}

void add_values(GDALRasterBand& band, const fs::path& path, Raster& raster) {
  raster.raw.resize(raster.columns * raster.rows);
  const int columns = static_cast<int>(raster.columns);
  const int rows = static_cast<int>(raster.rows);
  if (band.RasterIO(GF_Read, 0, 0, columns, rows, raster.raw.data(), columns, rows, GDT_Float64, 0,
                    0, nullptr) != CE_None) {
    throw InvalidInput(fmt::format("'{}' cannot be read to its end{}: it is truncated or garbled",
                                   path.string(), QuietGdal::why()));
  }
}

/// Where a data set has refinements, its own cells are a coarse overview.
bool has_refinements(GDALDataset& data) {
  const char* value = data.GetMetadataItem("HAS_SUPERGRIDS");
  return value != nullptr && std::string_view(value) == "TRUE";
}

SurfaceData read_values(GDALDataset& file, GDALRasterBand& band, const fs::path& path,
                        std::optional<double> nodata) {
  if (has_refinements(file)) return read_refinements(path, nodata);
  Raster raster = shape_of(file, path);
  add_scale(band, nodata, raster);
  add_values(band, path, raster);
  std::vector<std::string> warnings;
  drop_undeclared_nodata(raster, warnings);
  SurfaceData data = surface_of(raster, path);
  data.warnings = std::move(warnings);
  return data;
}

void warn_of_grey_picture(GDALRasterBand& band, SurfaceData& data) {
  if (band.GetRasterDataType() != GDT_Byte || data.vertices.empty()) return;
  data.warnings.emplace_back(
      "the values are whole numbers from 0 to 255: this looks like a grey picture, not like "
      "depths");
}

}  // namespace

bool is_grid(const fs::path& path) {
  const QuietGdal quiet;
  register_gdal();
  const GDALDriverH driver = GDALIdentifyDriverEx(path.c_str(), GDAL_OF_RASTER, nullptr, nullptr);
  return driver != nullptr && std::string_view(GDALGetDriverShortName(driver)) != "XYZ";
}

SurfaceData read_grid(const fs::path& path, std::optional<double> nodata,
                      const std::string& layer) {
  const QuietGdal quiet;
  if (is_s100(path)) return read_s100(path, nodata, layer);
  GridSource source = open_grid(path, layer);
  GDALRasterBand& band = *source.data->GetRasterBand(source.band);
  SurfaceData data = read_values(*source.data, band, path, nodata);
  data.format = source.data->GetDriverName();
  data.crs_wkt = crs_of_grid(*source.data, data);
  data.notes.insert(data.notes.end(), source.notes.begin(), source.notes.end());
  data.warnings.insert(data.warnings.end(), source.warnings.begin(), source.warnings.end());
  warn_of_grey_picture(band, data);
  find_meaning_of_z(*source.data, band, data);
  return data;
}

std::optional<GridCells> read_cells(const fs::path& path, const std::string& layer) {
  const QuietGdal quiet;
  if (is_s100(path)) return std::nullopt;
  const GridSource source = open_grid(path, layer);
  if (has_refinements(*source.data)) return std::nullopt;
  GDALRasterBand& band = *source.data->GetRasterBand(source.band);
  Raster raster = shape_of(*source.data, path);
  add_scale(band, {}, raster);
  add_values(band, path, raster);
  GridCells cells;
  drop_undeclared_nodata(raster, cells.warnings);
  cells.columns = raster.columns;
  cells.rows = raster.rows;
  cells.transform = raster.transform;
  cells.band = band.GetDescription();
  const GDALDataType type = band.GetRasterDataType();
  cells.counts = type == GDT_Byte || type == GDT_UInt16 || type == GDT_UInt32;
  for (double& value : raster.raw) {
    value = raster.is_nodata(value) ? std::numeric_limits<double>::quiet_NaN()
                                    : value * raster.scale + raster.offset;
  }
  cells.values = std::move(raster.raw);
  SurfaceData notes;
  cells.crs_wkt = crs_of_grid(*source.data, notes);
  return cells;
}

}  // namespace swathplan
