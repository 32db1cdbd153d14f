#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <fmt/format.h>

#include <limits>

#include "io/seafloor/polygon_soup_internal.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// Cutting a polygon takes the cube of its corners, which CGAL counts in 32 bits.
constexpr std::size_t kMostCorners = 1000;

/// CGAL fills the polygon as if it were a hole. A simple fan of triangles could leave its outline.
std::vector<CGAL::Triple<int, int, int>> fill(const std::vector<Vec3>& vertices,
                                              const SoupPolygon& polygon) {
  std::vector<Kernel::Point_3> outline;
  for (const std::size_t v : polygon) {
    outline.emplace_back(vertices[v].x(), vertices[v].y(), vertices[v].z());
  }
  std::vector<CGAL::Triple<int, int, int>> patch;
  CGAL::Polygon_mesh_processing::triangulate_hole_polyline(
      outline, std::back_inserter(patch),
      CGAL::parameters::use_delaunay_triangulation(false).use_2d_constrained_delaunay_triangulation(
          true));
  return patch;
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulate(const std::filesystem::path& path,
                                                      const std::vector<Vec3>& vertices,
                                                      const std::vector<SoupPolygon>& polygons) {
  if (vertices.size() > std::numeric_limits<std::uint32_t>::max()) {
    throw InvalidInput(fmt::format("'{}' holds {} vertices; at most {} can be used: thin it",
                                   path.string(), vertices.size(),
                                   std::numeric_limits<std::uint32_t>::max()));
  }
  std::vector<std::array<std::uint32_t, 3>> faces;
  faces.reserve(polygons.size());
  const auto at = [](std::size_t v) { return static_cast<std::uint32_t>(v); };
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    const SoupPolygon& p = polygons[i];
    for (const std::size_t v : p) {
      if (v >= vertices.size()) {
        throw InvalidInput(fmt::format(
            "'{}', face {}: vertex {} is asked for, but there are only {}; the file is truncated "
            "or garbled",
            path.string(), i + 1, v + 1, vertices.size()));
      }
    }
    if (p.size() > kMostCorners) {
      throw InvalidInput(fmt::format(
          "'{}', face {}: has {} corners; at most {} can be cut into triangles: export triangles",
          path.string(), i + 1, p.size(), kMostCorners));
    }
    if (p.size() == 3) faces.push_back({at(p[0]), at(p[1]), at(p[2])});
    if (p.size() <= 3) continue;
    for (const CGAL::Triple<int, int, int>& t : fill(vertices, p)) {
      faces.push_back({at(p[static_cast<std::size_t>(t.first)]),
                       at(p[static_cast<std::size_t>(t.second)]),
                       at(p[static_cast<std::size_t>(t.third)])});
    }
  }
  return faces;
}

}  // namespace swathplan
