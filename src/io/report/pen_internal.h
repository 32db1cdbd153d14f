#pragma once

#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "mesh/plane/box.h"
#include "mesh/plane/polygons.h"

namespace swathplan::internal {

/// Writes local metres as the page's whole centimetres from the lower-left corner of the map.
class Pen {
 public:
  explicit Pen(const Box2& box) : box_(box) {}

  /// [x, y, dx, dy, ...]: each point is given by its step from the one before.
  [[nodiscard]] nlohmann::ordered_json line(const std::vector<Vec2>& points) const;
  /// The rings of an area, closed; points within `tolerance_m` of what remains are left out, and
  /// with them rings that are no larger.
  [[nodiscard]] nlohmann::ordered_json rings(const Area& area, double tolerance_m) const;
  [[nodiscard]] nlohmann::ordered_json edges(const std::vector<std::pair<Vec2, Vec2>>& list) const;
  /// [x0, y0, x1, y1].
  [[nodiscard]] nlohmann::ordered_json box(const Box2& b) const;

 private:
  [[nodiscard]] nlohmann::ordered_json ring(const Ring& points, double tolerance_m) const;

  Box2 box_;
};

/// The points of a line that stay: the first, the last and those that Douglas-Peucker keeps.
[[nodiscard]] std::vector<Vec2> simplified(const std::vector<Vec2>& line, double tolerance_m);

/// Metres, degrees and so on with so many digits behind the point, so that the page stays small.
[[nodiscard]] double rounded(double value, int decimals = 2);

}  // namespace swathplan::internal
