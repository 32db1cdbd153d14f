#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "io/seafloor/surface_data.h"

namespace swathplan {

/// True if GDAL recognises the file as a raster.
[[nodiscard]] bool is_grid(const std::filesystem::path& path);

/// Reads band 1 of a raster. Nodes are the cell centres; four valid nodes make two triangles whose
/// diagonal runs from the south-west to the north-east node; a cell with a nodata or NaN corner is
/// no seafloor. Scale, offset and rotated geotransforms are honoured. O(cells).
/// @throws InvalidInput if it cannot be opened, has no georeference or more cells than kMostCells,
///   or holds no four valid neighbours.
[[nodiscard]] SurfaceData read_grid(const std::filesystem::path& path,
                                    std::optional<double> nodata = {});

inline constexpr std::size_t kMostCells = 100'000'000;  ///< about 5 GB of triangles
inline constexpr std::uint32_t kNoNode = 0xffffffffU;

/// Joins the nodes of a lattice: `node` holds the vertex index per place, row by row from the
/// south, west to east, or kNoNode.
[[nodiscard]] std::vector<std::array<std::uint32_t, 3>> lattice_faces(
    const std::vector<std::uint32_t>& node, std::size_t columns);

}  // namespace swathplan
