#include "io/grids/bag_refinements.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <fmt/format.h>
#include <gdal_priv.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/files/gdal_at_home.h"
#include "io/grids/bag_refinements_internal.h"
#include "io/grids/grid_import.h"
#include "io/grids/multidim_internal.h"
#include "io/grids/raster_internal.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

namespace fs = std::filesystem;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using Delaunay =
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase>>;

constexpr double kBagNodata = 1e6;
/// Inside a refinement an edge is at most the diagonal of a cell, with room for rounding.
constexpr double kWithin = 1.06;
/// Between two refinements up to two cells are free: what is left where cells do not fill a square.
constexpr double kAcross = 2.3;
/// Places of one lattice agree to this share of a cell: the file holds them in 32 bits.
constexpr double kSamePlace = 0.01;

/// A node of the surface and the refinement that it comes from.
struct Node {
  Vec3 place;
  std::uint32_t refinement = 0;
};

/// The overview, its rows from the south.
void add_overview(const fs::path& path, std::optional<double> nodata, Refinements& all) {
  const GDALDatasetUniquePtr file(
      GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY));
  Raster& o = all.overview;
  if (!file || file->GetRasterCount() == 0 ||
      file->GetGeoTransform(o.transform.data()) != CE_None) {
    throw InvalidInput(fmt::format("'{}' holds no overview of its refinements", path.string()));
  }
  o.columns = static_cast<std::size_t>(file->GetRasterXSize());
  o.rows = static_cast<std::size_t>(file->GetRasterYSize());
  o.nodata = kBagNodata;
  o.more_nodata = nodata;
}

void check_count(std::size_t read, std::size_t wanted, const fs::path& path) {
  if (read == wanted) return;
  throw InvalidInput(fmt::format("'{}' holds {} descriptions of refinements for {} cells",
                                 path.string(), read, wanted));
}

Refinements read_cells(const fs::path& path, std::optional<double> nodata) {
  Refinements all;
  add_overview(path, nodata, all);
  const std::unique_ptr<GDALDataset> file = open_groups(path);
  const std::shared_ptr<GDALGroup> root = file ? file->GetRootGroup() : nullptr;
  const std::shared_ptr<GDALGroup> bag = root ? root->OpenGroup("BAG_root") : nullptr;
  const auto cells = bag ? bag->OpenMDArray("varres_metadata") : nullptr;
  const auto nodes = bag ? bag->OpenMDArray("varres_refinements") : nullptr;
  const auto overview = bag ? bag->OpenMDArray("elevation") : nullptr;
  if (!cells || !nodes || !overview) {
    throw InvalidInput(
        fmt::format("'{}' says that it has refinements, but they cannot be found; its overview "
                    "alone would hide "
                    "shoals, so it is not used",
                    path.string()));
  }
  const Raster& o = all.overview;
  const std::size_t count = o.columns * o.rows;
  const std::vector<double> index = values_of(*cells, "index", path);
  const std::vector<double> columns = values_of(*cells, "dimensions_x", path);
  const std::vector<double> rows = values_of(*cells, "dimensions_y", path);
  const std::vector<double> step_x = values_of(*cells, "resolution_x", path);
  const std::vector<double> step_y = values_of(*cells, "resolution_y", path);
  const std::vector<double> west = values_of(*cells, "sw_corner_x", path);
  const std::vector<double> south = values_of(*cells, "sw_corner_y", path);
  const std::vector<double> coarse = values_of(*overview, "", path);
  all.heights = values_of(*nodes, "depth", path);
  check_count(index.size(), count, path);
  check_count(coarse.size(), count, path);
  const std::size_t refined = all.heights.size();
  const Vec2 size(o.transform[1], std::abs(o.transform[5]));
  const Vec2 corner(
      o.transform[0],
      std::min(o.transform[3], o.transform[3] + static_cast<double>(o.rows) * o.transform[5]));
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t row = i / o.columns;
    const Vec2 cell = corner + Vec2(static_cast<double>(i % o.columns) * size.x(),
                                    static_cast<double>(row) * size.y());
    Refinement r;
    r.columns = static_cast<std::size_t>(columns[i]);
    r.rows = static_cast<std::size_t>(rows[i]);
    if (r.columns == 0 || r.rows == 0) {
      if (o.is_nodata(coarse[i])) continue;
      r.columns = r.rows = 1;
      r.first = all.heights.size();
      r.south_west = cell + 0.5 * size;
      r.step = size;
      all.heights.push_back(coarse[i]);
      ++all.unrefined;
    } else {
      r.first = static_cast<std::size_t>(index[i]);
      r.step = Vec2(step_x[i], step_y[i]);
      r.south_west = cell + Vec2(west[i], south[i]);
      if (r.first > refined || r.columns > refined || r.rows > refined ||
          r.first + r.columns * r.rows > refined || !(r.step.minCoeff() > 0.0)) {
        throw InvalidInput(fmt::format("'{}': the refinement of row {}, column {} is garbled",
                                       path.string(), i / o.columns + 1, i % o.columns + 1));
      }
    }
    all.cells.push_back(r);
  }
  return all;
}

