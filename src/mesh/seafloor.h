#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "mesh/base/angle.h"
#include "mesh/base/frame.h"
#include "mesh/plane/box.h"

namespace swathplan {

/// The seafloor as a triangle mesh in the local frame (see frame.h): one sheet as seen from above.
/// After import these hold: indices are in range; coordinates are finite; every face has area; a
/// face that is not vertical runs counter-clockwise as seen from above; every vertex has z <= 0.
struct Seafloor {
  using Face = std::array<std::uint32_t, 3>;
  std::vector<Vec3> vertices;
  std::vector<Face> faces;
  Frame frame;
};

[[nodiscard]] Box2 extent(const Seafloor& seafloor);

/// Area of all faces as seen from above, square metres; faces above each other count twice.
[[nodiscard]] double plan_area_m2(const Seafloor& seafloor);

/// Range and plan-area-weighted mean of the depths (metres, positive down).
struct DepthRange {
  double min = 0.0, mean = 0.0, max = 0.0;
};
/// @throws InvalidInput if no face has a plan area.
[[nodiscard]] DepthRange depth_range(const Seafloor& seafloor);

/// Answers "how deep is it here?" in about O(1) a query. It sorts the faces into buckets in plan.
/// It keeps a reference: the seafloor must outlive it.
class DepthQuery {
 public:
  explicit DepthQuery(const Seafloor& seafloor);
  ~DepthQuery();
  DepthQuery(DepthQuery&&) noexcept;
  DepthQuery& operator=(DepthQuery&&) noexcept;

  /// Of the seafloor.
  [[nodiscard]] const Box2& extent() const;
  /// Depth below `p`, metres, positive down. Where faces lie above each other it is the shoalest.
  /// Empty where there is no seafloor.
  [[nodiscard]] std::optional<double> depth(const Vec2& p) const;
  /// The face below `p` (the shoalest), if any.
  [[nodiscard]] std::optional<std::uint32_t> face(const Vec2& p) const;
  /// Depth at the nearest vertex of the seafloor, for points just beyond the mesh.
  [[nodiscard]] double nearest_depth(const Vec2& p) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Slope of a face against the horizontal, [0, 90] degrees.
[[nodiscard]] Angle slope(const Seafloor& seafloor, std::uint32_t face);

}  // namespace swathplan
