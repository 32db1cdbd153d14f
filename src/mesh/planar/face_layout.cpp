#include "mesh/planar/face_layout.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/base/error.h"

namespace swathplan {
namespace {

constexpr double kOutlineTolerance = 0.02;  ///< of the size: details that faces do not follow
constexpr int kDirectionBins = 180;         ///< half-degree bins over a right angle

/// The direction that most of the outline follows, modulo a right angle.
double main_direction(const Area& area) {
  std::vector<double> weight(kDirectionBins, 0.0);
  std::vector<double> moment(kDirectionBins, 0.0);
  const double bin = 0.5 * std::numbers::pi / kDirectionBins;
  const auto add = [&](const Ring& ring) {
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
      const Vec2 d = ring[i] - ring[j];
      double angle =
          std::fmod(std::atan2(d.y(), d.x()) + 2.0 * std::numbers::pi, 0.5 * std::numbers::pi);
      // An angle just below a right angle is the same direction as one just above zero.
      if (angle > 0.5 * std::numbers::pi - 0.5 * bin) angle -= 0.5 * std::numbers::pi;
      const auto k = static_cast<std::size_t>(std::max(0.0, std::floor(angle / bin + 0.5))) %
                     static_cast<std::size_t>(kDirectionBins);
      weight[k] += d.norm();
      moment[k] += d.norm() * angle;
    }
  };
  for (const Polygon& polygon : area) {
    add(polygon.outer);
    for (const Ring& hole : polygon.holes) add(hole);
  }
  const auto best =
      static_cast<std::size_t>(std::max_element(weight.begin(), weight.end()) - weight.begin());
  return weight[best] > 0.0 ? moment[best] / weight[best] : 0.0;
}

Ring rotated(const Ring& ring, Angle angle) {
  Ring result;
  result.reserve(ring.size());
  for (const Vec2& p : ring) result.push_back(rotated(p, angle));
  return result;
}

Area rotated(const Area& area, Angle angle) {
  Area result;
  for (const Polygon& polygon : area) {
    Polygon turned{rotated(polygon.outer, angle), {}};
    for (const Ring& hole : polygon.holes) turned.holes.push_back(rotated(hole, angle));
    result.push_back(std::move(turned));
  }
  return result;
}

/// The area whose outline the faces follow. It lies inside the given one and has no details under
/// the tolerance, so that a staircase of grid cells does not make a staircase of faces. Channels
/// that this would close are added again with a finer tolerance.
Area outline_for_faces(const Area& area, double size) {
  const double fine = 0.1 * kOutlineTolerance * size;
  const double coarse = kOutlineTolerance * size;
  const auto inside = [&](double e) { return simplify(offset(area, -e), 0.9 * e); };
  Area result = inside(coarse);
  Area lost = subtract(area, offset(result, 3.0 * coarse));
  if (!lost.empty()) {
    result = unite(result, intersect(inside(fine), offset(lost, 4.0 * coarse)));
    result = simplify(result, 0.5 * fine);
  }
  return intersect(result, area);
}

}  // namespace

Vec2 rotated(const Vec2& p, Angle by) {
  const double c = std::cos(by.rad());
  const double s = std::sin(by.rad());
  return {c * p.x() - s * p.y(), s * p.x() + c * p.y()};
}

double fitted_step(double length, double wanted) {
  return length / std::max(1.0, std::round(length / wanted));
}

FaceLayout face_layout(const Area& area, double size_m, Angle turn) {
  if (area.empty()) throw InvalidInput("the survey area is empty: there is nothing to mesh");
  const Angle by =
      Angle::radians(main_direction(simplify(area, kOutlineTolerance * size_m)) + turn.rad());
  return {rotated(outline_for_faces(area, size_m), -by), by};
}

void require_faces(const PlanarMesh& mesh) {
  if (!mesh.faces.empty()) return;
  throw InvalidInput(
      "the survey area is too small for a single face; use a finer <resolution> or a larger area");
}

}  // namespace swathplan
