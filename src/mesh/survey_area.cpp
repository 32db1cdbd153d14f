#include "mesh/survey_area.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <unordered_map>

#include "mesh/base/error.h"
#include "mesh/edge_table.h"
#include "mesh/water_level.h"

namespace swathplan {
namespace {

/// Smaller pieces come from the rounding of the clipping lattice, square metres.
constexpr double kDustM2 = 1e-3;

/// Edges that no face runs through in the opposite direction, in the order of the faces. An edge
/// from a vertex to itself is its own opposite.
std::vector<EdgeUse> one_way_edges(const Seafloor& seafloor) {
  std::vector<EdgeUse> border;
  for_each_edge(edge_uses(seafloor.faces, seafloor.vertices.size()), [&](const auto& edge) {
    const EdgeUse& first = edge.front();
    const bool one_way = std::all_of(
        edge.begin(), edge.end(), [&](const EdgeUse& use) { return use.ascends == first.ascends; });
    if (one_way && first.low != first.high) border.insert(border.end(), edge.begin(), edge.end());
  });
  std::sort(border.begin(), border.end(), [](const EdgeUse& a, const EdgeUse& b) {
    return std::pair(a.face, a.corner) < std::pair(b.face, b.corner);
  });
  return border;
}

/// The border edges of the mesh, joined end to begin into rings.
std::vector<Ring> boundary_rings(const Seafloor& seafloor) {
  std::unordered_multimap<std::uint32_t, std::uint32_t> next;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> border;
  for (const EdgeUse& use : one_way_edges(seafloor)) {
    border.emplace_back(use.ascends ? use.low : use.high, use.ascends ? use.high : use.low);
    next.insert(border.back());
  }
  std::vector<Ring> rings;
  for (const auto& [a0, b0] : border) {
    const auto range = next.equal_range(a0);
    const auto here = std::find_if(range.first, range.second,
                                   [end = b0](const auto& e) { return e.second == end; });
    if (here == range.second) continue;
    next.erase(here);
    Ring ring{seafloor.vertices[a0].head<2>()};
    for (std::uint32_t at = b0; at != a0;) {
      ring.push_back(seafloor.vertices[at].head<2>());
      const auto onward = next.find(at);
      if (onward == next.end()) break;
      at = onward->second;
      next.erase(onward);
    }
    rings.push_back(std::move(ring));
  }
  return rings;
}

Area without_dust(Area area) {
  std::erase_if(area, [](const Polygon& polygon) { return area_m2({polygon}) < kDustM2; });
  return area;
}

}  // namespace

Area outline(const Seafloor& seafloor) {
  return without_dust(from_rings(boundary_rings(seafloor), true));
}

Area above_level(const Seafloor& seafloor, double z) {
  const auto is_above = [&](std::uint32_t v) { return seafloor.vertices[v].z() > z; };
  // What is above lies below in the mirror, and only faces that reach above count.
  Seafloor mirrored;
  mirrored.vertices = seafloor.vertices;
  for (Vec3& v : mirrored.vertices) v.z() = -v.z();
  std::copy_if(
      seafloor.faces.begin(), seafloor.faces.end(), std::back_inserter(mirrored.faces),
      [&](const Seafloor::Face& face) { return std::any_of(face.begin(), face.end(), is_above); });
  return outline(below_level(mirrored, -z));
}

Area survey_area(const Seafloor& seafloor, const SurveyAreaOptions& options) {
  const bool shoal = options.safe_depth_m > 0.0;
  Area area = shoal ? outline(below_level(seafloor, -options.safe_depth_m)) : outline(seafloor);
  if (area.empty()) {
    throw InvalidInput(
        fmt::format("no water is as deep as {:.2f} m (draft + under-keel margin); lower <draft> or "
                    "<margin>, or check <water level> and <z positive>",
                    options.safe_depth_m));
  }
  if (options.limit) {
    area = without_dust(intersect(area, *options.limit));
    if (area.empty()) {
      throw InvalidInput(
          "the survey area polygon does not meet water that is deep enough; check its CRS and "
          "place");
    }
  }
  if (!options.no_go.empty()) {
    area = without_dust(subtract(area, options.no_go));
    if (area.empty()) throw InvalidInput("the no-go polygons cover the whole survey area");
  }
  return area;
}

Area shoal_ground(const Seafloor& seafloor, const SurveyAreaOptions& options) {
  const double level = -options.safe_depth_m;
  const auto is_shoal = [&](const Vec3& vertex) { return vertex.z() > level; };
  if (!(options.safe_depth_m > 0.0) ||
      std::none_of(seafloor.vertices.begin(), seafloor.vertices.end(), is_shoal)) {
    return {};
  }
  // The seafloor's own outlines first. Two survey areas share all corners of a shoreline, and
  // Clipper's cost is quadratic in edges that lie on one another.
  Area shoal = without_dust(subtract(outline(seafloor), outline(below_level(seafloor, level))));
  if (shoal.empty()) return shoal;
  if (options.limit) shoal = intersect(shoal, *options.limit);
  return without_dust(subtract(shoal, options.no_go));
}

}  // namespace swathplan
