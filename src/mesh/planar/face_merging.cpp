#include "mesh/planar/face_merging.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "mesh/plane/segments.h"

namespace swathplan {
namespace {

/// A point nearer than this counts as on a line, metres. Survey coordinates round by less.
constexpr double kOnLine = 1e-6;
/// A smaller face comes from rounding between two lines, square metres.
constexpr double kNoArea = 1e-6;
/// A corner that turns to the right by less than this counts as straight, as a sine.
constexpr double kStraightTurn = 1e-6;
/// An arc around a sub-facet's centroid goes at most 0.59 of the way to the chord of its ends. Half
/// of that way is safe: no chord between two sides passes a reflex corner by more than the arc
/// keeps.
constexpr double kReflexShare = 0.5;

/// Metres that p lies left of the line from a to b.
double left_of(const Vec2& a, const Vec2& b, const Vec2& p) {
  const double length = (b - a).norm();
  return length > 0.0 ? cross(b - a, p - a) / length : 0.0;
}

std::uint64_t key(std::uint32_t a, std::uint32_t b) { return (std::uint64_t{a} << 32) | b; }

/// A sub-facet of a face: corner, the two midpoints beside it, and where its centroid lies.
struct SubFacet {
  Vec2 before, corner, after, centroid;
};

/// Whether the links of the cycle pass between `centre` and the corner and stay in the sub-facet.
bool sees_its_own(const SubFacet& s, const Vec2& centre) {
  if (left_of(s.before, s.corner, s.centroid) <= kOnLine) return false;
  if (left_of(s.corner, s.after, s.centroid) <= kOnLine) return false;
  return cross(s.before - centre, s.centroid - centre) > 0.0 &&
         cross(s.centroid - centre, s.after - centre) > 0.0;
}

/// True if an arc around the sub-facet's centroid, from half-edge to half-edge, stays on its side
/// of the corner.
bool arcs_stay(const SubFacet& s) {
  const Vec2 in = s.corner - s.before;
  const Vec2 out = s.after - s.corner;
  const double lengths = in.norm() * out.norm();
  if (cross(in, out) >= -kStraightTurn * lengths) return true;
  const double half_turn = std::sqrt(std::max(0.0, 0.5 * (1.0 - in.dot(out) / lengths)));
  return std::max(in.norm(), out.norm()) * half_turn <=
         kReflexShare * (s.centroid - s.corner).norm();
}

}  // namespace

bool sound_for_nuc(const PlanarMesh& mesh, const PlanarMesh::Face& face) {
  const std::size_t n = face.size();
  if (n < 3) return false;
  const auto corner = [&](std::size_t k) -> const Vec2& { return mesh.vertices[face[k % n]]; };
  Vec2 centre = Vec2::Zero();
  for (std::size_t k = 0; k < n; ++k) centre += corner(k) / static_cast<double>(n);
  std::vector<Vec2> cycle;
  for (std::size_t k = 0; k < n; ++k) {
    if (left_of(corner(k), corner(k + 1), centre) <= kOnLine) return false;
    SubFacet s{0.5 * (corner(k + n - 1) + corner(k)), corner(k), 0.5 * (corner(k) + corner(k + 1)),
               Vec2::Zero()};
    s.centroid = 0.25 * (s.before + s.corner + s.after + centre);
    if (!sees_its_own(s, centre) || !arcs_stay(s)) return false;
    cycle.push_back(s.centroid);
  }
  for (std::size_t k = 0; k < n; ++k) {
    if (!(cross(cycle[k] - centre, cycle[(k + 1) % n] - centre) > 0.0)) return false;
  }
  return true;
}

FaceMerging::FaceMerging(PlanarMesh mesh)
    : mesh_(std::move(mesh)), uses_(mesh_.vertices.size(), 0) {
  for (std::uint32_t f = 0; f < mesh_.faces.size(); ++f) {
    Face face = std::move(mesh_.faces[f]);
    mesh_.faces[f].clear();
    replace(f, std::move(face));
  }
}

std::uint32_t FaceMerging::face_of(std::uint32_t a, std::uint32_t b) const {
  const auto at = side_.find(key(a, b));
  return at == side_.end() ? kNone : at->second;
}

void FaceMerging::replace(std::uint32_t f, Face face) {
  const Face& old = mesh_.faces[f];
  for (std::size_t k = 0; k < old.size(); ++k) {
    side_.erase(key(old[k], old[(k + 1) % old.size()]));
    --uses_[old[k]];
  }
  for (std::size_t k = 0; k < face.size(); ++k) {
    side_[key(face[k], face[(k + 1) % face.size()])] = f;
    ++uses_[face[k]];
  }
  mesh_.faces[f] = std::move(face);
}

/// The outline of both faces together; empty if they do not meet along one unbroken run of edges.
FaceMerging::Face FaceMerging::joined(std::uint32_t f, std::uint32_t g) const {
  const Face& a = mesh_.faces[f];
  const Face& b = mesh_.faces[g];
  const std::size_t n = a.size();
  const auto shared = [&](std::size_t k) { return face_of(a[(k + 1) % n], a[k % n]) == g; };
  std::size_t begin = n;
  for (std::size_t k = 0; k < n; ++k) {
    if (!shared(k) || shared(k + n - 1)) continue;
    if (begin != n) return {};
    begin = k;
  }
  if (begin == n) return {};
  std::size_t end = begin;
  while (shared(end)) ++end;
  Face face;
  for (std::size_t k = end; k <= begin + n; ++k) face.push_back(a[k % n]);
  const auto from = static_cast<std::size_t>(std::find(b.begin(), b.end(), a[begin]) - b.begin());
  for (std::size_t k = from + 1; b[k % b.size()] != a[end % n]; ++k) {
    face.push_back(b[k % b.size()]);
  }
  if (std::set<std::uint32_t>(face.begin(), face.end()).size() != face.size()) return {};
  return face;
}

double FaceMerging::extent(const Face& face) const {
  double longest = 0.0;
  for (const std::uint32_t a : face) {
    for (const std::uint32_t b : face) {
      longest = std::max(longest, (mesh_.vertices[a] - mesh_.vertices[b]).norm());
    }
  }
  return longest;
}

bool FaceMerging::merge(std::uint32_t f, std::uint32_t g, const MergeLimits* limits) {
  Face face = joined(f, g);
  if (!sound_for_nuc(mesh_, face)) return false;
  if (limits != nullptr) {
    if (face_area(mesh_, f) + face_area(mesh_, g) > limits->largest_m2) return false;
    if (extent(face) > limits->longest_m) return false;
  }
  // At the ends of the run of shared edges, corners may have become straight.
  std::vector<std::uint32_t> ends;
  for (const std::uint32_t v : mesh_.faces[g]) {
    const auto in = [&](const Face& of) { return std::find(of.begin(), of.end(), v) != of.end(); };
    if (in(mesh_.faces[f]) && in(face)) ends.push_back(v);
  }
  replace(g, {});
  replace(f, std::move(face));
  for (const std::uint32_t v : ends) drop_if_straight(v, f);
  return true;
}

void FaceMerging::drop_if_straight(std::uint32_t v, std::uint32_t f) {
  const Face& face = mesh_.faces[f];
  const std::size_t n = face.size();
  const auto k = static_cast<std::size_t>(std::find(face.begin(), face.end(), v) - face.begin());
  const std::uint32_t before = face[(k + n - 1) % n];
  const std::uint32_t after = face[(k + 1) % n];
  const Vec2& a = mesh_.vertices[before];
  const Vec2& b = mesh_.vertices[after];
  if (std::abs(left_of(a, b, mesh_.vertices[v])) > kOnLine) return;
  if (!((mesh_.vertices[v] - a).dot(b - mesh_.vertices[v]) > 0.0)) return;
  const std::uint32_t beyond = face_of(v, before);
  if (beyond != face_of(after, v) || uses_[v] != (beyond == kNone ? 1U : 2U)) return;
  const auto without = [&](const Face& of) {
    Face rest = of;
    std::erase(rest, v);
    return rest;
  };
  Face here = without(face);
  if (!sound_for_nuc(mesh_, here)) return;
  if (beyond != kNone) {
    Face there = without(mesh_.faces[beyond]);
    if (!sound_for_nuc(mesh_, there)) return;
    replace(beyond, std::move(there));
  }
  replace(f, std::move(here));
}

void FaceMerging::take_away(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& edges) {
  for (bool again = true; again;) {
    again = false;
    for (const auto& [a, b] : edges) {
      const std::uint32_t f = face_of(a, b);
      const std::uint32_t g = face_of(b, a);
      if (f == kNone || g == kNone || f == g) continue;
      if (merge(f, g, nullptr)) again = true;
    }
  }
}

/// The neighbours along edges, the one with the longest common edge first.
std::vector<std::uint32_t> FaceMerging::neighbours(std::uint32_t f) const {
  const Face& face = mesh_.faces[f];
  std::map<std::uint32_t, double> common;
  for (std::size_t k = 0; k < face.size(); ++k) {
    const std::uint32_t a = face[k];
    const std::uint32_t b = face[(k + 1) % face.size()];
    const std::uint32_t g = face_of(b, a);
    if (g != kNone) common[g] += (mesh_.vertices[a] - mesh_.vertices[b]).norm();
  }
  std::vector<std::uint32_t> result;
  result.reserve(common.size());
  for (const auto& [g, length] : common) result.push_back(g);
  std::stable_sort(result.begin(), result.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return common[a] > common[b]; });
  return result;
}

