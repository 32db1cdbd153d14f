#include "mesh/survey_area.h"

#include <fmt/format.h>

#include <unordered_map>

#include "mesh/base/error.h"
#include "mesh/water_level.h"

namespace swathplan {
namespace {

/// Leftovers under this size are dust of the clipping lattice, square metres.
constexpr double kDustM2 = 1e-3;

struct EdgeHash {
  std::size_t operator()(const std::pair<std::uint32_t, std::uint32_t>& e) const {
    return std::hash<std::uint64_t>()((static_cast<std::uint64_t>(e.first) << 32) | e.second);
  }
};

/// Directed border edges of the mesh, joined head to tail into rings.
std::vector<Ring> boundary_rings(const Seafloor& seafloor) {
  std::unordered_map<std::pair<std::uint32_t, std::uint32_t>, int, EdgeHash> directed;
  directed.reserve(seafloor.faces.size() * 3);
  for (const auto& f : seafloor.faces) {
    for (std::size_t k = 0; k < 3; ++k) ++directed[{f[k], f[(k + 1) % 3]}];
  }
  // In the order of the faces, so that the rings do not depend on the hash.
  std::unordered_multimap<std::uint32_t, std::uint32_t> next;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> border;
  for (const auto& f : seafloor.faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = f[k];
      const std::uint32_t b = f[(k + 1) % 3];
      if (directed.contains({b, a})) continue;
      border.emplace_back(a, b);
      next.emplace(a, b);
    }
  }
  std::vector<Ring> rings;
  for (const auto& [a0, b0] : border) {
    const auto range = next.equal_range(a0);
    const auto here =
        std::find_if(range.first, range.second, [&](const auto& e) { return e.second == b0; });
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

Area survey_area(const Seafloor& seafloor, const SurveyAreaOptions& options) {
  const bool shoal = options.safe_depth_m > 0.0;
  Area area = shoal ? outline(below_level(seafloor, -options.safe_depth_m)) : outline(seafloor);
  if (area.empty()) {
    throw InvalidInput(
        fmt::format("no water is as deep as {:.2f} m (draft + under-keel margin); lower --draft or "
                    "--margin, or "
                    "check --water-level and --z-positive",
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

}  // namespace swathplan
