#include "io/seafloor/grid_import.h"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>

#include "io/files/crs.h"
#include "io/files/quiet_gdal.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

namespace fs = std::filesystem;

/// The places of a raster in the order of lattice_faces(), whatever the order in the file.
struct Lattice {
  std::size_t columns = 0, rows = 0;
  std::array<double, 6> transform{};
  bool columns_run_west = false, rows_run_south = false;

  [[nodiscard]] std::size_t file_column(std::size_t i) const {
    return columns_run_west ? columns - 1 - i : i;
  }
  [[nodiscard]] std::size_t file_row(std::size_t j) const {
    return rows_run_south ? rows - 1 - j : j;
  }
  [[nodiscard]] Vec2 centre(std::size_t i, std::size_t j) const {
    const double c = static_cast<double>(file_column(i)) + 0.5;
    const double r = static_cast<double>(file_row(j)) + 0.5;
    return {transform[0] + c * transform[1] + r * transform[2],
            transform[3] + c * transform[4] + r * transform[5]};
  }
  [[nodiscard]] double determinant() const {
    const double mirrored = columns_run_west == rows_run_south ? 1.0 : -1.0;
    return mirrored * (transform[1] * transform[5] - transform[2] * transform[4]);
  }
};

GDALDatasetUniquePtr open(const fs::path& path) {
  GDALAllRegister();
  GDALDatasetUniquePtr data(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY));
  if (!data) {
    throw InvalidInput(
        fmt::format("'{}' cannot be read as a grid{}; it may be truncated or garbled",
                    path.string(), QuietGdal::why()));
  }
  if (data->GetRasterCount() == 0) {
    throw InvalidInput(fmt::format(
        "'{}' holds no raster band of its own; extract the depths with gdal_translate first",
        path.string()));
  }
  return data;
}

Lattice lattice_of(GDALDataset& data, const fs::path& path) {
  Lattice lattice;
  lattice.columns = static_cast<std::size_t>(data.GetRasterXSize());
  lattice.rows = static_cast<std::size_t>(data.GetRasterYSize());
  if (data.GetGeoTransform(lattice.transform.data()) != CE_None) {
    throw InvalidInput(fmt::format(
        "'{}' is a picture without a georeference: where it lies is unknown; give it one with "
        "gdal_translate -a_ullr",
        path.string()));
  }
  if (lattice.columns * lattice.rows > kMostCells) {
    throw InvalidInput(fmt::format(
        "'{}' has {} x {} cells; at most {} can be used: crop or thin it with gdal_translate",
        path.string(), lattice.columns, lattice.rows, kMostCells));
  }
  lattice.columns_run_west = lattice.transform[1] < 0.0;
  lattice.rows_run_south = lattice.transform[5] < 0.0;
  if (lattice.determinant() == 0.0) {
    throw InvalidInput(
        fmt::format("'{}' has cells without an area (its georeference is flat)", path.string()));
  }
  return lattice;
}

/// What a band's values mean.
struct BandScale {
  double scale = 1.0, offset = 0.0;
  std::optional<double> nodata, more_nodata;

  BandScale(GDALRasterBand& band, std::optional<double> more) : more_nodata(more) {
    int has = 0;
    scale = band.GetScale(&has);
    if (has == 0 || scale == 0.0) scale = 1.0;
    offset = band.GetOffset(&has);
    if (has == 0) offset = 0.0;
    const double value = band.GetNoDataValue(&has);
    if (has != 0) nodata = value;
  }
  [[nodiscard]] bool is_nodata(double raw) const {
    return std::isnan(raw) || matches(raw, nodata) || matches(raw, more_nodata);
  }
  /// Nodata of a 32-bit band is often written with more digits than the band holds.
  [[nodiscard]] static bool matches(double raw, std::optional<double> value) {
    return value && (raw == *value || raw == static_cast<double>(static_cast<float>(*value)));
  }
};

std::vector<double> read_band(GDALRasterBand& band, const Lattice& lattice, const fs::path& path) {
  std::vector<double> raw(lattice.columns * lattice.rows);
  const int columns = static_cast<int>(lattice.columns);
  const int rows = static_cast<int>(lattice.rows);
  if (band.RasterIO(GF_Read, 0, 0, columns, rows, raw.data(), columns, rows, GDT_Float64, 0, 0,
                    nullptr) != CE_None) {
    throw InvalidInput(fmt::format("'{}' cannot be read to its end{}: it is truncated or garbled",
                                   path.string(), QuietGdal::why()));
  }
  return raw;
}

