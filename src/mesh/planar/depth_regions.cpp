#include "mesh/planar/depth_regions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "mesh/base/error.h"
#include "mesh/plane/union_find.h"

namespace swathplan {
namespace {

/// Depths are sampled at kSamples (kSamples + 1) / 2 points in each triangle of a face.
constexpr int kSamples = 12;

struct FaceDepth {
  double mean = 0.0, min = 0.0, max = 0.0, area = 0.0;
};

/// Depth statistics below a face. Samples are spread evenly over the triangles around its centroid.
FaceDepth face_depth(const PlanarMesh& mesh, std::uint32_t face, const DepthQuery& depths) {
  const auto& corners = mesh.faces[face];
  const Vec2 centre = face_centroid(mesh, face);
  FaceDepth result{0.0, std::numeric_limits<double>::infinity(), 0.0, 0.0};
  double weighted = 0.0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec2& a = mesh.vertices[corners[k]];
    const Vec2& b = mesh.vertices[corners[(k + 1) % corners.size()]];
    const double area = std::abs(signed_area({centre, a, b}));
    double sum = 0.0;
    int count = 0;
    for (int i = 0; i < kSamples; ++i) {
      for (int j = 0; i + j < kSamples; ++j) {
        const double u = (i + 1.0 / 3.0) / kSamples;
        const double v = (j + 1.0 / 3.0) / kSamples;
        const Vec2 p = centre + u * (a - centre) + v * (b - centre);
        const auto found = depths.depth(p);
        const double depth = found ? *found : depths.nearest_depth(p);
        sum += depth;
        ++count;
        result.min = std::min(result.min, depth);
        result.max = std::max(result.max, depth);
      }
    }
    weighted += area * sum / count;
    result.area += area;
  }
  result.mean = result.area > 0.0 ? weighted / result.area : result.min;
  return result;
}

std::vector<double> band_limits(const DepthBands& bands, double shoalest, double deepest) {
  if (!bands.limits.empty()) {
    if (!std::is_sorted(bands.limits.begin(), bands.limits.end(), std::less_equal<>())) {
      throw UsageError("<depth bands>: the depths between the bands must be ascending");
    }
    return bands.limits;
  }
  if (bands.count < 1) throw UsageError("<depth bands>: at least one band is needed");
  std::vector<double> limits;
  for (int i = 1; i < bands.count; ++i) {
    limits.push_back(shoalest + (deepest - shoalest) * i / bands.count);
  }
  return limits;
}

int band_of(double depth, const std::vector<double>& limits) {
  return static_cast<int>(std::upper_bound(limits.begin(), limits.end(), depth) - limits.begin());
}

/// The regions: connected faces of the same band, numbered by their lowest face.
std::vector<std::uint32_t> label_regions(const std::vector<int>& band,
                                         const std::vector<SharedEdge>& edges) {
  UnionFind regions(band.size());
  for (const SharedEdge& e : edges) {
    if (band[e.face[0]] == band[e.face[1]]) regions.join(e.face[0], e.face[1]);
  }
  return regions.numbered();
}

double edge_length(const PlanarMesh& mesh, const SharedEdge& e) {
  const auto& face = mesh.faces[e.face[0]];
  return (mesh.vertices[face[e.edge[0]]] - mesh.vertices[face[(e.edge[0] + 1) % face.size()]])
      .norm();
}

/// Again and again gives the smallest region under the limit to the neighbour with the longest
/// shared border, until no such region has a neighbour.
void merge_slivers(const PlanarMesh& mesh, const std::vector<SharedEdge>& edges,
                   const std::vector<FaceDepth>& faces, double smallest, std::vector<int>& band) {
  for (;;) {
    const auto region = label_regions(band, edges);
    const std::size_t count =
        region.empty() ? 0 : *std::max_element(region.begin(), region.end()) + 1U;
    std::vector<double> area(count, 0.0);
    for (std::size_t f = 0; f < region.size(); ++f) area[region[f]] += faces[f].area;
    std::vector<std::map<std::uint32_t, double>> border(count);
    for (const SharedEdge& e : edges) {
      const std::uint32_t a = region[e.face[0]];
      const std::uint32_t b = region[e.face[1]];
      if (a == b) continue;
      const double length = edge_length(mesh, e);
      border[a][b] += length;
      border[b][a] += length;
    }
    std::size_t victim = count;
    for (std::size_t r = 0; r < count; ++r) {
      if (area[r] >= smallest || border[r].empty()) continue;
      if (victim == count || area[r] < area[victim]) victim = r;
    }
    if (victim == count) return;
    const auto heir =
        std::max_element(border[victim].begin(), border[victim].end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; })
            ->first;
    const auto donor = std::find(region.begin(), region.end(), heir) - region.begin();
    const int new_band = band[static_cast<std::size_t>(donor)];
    for (std::size_t f = 0; f < region.size(); ++f) {
      if (region[f] == victim) band[f] = new_band;
    }
  }
}

}  // namespace

