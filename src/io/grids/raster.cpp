#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "io/grids/grid_import.h"
#include "io/grids/no_data_values.h"
#include "io/grids/raster_internal.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

namespace fs = std::filesystem;

/// The places of a raster in the order of lattice_faces(), whatever the order in the file.
struct Lattice {
  std::size_t columns = 0, rows = 0;
  std::array<double, 6> transform{};
  bool columns_run_west = false, rows_run_south = false;

  explicit Lattice(const Raster& raster)
      : columns(raster.columns),
        rows(raster.rows),
        transform(raster.transform),
        columns_run_west(transform[1] < 0.0),
        rows_run_south(transform[5] < 0.0) {}
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

bool matches(double raw, std::optional<double> value) {
  return value && (raw == *value || raw == static_cast<double>(static_cast<float>(*value)));
}

/// Fills the vertices; returns the vertex index per place.
std::vector<std::uint32_t> add_nodes(const Raster& raster, const Lattice& lattice,
                                     const fs::path& path, SurfaceData& data) {
  std::vector<std::uint32_t> node(raster.raw.size(), kNoNode);
  for (std::size_t j = 0; j < lattice.rows; ++j) {
    for (std::size_t i = 0; i < lattice.columns; ++i) {
      const double value =
          raster.raw[lattice.file_row(j) * lattice.columns + lattice.file_column(i)];
      if (raster.is_nodata(value)) continue;
      if (!std::isfinite(value)) {
        throw InvalidInput(
            fmt::format("'{}', row {}, column {}: the value is infinite; write "
                        "cells without data as nodata",
                        path.string(), lattice.file_row(j) + 1, lattice.file_column(i) + 1));
      }
      const Vec2 centre = lattice.centre(i, j);
      node[j * lattice.columns + i] = static_cast<std::uint32_t>(data.vertices.size());
      data.vertices.emplace_back(centre.x(), centre.y(), value * raster.scale + raster.offset);
    }
  }
  return node;
}

}  // namespace

bool Raster::is_nodata(double value) const {
  return std::isnan(value) || matches(value, nodata) || matches(value, more_nodata);
}

void check_shape(const Raster& raster, const fs::path& path) {
  if (raster.columns * raster.rows > kMostCells) {
    throw InvalidInput(fmt::format(
        "'{}' has {} x {} cells; at most {} can be used: crop or thin it with gdal_translate",
        path.string(), raster.columns, raster.rows, kMostCells));
  }
  if (Lattice(raster).determinant() == 0.0) {
    throw InvalidInput(
        fmt::format("'{}' has cells without an area (its georeference is flat)", path.string()));
  }
}

void drop_undeclared_nodata(Raster& raster, std::vector<std::string>& warnings) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  std::map<double, std::size_t> suspects;
  for (const double value : raster.raw) {
    if (raster.is_nodata(value) || !std::isfinite(value)) continue;
    if (no_data_sign(value) != NoDataSign::none) {
      ++suspects[value];
    } else {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  if (low > high) return;
  for (const auto& [value, count] : suspects) {
    const SuspectValue suspect{value, count, raster.raw.size(), low, high};
    if (is_worth_a_word(suspect)) warnings.push_back(no_data_warning(suspect, "cells"));
    if (is_no_data(suspect)) {
      std::replace(raster.raw.begin(), raster.raw.end(), value,
                   std::numeric_limits<double>::quiet_NaN());
    }
  }
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

SurfaceData surface_of(const Raster& raster, const fs::path& path) {
  const Lattice lattice(raster);
  SurfaceData data;
  data.is_clean = true;
  data.spacing = std::sqrt(std::abs(lattice.determinant()));
  const std::vector<std::uint32_t> node = add_nodes(raster, lattice, path, data);
  if (data.vertices.empty()) {
    throw InvalidInput(fmt::format(
        "'{}' holds no data: all {} cells are nodata; check the nodata value of the file",
        path.string(), raster.raw.size()));
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
  data.notes.push_back(
      fmt::format("{} of {} cells hold a value", data.vertices.size(), raster.raw.size()));
  return data;
}

}  // namespace swathplan
