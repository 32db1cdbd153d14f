#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "mesh/plane/polygons.h"

namespace swathplan {

/// An area prepared for many questions. Its edges lie in a grid of buckets, so that a question
/// about a point costs about O(1), and one about a segment O(its length). Keeps what it needs; the
/// area itself need not live on.
class AreaQuery {
 public:
  explicit AreaQuery(const Area& area);
  ~AreaQuery();
  AreaQuery(AreaQuery&&) noexcept;
  AreaQuery& operator=(AreaQuery&&) noexcept;

  /// True inside or within kOnOutline of the outline.
  [[nodiscard]] bool contains(const Vec2& p) const;
  /// Distance to the nearest outline, metres; infinite for an empty area.
  [[nodiscard]] double distance(const Vec2& p) const;
  /// Nearest point of the outline; p itself for an empty area.
  [[nodiscard]] Vec2 nearest_on_outline(const Vec2& p) const;
  /// Metres of the segment a-b in the area or on its outline; 0 for an empty area.
  [[nodiscard]] double inside_length(const Vec2& a, const Vec2& b) const;
  /// The parts of the segment a-b inside the area, as parameter intervals in [0, 1], sorted.
  [[nodiscard]] std::vector<std::pair<double, double>> clip(const Vec2& a, const Vec2& b) const;

  /// A point nearer than this to the outline counts as on it, metres. The corners of areas lie on
  /// the lattice of polygons.h, and points computed from them are rounded.
  static constexpr double kOnOutline = 2.0 * kLattice;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace swathplan
