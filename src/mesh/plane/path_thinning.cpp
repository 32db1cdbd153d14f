#include "mesh/plane/path_thinning.h"

#include <algorithm>

namespace swathplan {
namespace {

/// Douglas-Peucker takes quadratic time on lines that coil, so long stretches are cut into pieces
/// of this many points.
constexpr std::size_t kPiece = 2000;

/// From differences to `a` alone, which keep small distances exact far from the origin; that is why
/// segments.h does not serve here.
double distance_to_straight(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double square = along.squaredNorm();
  const double t = square > 0.0 ? std::clamp((p - a).dot(along) / square, 0.0, 1.0) : 0.0;
  return (p - a - t * along).norm();
}

struct Farthest {
  std::size_t index = 0;
  double distance_m = 0.0;
};

Farthest farthest_between(const std::vector<Vec2>& path, std::size_t first, std::size_t last) {
  Farthest result{first, 0.0};
  for (std::size_t i = first + 1; i < last; ++i) {
    const double d = distance_to_straight(path[i], path[first], path[last]);
    if (d > result.distance_m) result = {i, d};
  }
  return result;
}

/// Marks the points that a stretch needs between its ends. Returns the largest distance that is
/// left.
double thin_stretch(const std::vector<Vec2>& path, std::size_t first, std::size_t last,
                    double tolerance_m, const StraightRule& rule, std::vector<bool>& needed) {
  double largest = 0.0;
  std::vector<std::pair<std::size_t, std::size_t>> open{{first, last}};
  while (!open.empty()) {
    const auto [a, b] = open.back();
    open.pop_back();
    if (b == a + 1) continue;
    Farthest f = farthest_between(path, a, b);
    if (f.index == a) f.index = a + (b - a) / 2;  // all of them lie on the straight
    if (f.distance_m <= tolerance_m && (!rule || rule(a, b))) {
      largest = std::max(largest, f.distance_m);
      continue;
    }
    needed[f.index] = true;
    open.emplace_back(a, f.index);
    open.emplace_back(f.index, b);
  }
  return largest;
}

}  // namespace

ThinnedPath thin_path(const std::vector<Vec2>& path, const std::vector<bool>& keep,
                      double tolerance_m, const StraightRule& rule) {
  ThinnedPath result;
  if (path.empty()) return result;
  std::vector<bool> needed(path.size(), false);
  needed.front() = needed.back() = true;
  std::size_t first = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const bool stays = i + 1 == path.size() || (!keep.empty() && keep[i]);
    if (!stays && i - first < kPiece) continue;
    needed[i] = true;
    result.largest_distance_m = std::max(result.largest_distance_m,
                                         thin_stretch(path, first, i, tolerance_m, rule, needed));
    first = i;
  }
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (needed[i]) result.kept.push_back(i);
  }
  return result;
}

}  // namespace swathplan