DepthRegions depth_regions(const PlanarMesh& mesh, const std::vector<SharedEdge>& edges,
                           const DepthQuery& depths, const DepthRegionOptions& options) {
  std::vector<FaceDepth> faces;
  faces.reserve(mesh.faces.size());
  double shoalest = std::numeric_limits<double>::infinity();
  double deepest = 0.0;
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    faces.push_back(face_depth(mesh, f, depths));
    shoalest = std::min(shoalest, faces.back().min);
    deepest = std::max(deepest, faces.back().max);
  }
  DepthRegions result;
  result.band_limits_m = band_limits(options.bands, shoalest, deepest);
  std::vector<int> band(faces.size());
  std::vector<std::size_t> population(result.band_limits_m.size() + 1, 0);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    band[f] = band_of(faces[f].mean, result.band_limits_m);
    ++population[static_cast<std::size_t>(band[f])];
  }
  if (!options.bands.limits.empty()) {
    for (std::size_t b = 0; b < population.size(); ++b) {
      if (population[b] > 0) continue;
      const std::string from = b == 0 ? "0" : fmt::format("{:g}", result.band_limits_m[b - 1]);
      const std::string to =
          b < result.band_limits_m.size() ? fmt::format("{:g}", result.band_limits_m[b]) : "below";
      throw UsageError(fmt::format(
          "<depth bands>: no part of the survey area lies in the band {} to {} m; its depths run "
          "from {:.2f} to {:.2f} m",
          from, to, shoalest, deepest));
    }
  }
  merge_slivers(mesh, edges, faces, options.smallest_region_m2, band);
  result.region_of = label_regions(band, edges);
  const std::size_t count =
      result.region_of.empty()
          ? 0
          : *std::max_element(result.region_of.begin(), result.region_of.end()) + 1U;
  result.regions.resize(count);
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    DepthRegion& region = result.regions[result.region_of[f]];
    if (region.faces.empty()) {
      region.band = band[f];
      region.min_depth_m = faces[f].min;
      region.max_depth_m = faces[f].max;
    }
    region.faces.push_back(f);
    region.area_m2 += faces[f].area;
    region.mean_depth_m += faces[f].area * faces[f].mean;
    region.min_depth_m = std::min(region.min_depth_m, faces[f].min);
    region.max_depth_m = std::max(region.max_depth_m, faces[f].max);
  }
  for (DepthRegion& region : result.regions) region.mean_depth_m /= std::max(region.area_m2, 1e-12);
  return result;
}

Area region_outline(const PlanarMesh& mesh, const DepthRegion& region) {
  // The union of all faces would take the square of their number.
  using DirectedEdge = std::pair<std::uint32_t, std::uint32_t>;
  std::set<DirectedEdge> edges;
  for (const std::uint32_t f : region.faces) {
    const auto& corners = mesh.faces[f];
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const DirectedEdge edge(corners[k], corners[(k + 1) % corners.size()]);
      if (edges.erase({edge.second, edge.first}) == 0) edges.insert(edge);
    }
  }
  // Rings that meet at a corner may be strung together here: the union parts them again.
  std::vector<Ring> rings;
  while (!edges.empty()) {
    const std::uint32_t first = edges.begin()->first;
    Ring ring;
    for (auto at = edges.begin(); at != edges.end();) {
      ring.push_back(mesh.vertices[at->first]);
      const std::uint32_t next = at->second;
      edges.erase(at);
      if (next == first) break;
      at = edges.lower_bound({next, 0});
      if (at != edges.end() && at->first != next) break;
    }
    rings.push_back(std::move(ring));
  }
  return from_rings(rings, true);
}

}  // namespace swathplan
