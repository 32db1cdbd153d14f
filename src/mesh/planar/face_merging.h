#pragma once

#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "mesh/planar/planar_mesh.h"

namespace swathplan {

/// True if NUC can walk the face. The mean of the corners must see every side, the centroid of each
/// sub-facet its whole sub-facet, and an arc around a reflex corner must stay inside. Convex faces
/// are sound, slightly hollow ones may be. In a sound face the links of a skeleton lie in separate
/// parts of the face, so the skeleton does not cross itself.
[[nodiscard]] bool sound_for_nuc(const PlanarMesh& mesh, const PlanarMesh::Face& face);

struct MergeLimits {
  double small_m2 = 0.0;    ///< faces under this join a neighbour
  double largest_m2 = 0.0;  ///< no face grows beyond this
  double longest_m = 0.0;   ///< no two corners of a face come to lie farther apart
};

/// Joins faces of a conforming polygon mesh into larger ones that are sound for NUC. The mesh stays
/// conforming: a corner on a straight side is dropped if at most one face lies on either side of
/// it.
class FaceMerging {
 public:
  explicit FaceMerging(PlanarMesh mesh);

  /// Takes away edges (pairs of vertices), in their order, where the two faces beside an edge make
  /// a sound one. Ends when no more edge can be taken.
  void take_away(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& edges);

  /// Joins each small face, the smallest first, with the neighbour that has the longest common
  /// edge. Only neighbours count with which it makes a sound face within the limits.
  void join_small(const MergeLimits& limits);

  /// The mesh after the merges, its faces sorted by their centroid (y, then x). Faces without area,
  /// which come from rounding, are left out.
  [[nodiscard]] PlanarMesh result() const;

 private:
  using Face = PlanarMesh::Face;
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;

  [[nodiscard]] std::uint32_t face_of(std::uint32_t a, std::uint32_t b) const;
  [[nodiscard]] Face joined(std::uint32_t f, std::uint32_t g) const;
  [[nodiscard]] std::vector<std::uint32_t> neighbours(std::uint32_t f) const;
  [[nodiscard]] double extent(const Face& face) const;
  bool merge(std::uint32_t f, std::uint32_t g, const MergeLimits* limits);
  void replace(std::uint32_t f, Face face);
  void drop_if_straight(std::uint32_t v, std::uint32_t f);

  PlanarMesh mesh_;
  std::unordered_map<std::uint64_t, std::uint32_t> side_;  ///< from corner to corner -> its face
  std::vector<std::uint32_t> uses_;                        ///< faces at a vertex
};

}  // namespace swathplan