/// Fills the vertices; returns the vertex index per place.
std::vector<std::uint32_t> add_nodes(const std::vector<double>& raw, const Lattice& lattice,
                                     const BandScale& band, const fs::path& path,
                                     SurfaceData& data) {
  std::vector<std::uint32_t> node(raw.size(), kNoNode);
  for (std::size_t j = 0; j < lattice.rows; ++j) {
    for (std::size_t i = 0; i < lattice.columns; ++i) {
      const double value = raw[lattice.file_row(j) * lattice.columns + lattice.file_column(i)];
      if (band.is_nodata(value)) continue;
      if (!std::isfinite(value)) {
        throw InvalidInput(
            fmt::format("'{}', row {}, column {}: the value is infinite; write "
                        "cells without data as nodata",
                        path.string(), lattice.file_row(j) + 1, lattice.file_column(i) + 1));
      }
      const Vec2 centre = lattice.centre(i, j);
      node[j * lattice.columns + i] = static_cast<std::uint32_t>(data.vertices.size());
      data.vertices.emplace_back(centre.x(), centre.y(), value * band.scale + band.offset);
    }
  }
  return node;
}

std::string crs_of(GDALDataset& data) {
  const OGRSpatialReference* crs = data.GetSpatialRef();
  char* text = nullptr;
  if (crs == nullptr || crs->exportToWkt(&text) != OGRERR_NONE) return {};
  const std::string wkt = text;
  CPLFree(text);
  try {
    return parse_crs(wkt);
  } catch (const UsageError&) {
    return {};  // a CRS that PROJ cannot place is as good as none; inspect says 'none'
  }
}

void add_notes(GDALRasterBand& band, std::size_t cells, SurfaceData& data) {
  data.notes.push_back(fmt::format("{} of {} cells hold a value", data.vertices.size(), cells));
  const std::string unit = band.GetUnitType() != nullptr ? band.GetUnitType() : "";
  if (!unit.empty() && unit[0] != 'm' && unit[0] != 'M') {
    data.warnings.push_back(
        fmt::format("the file says its values are in '{}'; if so, set --z-unit", unit));
  }
}

}  // namespace

bool is_grid(const fs::path& path) {
  const QuietGdal quiet;
  GDALAllRegister();
  return GDALIdentifyDriverEx(path.c_str(), GDAL_OF_RASTER, nullptr, nullptr) != nullptr;
}

std::vector<std::array<std::uint32_t, 3>> lattice_faces(const std::vector<std::uint32_t>& node,
                                                        std::size_t columns) {
  std::vector<std::array<std::uint32_t, 3>> faces;
  faces.reserve(2 * node.size());
  for (std::size_t south = 0; south + columns < node.size(); south += columns) {
    for (std::size_t i = south; i + 1 < south + columns; ++i) {
      const std::uint32_t sw = node[i];
      const std::uint32_t se = node[i + 1];
      const std::uint32_t nw = node[i + columns];
      const std::uint32_t ne = node[i + columns + 1];
      if (sw == kNoNode || se == kNoNode || nw == kNoNode || ne == kNoNode) continue;
      faces.push_back({sw, se, ne});
      faces.push_back({sw, ne, nw});
    }
  }
  return faces;
}

SurfaceData read_grid(const fs::path& path, std::optional<double> nodata) {
  const QuietGdal quiet;
  const GDALDatasetUniquePtr file = open(path);
  const Lattice lattice = lattice_of(*file, path);
  GDALRasterBand& band = *file->GetRasterBand(1);
  SurfaceData data;
  data.format = file->GetDriverName();
  data.crs_wkt = crs_of(*file);
  data.is_clean = true;
  data.spacing = std::sqrt(std::abs(lattice.determinant()));
  const std::vector<double> raw = read_band(band, lattice, path);
  const std::vector<std::uint32_t> node =
      add_nodes(raw, lattice, BandScale(band, nodata), path, data);
  if (data.vertices.empty()) {
    throw InvalidInput(fmt::format(
        "'{}' holds no data: all {} cells are nodata; check the nodata value of the file",
        path.string(), raw.size()));
  }
  data.faces = lattice_faces(node, lattice.columns);
  if (data.faces.empty()) {
    throw InvalidInput(fmt::format(
        "'{}' holds {} cells with data, but nowhere four that make a square: there is no surface",
        path.string(), data.vertices.size()));
  }
  if (lattice.determinant() < 0.0) {
    for (auto& face : data.faces) std::swap(face[1], face[2]);
  }
  add_notes(band, raw.size(), data);
  return data;
}

}  // namespace swathplan