/// All refinements as one grid, if they have the same cells and these fit together.
std::optional<Raster> as_one_grid(const Refinements& all) {
  if (all.cells.empty()) return {};
  const Vec2 step = all.cells.front().step;
  Vec2 low = all.cells.front().south_west;
  Vec2 high = low;
  for (const Refinement& r : all.cells) {
    if ((r.step - step).cwiseAbs().maxCoeff() > 1e-6 * step.minCoeff()) return {};
    low = low.cwiseMin(r.south_west);
    high = high.cwiseMax(r.south_west + Vec2(static_cast<double>(r.columns - 1) * step.x(),
                                             static_cast<double>(r.rows - 1) * step.y()));
  }
  const Vec2 places = (high - low).cwiseQuotient(step);
  if (!((places.x() + 1.0) * (places.y() + 1.0) < static_cast<double>(kMostCells))) return {};
  Raster grid;
  grid.columns = static_cast<std::size_t>(std::lround(places.x())) + 1;
  grid.rows = static_cast<std::size_t>(std::lround(places.y())) + 1;
  grid.transform = {low.x() - 0.5 * step.x(), step.x(), 0.0,
                    low.y() - 0.5 * step.y(), 0.0,      step.y()};
  grid.nodata = all.overview.nodata;
  grid.more_nodata = all.overview.more_nodata;
  grid.raw.assign(grid.columns * grid.rows, std::numeric_limits<double>::quiet_NaN());
  for (const Refinement& r : all.cells) {
    const Vec2 at = (r.south_west - low).cwiseQuotient(step);
    const Vec2 whole(std::round(at.x()), std::round(at.y()));
    if ((at - whole).cwiseAbs().maxCoeff() > kSamePlace) return {};
    const auto column = static_cast<std::size_t>(whole.x());
    const auto row = static_cast<std::size_t>(whole.y());
    for (std::size_t i = 0; i < r.columns * r.rows; ++i) {
      grid.raw[(row + i / r.columns) * grid.columns + column + i % r.columns] =
          all.heights[r.first + i];
    }
  }
  return grid;
}

std::vector<Node> nodes_of(const Refinements& all, const fs::path& path) {
  std::vector<Node> nodes;
  for (std::size_t c = 0; c < all.cells.size(); ++c) {
    const Refinement& r = all.cells[c];
    for (std::size_t i = 0; i < r.columns * r.rows; ++i) {
      const double z = all.heights[r.first + i];
      if (all.overview.is_nodata(z)) continue;
      const std::size_t row = i / r.columns;
      const Vec2 at = r.south_west + Vec2(static_cast<double>(i % r.columns) * r.step.x(),
                                          static_cast<double>(row) * r.step.y());
      if (!std::isfinite(z) || !at.allFinite()) {
        throw InvalidInput(
            fmt::format("'{}': a refinement holds a value that is not finite", path.string()));
      }
      nodes.push_back({Vec3(at.x(), at.y(), z), static_cast<std::uint32_t>(c)});
    }
  }
  return nodes;
}

bool is_near(const Node& a, const Node& b, const std::vector<Refinement>& cells) {
  const double length = (a.place - b.place).head<2>().norm();
  const Vec2 step = cells[a.refinement].step;
  if (a.refinement == b.refinement) return length <= kWithin * step.norm();
  return length <= kAcross * std::max(step.maxCoeff(), cells[b.refinement].step.maxCoeff());
}

/// Joins the nodes; those that no triangle is left for are dropped.
SurfaceData join_nodes(const std::vector<Node>& nodes, const std::vector<Refinement>& cells) {
  std::vector<std::pair<Kernel::Point_2, std::uint32_t>> points;
  points.reserve(nodes.size());
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    points.emplace_back(Kernel::Point_2(nodes[i].place.x(), nodes[i].place.y()), i);
  }
  const Delaunay triangulation(points.begin(), points.end());
  SurfaceData data;
  std::vector<std::uint32_t> vertex(nodes.size(), kNoNode);
  for (const Delaunay::Face_handle face : triangulation.finite_face_handles()) {
    std::array<std::uint32_t, 3> f{face->vertex(0)->info(), face->vertex(1)->info(),
                                   face->vertex(2)->info()};
    if (!is_near(nodes[f[0]], nodes[f[1]], cells) || !is_near(nodes[f[1]], nodes[f[2]], cells) ||
        !is_near(nodes[f[2]], nodes[f[0]], cells)) {
      continue;
    }
    for (std::uint32_t& v : f) {
      if (vertex[v] == kNoNode) {
        vertex[v] = static_cast<std::uint32_t>(data.vertices.size());
        data.vertices.push_back(nodes[v].place);
      }
      v = vertex[v];
    }
    data.faces.push_back(f);
  }
  data.is_clean = true;
  return data;
}

double finest_step(const std::vector<Refinement>& cells) {
  double finest = std::numeric_limits<double>::infinity();
  for (const Refinement& r : cells) finest = std::min(finest, r.step.minCoeff());
  return finest;
}

double coarsest_step(const std::vector<Refinement>& cells) {
  double coarsest = 0.0;
  for (const Refinement& r : cells) coarsest = std::max(coarsest, r.step.maxCoeff());
  return coarsest;
}

}  // namespace

SurfaceData join_refinements(const Refinements& all, const fs::path& path) {
  SurfaceData data;
  if (const std::optional<Raster> grid = as_one_grid(all)) {
    data = surface_of(*grid, path);
  } else {
    data = join_nodes(nodes_of(all, path), all.cells);
    if (data.faces.empty()) {
      throw InvalidInput(fmt::format(
          "'{}' holds refinements, but no three nodes that make a surface", path.string()));
    }
    data.spacing = finest_step(all.cells);
  }
  data.notes.push_back(fmt::format(
      "variable resolution: read at its refinements, {:.4g} to {:.4g} a cell{}",
      finest_step(all.cells), coarsest_step(all.cells),
      all.unrefined == 0
          ? ""
          : fmt::format("; {} cells have none and keep their overview node", all.unrefined)));
  return data;
}

SurfaceData read_refinements(const fs::path& path, std::optional<double> nodata) {
  register_gdal();
  return join_refinements(read_cells(path, nodata), path);
}

}  // namespace swathplan
