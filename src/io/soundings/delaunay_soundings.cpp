#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/soundings/soundings_import.h"
#include "mesh/base/error.h"
#include "mesh/edge_table.h"
#include "mesh/plane/segments.h"
#include "mesh/plane/union_find.h"

namespace swathplan {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using Delaunay =
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase>>;

/// If the 10th and the 90th percentile of the nearest distances agree to this share, the points are
/// those of a grid, perhaps a turned one.
constexpr double kGridLike = 1.05;
/// There the diagonal of a cell is allowed (the longest edge of its triangles) with room for
/// rounding, but no gap of a cell (1.41 times the diagonal of a square).
constexpr double kGridLimit = 1.06;
/// Scattered soundings: multiples of the median nearest distance and of the median longest edge of
/// a triangle. Lines of soundings are dense along and wide across: the second one bridges them.
constexpr double kNearestLimit = 4.0;
constexpr double kEdgeLimit = 2.5;
/// A part of less than this share of the largest part's area is left out.
constexpr double kSmallestPart = 0.01;

double percentile(std::vector<double>& values, double share) {
  if (values.empty()) return 0.0;
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

double length(const std::vector<Vec3>& v, std::uint32_t a, std::uint32_t b) {
  return (v[a] - v[b]).head<2>().norm();
}

double plan_area(const std::vector<Vec3>& v, const std::array<std::uint32_t, 3>& f) {
  const Vec2 ab = (v[f[1]] - v[f[0]]).head<2>();
  const Vec2 ac = (v[f[2]] - v[f[0]]).head<2>();
  return 0.5 * std::abs(cross(ab, ac));
}

double longest_edge(const std::vector<Vec3>& v, const std::array<std::uint32_t, 3>& f) {
  return std::max({length(v, f[0], f[1]), length(v, f[1], f[2]), length(v, f[2], f[0])});
}

std::vector<std::array<std::uint32_t, 3>> delaunay(const std::vector<Vec3>& vertices) {
  std::vector<std::pair<Kernel::Point_2, std::uint32_t>> points;
  points.reserve(vertices.size());
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    points.emplace_back(Kernel::Point_2(vertices[i].x(), vertices[i].y()), i);
  }
  const Delaunay triangulation(points.begin(), points.end());
  std::vector<std::array<std::uint32_t, 3>> faces;
  faces.reserve(triangulation.number_of_faces());
  for (const Delaunay::Face_handle face : triangulation.finite_face_handles()) {
    faces.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  }
  return faces;
}

/// The distance from each point to the nearest one. A Delaunay edge leads there.
std::vector<double> nearest_distances(const SurfaceData& data) {
  std::vector<double> nearest(data.vertices.size(), std::numeric_limits<double>::infinity());
  for (const auto& f : data.faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = f.at(i);
      const std::uint32_t b = f.at((i + 1) % 3);
      const double d = length(data.vertices, a, b);
      nearest[a] = std::min(nearest[a], d);
      nearest[b] = std::min(nearest[b], d);
    }
  }
  std::erase_if(nearest, [](double d) { return std::isinf(d); });
  return nearest;
}

double choose_limit(const SurfaceData& data, std::vector<double>& nearest) {
  std::vector<double> longest;
  longest.reserve(data.faces.size());
  for (const auto& f : data.faces) longest.push_back(longest_edge(data.vertices, f));
  const double edge = percentile(longest, 0.5);
  const bool grid_like = percentile(nearest, 0.9) <= kGridLike * percentile(nearest, 0.1);
  if (grid_like) return kGridLimit * edge;
  return std::max(kNearestLimit * percentile(nearest, 0.5), kEdgeLimit * edge);
}

std::size_t drop_unused(SurfaceData& data) {
  std::vector<std::uint32_t> index(data.vertices.size(), 0);
  for (const auto& f : data.faces) {
    for (const std::uint32_t v : f) index[v] = 1;
  }
  std::uint32_t kept = 0;
  for (std::size_t v = 0; v < index.size(); ++v) {
    if (index[v] == 0) continue;
    data.vertices[kept] = data.vertices[v];
    index[v] = kept++;
  }
  const std::size_t dropped = data.vertices.size() - kept;
  data.vertices.resize(kept);
  for (auto& f : data.faces) {
    for (std::uint32_t& v : f) v = index[v];
  }
  return dropped;
}

/// Leaves out parts that are tiny beside the largest one. They are strays far off the survey.
void drop_small_parts(SurfaceData& data) {
  UnionFind parts(data.faces.size());
  const std::vector<EdgeUse> uses = edge_uses(data.faces, data.vertices.size());
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    if (edge.size() == 2) parts.join(edge[0].face, edge[1].face);
  });
  std::vector<double> area(data.faces.size(), 0.0);
  for (std::uint32_t f = 0; f < data.faces.size(); ++f) {
    area[parts.find(f)] += plan_area(data.vertices, data.faces[f]);
  }
  const double smallest = kSmallestPart * *std::max_element(area.begin(), area.end());
  std::vector<std::array<std::uint32_t, 3>> kept;
  for (std::uint32_t f = 0; f < data.faces.size(); ++f) {
    if (area[parts.find(f)] >= smallest) kept.push_back(data.faces[f]);
  }
  data.faces = std::move(kept);
}

/// Distances between places further out may leave the range of doubles.
void check_coordinates(const std::vector<Vec3>& vertices) {
  for (const Vec3& v : vertices) {
    if (v.allFinite() && v.head<2>().cwiseAbs().maxCoeff() <= kLargestCoordinate) continue;
    throw InvalidInput(
        fmt::format("a sounding lies at {:.6g}, {:.6g}: no map has coordinates beyond {:g}", v.x(),
                    v.y(), kLargestCoordinate));
  }
}

}  // namespace

double join_soundings(SurfaceData& points, std::optional<double> longest) {
  check_coordinates(points.vertices);
  points.faces = delaunay(points.vertices);
  if (points.faces.empty()) {
    throw InvalidInput(fmt::format(
        "the {} soundings lie on one straight line: they make no surface", points.vertices.size()));
  }
  std::vector<double> nearest = nearest_distances(points);
  points.spacing = percentile(nearest, 0.5);
  const double limit = longest ? *longest : choose_limit(points, nearest);
  std::erase_if(points.faces,
                [&](const auto& f) { return longest_edge(points.vertices, f) > limit; });
  if (points.faces.empty()) {
    throw InvalidInput(fmt::format(
        "no triangle between the soundings has all edges under {:.6g}; set a larger <longest edge>",
        limit));
  }
  drop_small_parts(points);
  const std::size_t apart = drop_unused(points);
  if (apart > 0) {
    points.warnings.push_back(fmt::format(
        "{} soundings lie apart from the others (further than the longest edge, or in a part under "
        "1 % of the largest one) and were left out",
        apart));
  }
  points.is_clean = true;
  return limit;
}

}  // namespace swathplan
