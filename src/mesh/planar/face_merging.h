#pragma once

#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "mesh/planar/planar_mesh.h"

namespace swathplan {

/// True if NUC can walk the face: the corners' mean sees every side, each sub-facet's centroid
/// sees its whole sub-facet, and an arc around a reflex corner stays inside. Convex faces are
/// sound; slightly hollow ones may be. Then the links of a skeleton lie in disjoint parts of the
/// face, so that it does not cross itself.
[[nodiscard]] bool sound_for_nuc(const PlanarMesh& mesh, const PlanarMesh::Face& face);

struct MergeLimits {
  double small_m2 = 0.0;    ///< faces under this look for a neighbour
  double largest_m2 = 0.0;  ///< none grows beyond this
  double longest_m = 0.0;   ///< nor two of its corners farther apart than this
};

/// Joins faces of a conforming polygon mesh into larger ones that are sound for NUC, and keeps it
/// conforming: a corner that ends up on a straight side with no more than a face on either side of
/// it goes.
class FaceMerging {
 public:
  explicit FaceMerging(PlanarMesh mesh);

  /// Takes away the edges (pairs of vertices), in their order, where the two faces along them make
  /// a sound one, until no more of them can go.
  void take_away(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& edges);

  /// Smallest first, gives each small face to the neighbour with the longest common edge among
  /// those that it makes a sound face with within the limits.
  void join_small(const MergeLimits& limits);

  /// The mesh without what was merged away, faces by their centroid (y, then x). Faces without
  /// area, as rounding leaves them, are left out.
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
