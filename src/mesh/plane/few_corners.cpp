#include "mesh/plane/few_corners.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <polyclipping/clipper.hpp>
#include <utility>

#include "mesh/plane/unite_in_halves_internal.h"

namespace swathplan {
namespace {

/// Corners that a chord may try beyond the last one that it may end at.
constexpr std::size_t kLookAhead = 64;
/// Shares of the tolerance: the rings lie this near to their chords, and a chord's rectangle
/// reaches this far to every side. Its corner is sqrt(2) times as far off, so that the sum stays
/// under 1. The difference keeps the band's border off the ring.
constexpr double kChordShare = 0.35;
constexpr double kBandShare = 0.4;

/// The directions from a corner in which a chord stays near all corners passed so far.
class Cone {
 public:
  [[nodiscard]] bool holds(double angle) const {
    return whole_ || (turn(angle) >= low_ && turn(angle) <= high_);
  }
  /// Narrows to `half` on either side of `angle`; false if nothing is left.
  bool narrow(double angle, double half) {
    if (whole_) {
      whole_ = false;
      centre_ = angle;
      low_ = -half;
      high_ = half;
      return true;
    }
    low_ = std::max(low_, turn(angle) - half);
    high_ = std::min(high_, turn(angle) + half);
    return low_ <= high_;
  }

 private:
  [[nodiscard]] double turn(double angle) const {
    return std::remainder(angle - centre_, 2.0 * std::numbers::pi);
  }
  bool whole_ = true;
  double centre_ = 0.0, low_ = 0.0, high_ = 0.0;
};

/// The last corner that a chord from `first` may end at; corners are counted on past the ring's
/// end.
std::size_t chord_end(const Ring& ring, std::size_t first, double within_m) {
  const std::size_t n = ring.size();
  Cone cone;
  double farthest = 0.0;
  std::size_t end = first + 1;
  for (std::size_t k = first + 1; k <= n && k <= end + kLookAhead; ++k) {
    const Vec2 away = ring[k % n] - ring[first];
    const double distance = away.norm();
    const double angle = std::atan2(away.y(), away.x());
    // A corner farther off than the chord's end could lie beyond it.
    if (distance >= farthest && cone.holds(angle)) end = k;
    farthest = std::max(farthest, distance);
    if (distance > within_m && !cone.narrow(angle, std::asin(within_m / distance))) break;
  }
  return end;
}

ClipperLib::Path rectangle(const Vec2& a, const Vec2& b, double reach) {
  const double length = (b - a).norm();
  const Vec2 u = length > 0.0 ? Vec2((b - a) / length) : Vec2(Vec2::UnitX());
  const Vec2 along = reach * u;
  const Vec2 left(-along.y(), along.x());
  ClipperLib::Path path;
  for (const Vec2& p : {Vec2(a - along - left), Vec2(b + along - left), Vec2(b + along + left),
                        Vec2(a - along + left)}) {
    path.emplace_back(std::llround(p.x() / kLattice), std::llround(p.y() / kLattice));
  }
  return path;
}

Ring band_ring(const ClipperLib::Path& path, bool counter_clockwise) {
  Ring ring;
  ring.reserve(path.size());
  for (const ClipperLib::IntPoint& p : path) {
    ring.emplace_back(static_cast<double>(p.X) * kLattice, static_cast<double>(p.Y) * kLattice);
  }
  if ((signed_area(ring) > 0.0) != counter_clockwise) std::reverse(ring.begin(), ring.end());
  return ring;
}

/// Even-odd over all rings; for points that lie off them.
bool surrounded(const std::vector<Ring>& rings, const Vec2& p) {
  bool inside = false;
  for (const Ring& ring : rings) {
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
      const Vec2& a = ring[j];
      const Vec2& b = ring[i];
      if ((a.y() > p.y()) == (b.y() > p.y())) continue;
      if (a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()) > p.x()) inside = !inside;
    }
  }
  return inside;
}

/// Builds the two areas of a bracket from the pieces beside a band.
class BracketBuilder {
 public:
  explicit BracketBuilder(const std::vector<Ring>& original) : original_(original) {}

  /// The bands of a node that lie in the open, each a polygon of its own.
  void open_bands(const ClipperLib::PolyNode& node) {
    for (const ClipperLib::PolyNode* band : node.Childs) {
      const std::size_t at = result_.around.size();
      result_.around.push_back({band_ring(band->Contour, true), {}});
      holes(*band, at);
    }
  }
  Bracket take() { return std::move(result_); }

 private:
  void holes(const ClipperLib::PolyNode& band, std::size_t at) {
    for (const ClipperLib::PolyNode* hole : band.Childs) {
      const Ring border = band_ring(hole->Contour, true);
      if (surrounded(original_, border.front())) {
        Polygon inside{border, {}};
        for (const ClipperLib::PolyNode* inner : hole->Childs) {
          inside.holes.push_back(band_ring(inner->Contour, false));
        }
        result_.within.push_back(std::move(inside));
        for (const ClipperLib::PolyNode* inner : hole->Childs) holes(*inner, at);
      } else {
        result_.around[at].holes.push_back(band_ring(hole->Contour, false));
        open_bands(*hole);
      }
    }
  }

  const std::vector<Ring>& original_;
  Bracket result_;
};

void largest_first(Area& area) {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t k = 0; k < area.size(); ++k) order.emplace_back(-area_m2({area[k]}), k);
  std::sort(order.begin(), order.end());
  Area sorted;
  for (const auto& [size, k] : order) sorted.push_back(std::move(area[k]));
  area = std::move(sorted);
}

}  // namespace

std::size_t corners_of(const std::vector<Ring>& rings) {
  std::size_t corners = 0;
  for (const Ring& ring : rings) corners += ring.size();
  return corners;
}

Ring few_corners(const Ring& ring, double within_m) {
  Ring result;
  for (std::size_t k = 0; k < ring.size(); k = chord_end(ring, k, within_m)) {
    result.push_back(ring[k]);
  }
  return result;
}

Bracket bracket(const std::vector<Ring>& rings, double tolerance_m) {
  std::vector<ClipperLib::Paths> rectangles;
  for (const Ring& ring : rings) {
    const Ring chords = few_corners(ring, kChordShare * tolerance_m);
    for (std::size_t k = 0; k < chords.size(); ++k) {
      rectangles.push_back(
          {rectangle(chords[k], chords[(k + 1) % chords.size()], kBandShare * tolerance_m)});
    }
  }
  if (rectangles.empty()) return {};
  ClipperLib::PolyTree band;
  unite_in_halves(rectangles, 0, rectangles.size(), band);
  BracketBuilder builder(rings);
  builder.open_bands(band);
  Bracket result = builder.take();
  largest_first(result.within);
  largest_first(result.around);
  return result;
}

}  // namespace swathplan