void FaceMerging::join_small(const MergeLimits& limits) {
  for (bool again = true; again;) {
    again = false;
    std::set<std::pair<double, std::uint32_t>> small;
    const auto look_at = [&](std::uint32_t f) {
      const double area = face_area(mesh_, f);
      if (area < limits.small_m2) small.emplace(area, f);
    };
    for (std::uint32_t f = 0; f < mesh_.faces.size(); ++f) {
      if (!mesh_.faces[f].empty()) look_at(f);
    }
    while (!small.empty()) {
      const std::uint32_t f = small.begin()->second;
      small.erase(small.begin());
      for (const std::uint32_t g : neighbours(f)) {
        const double area = face_area(mesh_, g);
        if (!merge(f, g, &limits)) continue;
        small.erase({area, g});
        look_at(f);
        again = true;
        break;
      }
    }
  }
}

PlanarMesh FaceMerging::result() const {
  std::vector<std::pair<Vec2, std::uint32_t>> order;
  for (std::uint32_t f = 0; f < mesh_.faces.size(); ++f) {
    if (mesh_.faces[f].empty() || face_area(mesh_, f) < kNoArea) continue;
    order.emplace_back(face_centroid(mesh_, f), f);
  }
  std::sort(order.begin(), order.end(), [](const auto& a, const auto& b) {
    return std::pair(a.first.y(), a.first.x()) < std::pair(b.first.y(), b.first.x());
  });
  PlanarMesh mesh;
  std::vector<std::uint32_t> vertex(mesh_.vertices.size(), kNone);
  for (const auto& [centre, f] : order) {
    Face face;
    for (const std::uint32_t v : mesh_.faces[f]) {
      if (vertex[v] == kNone) {
        vertex[v] = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.push_back(mesh_.vertices[v]);
      }
      face.push_back(vertex[v]);
    }
    mesh.faces.push_back(std::move(face));
  }
  return mesh;
}

}  // namespace swathplan
