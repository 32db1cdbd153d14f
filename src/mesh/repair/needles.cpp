#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "mesh/edge_table.h"
#include "mesh/repair/needles_internal.h"

namespace swathplan {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Face = Seafloor::Face;

/// Needles beside needles take one pass each. Needles that are left after so many passes are simply
/// dropped.
constexpr int kMostPasses = 32;

bool is_needle(const Seafloor& s, const Face& f) {
  const auto point = [&](std::uint32_t v) {
    const Vec3& p = s.vertices[v];
    return Kernel::Point_3(p.x(), p.y(), p.z());
  };
  return CGAL::collinear(point(f[0]), point(f[1]), point(f[2]));
}

/// The corner opposite to the longest edge. In a needle it lies on that edge.
std::size_t middle_corner(const Seafloor& s, const Face& f) {
  std::array<double, 3> opposite{};
  for (std::size_t i = 0; i < 3; ++i) {
    opposite.at(i) = (s.vertices[f.at((i + 1) % 3)] - s.vertices[f.at((i + 2) % 3)]).squaredNorm();
  }
  return static_cast<std::size_t>(std::max_element(opposite.begin(), opposite.end()) -
                                  opposite.begin());
}

/// Finds the other face at the edge from corner `corner` of face `f`; none unless there is exactly
/// one.
class Neighbours {
 public:
  explicit Neighbours(const Seafloor& mesh)
      : faces_(mesh.faces), uses_(edge_uses(mesh.faces, mesh.vertices.size())) {}

  [[nodiscard]] const EdgeUse* across(std::uint32_t f, std::size_t corner) const {
    const std::uint32_t a = faces_[f].at(corner);
    const std::uint32_t b = faces_[f].at((corner + 1) % 3);
    const EdgeUse key{std::min(a, b), std::max(a, b), 0, 0, false};
    const auto [first, last] =
        std::equal_range(uses_.begin(), uses_.end(), key, [](const EdgeUse& p, const EdgeUse& q) {
          return p.low != q.low ? p.low < q.low : p.high < q.high;
        });
    if (last - first != 2) return nullptr;
    return first->face == f ? &*(first + 1) : &*first;
  }

 private:
  const std::vector<Face>& faces_;
  std::vector<EdgeUse> uses_;
};

/// One pass. Takes every needle whose neighbourhood has not changed yet in this pass.
void take_needles(Seafloor& mesh) {
  const Neighbours neighbours(mesh);
  std::vector<bool> changed(mesh.faces.size(), false);
  std::vector<bool> dropped(mesh.faces.size(), false);
  std::vector<Face> cut;
  std::vector<std::pair<std::uint32_t, Face>> replaced;
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    if (changed[f] || !is_needle(mesh, mesh.faces[f])) continue;
    const std::size_t middle = middle_corner(mesh, mesh.faces[f]);
    const std::uint32_t b = mesh.faces[f].at(middle);
    const EdgeUse* across = neighbours.across(f, (middle + 1) % 3);
    if (across != nullptr && changed[across->face]) continue;
    changed[f] = dropped[f] = true;
    if (across == nullptr) continue;
    const Face other = mesh.faces[across->face];
    const std::uint32_t p = other.at(across->corner);
    const std::uint32_t q = other.at((across->corner + 1U) % 3U);
    const std::uint32_t tip = other.at((across->corner + 2U) % 3U);
    changed[across->face] = true;
    if (tip == b) {  // the same three corners from the other side: both go
      dropped[across->face] = true;
      continue;
    }
    replaced.push_back({across->face, Face{p, b, tip}});
    cut.push_back({b, q, tip});
  }
  for (const auto& [face, with] : replaced) mesh.faces[face] = with;
  std::size_t kept = 0;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    if (!dropped[f]) mesh.faces[kept++] = mesh.faces[f];
  }
  mesh.faces.resize(kept);
  mesh.faces.insert(mesh.faces.end(), cut.begin(), cut.end());
}

}  // namespace

std::size_t drop_needles(Seafloor& mesh) {
  const auto needle = [&](const Face& f) { return is_needle(mesh, f); };
  const auto found = std::count_if(mesh.faces.begin(), mesh.faces.end(), needle);
  for (int pass = 0; pass < kMostPasses; ++pass) {
    if (std::none_of(mesh.faces.begin(), mesh.faces.end(), needle)) break;
    take_needles(mesh);
  }
  std::erase_if(mesh.faces, needle);
  return static_cast<std::size_t>(found);
}

}  // namespace swathplan
