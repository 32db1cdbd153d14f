#pragma once

#include <gdal_priv.h>

#include "io/grids/surface_data.h"

namespace swathplan {

/// The horizontal CRS of a raster, as WKT; empty if it has none that PROJ can place. Where a netCDF
/// file says 'degrees_east' only, it is WGS 84; where a BAG holds a bare EPSG code, that one.
[[nodiscard]] std::string crs_of_grid(GDALDataset& file, SurfaceData& data);

/// Finds unit and sense of z: the band's unit, CF attributes ('positive: down', standard names) and
/// the vertical reference system. Sets z_unit_m and z_is_depth and says so.
/// `data` must hold its vertices.
void find_meaning_of_z(GDALDataset& file, GDALRasterBand& band, SurfaceData& data);

}  // namespace swathplan
