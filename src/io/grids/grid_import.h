#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/grids/surface_data.h"

namespace swathplan {

/// True if GDAL recognises the file as a raster. Rows of x, y, z are none, whatever the file's
/// extension: they are read as soundings.
[[nodiscard]] bool is_grid(const std::filesystem::path& path);

/// Reads one band of a raster: the first one, or that which `layer` names. Nodes are the cell
/// centres; four valid nodes make two triangles whose diagonal runs from the south-west to the
/// north-east node; a cell with a nodata or NaN corner is no seafloor. Scale, offset and rotated
/// geotransforms are honoured, and so are units, 'positive: down' and vertical reference systems.
/// A variable-resolution BAG is read at its refinements, S-102 (HDF5) by its depths. `layer`: names
/// separated by commas, of variables, subdatasets or bands. O(cells).
/// @throws InvalidInput if it cannot be opened, is a picture, has no georeference or more cells
/// than
///   kMostCells, holds several layers none of which is chosen, or no four valid neighbours.
[[nodiscard]] SurfaceData read_grid(const std::filesystem::path& path,
                                    std::optional<double> nodata = {},
                                    const std::string& layer = {});

/// The cells of one band of a raster as they stand in the file, where they lie and what they count.
struct GridCells {
  std::size_t columns = 0, rows = 0;
  std::array<double, 6> transform{};  ///< GDAL's: the corner of the first cell and the two steps
  std::vector<double> values;         ///< row by row; NaN: no data
  std::string crs_wkt;                ///< empty: none
  std::string band;                   ///< what the file calls it; may be empty
  bool counts = false;                ///< whole numbers without a sign
  std::vector<std::string> warnings;
};
/// Reads them as read_grid() finds its band. Empty for grids without cells of their own: S-102, and
/// BAG of variable resolution. @throws InvalidInput as read_grid() does.
[[nodiscard]] std::optional<GridCells> read_cells(const std::filesystem::path& path,
                                                  const std::string& layer = {});

inline constexpr std::size_t kMostCells = 100'000'000;  ///< about 5 GB of triangles
inline constexpr std::uint32_t kNoNode = 0xffffffffU;

/// Joins the nodes of a lattice: `node` holds the vertex index per place, row by row from the
/// south, west to east, or kNoNode.
[[nodiscard]] std::vector<std::array<std::uint32_t, 3>> lattice_faces(
    const std::vector<std::uint32_t>& node, std::size_t columns);

}  // namespace swathplan
