#include "mesh/plane/path_crossings.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>

#include "mesh/plane/segment_pairs_internal.h"

namespace swathplan {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

int side(const Vec2& a, const Vec2& b, const Vec2& p) {
  return CGAL::orientation(Kernel::Point_2(a.x(), a.y()), Kernel::Point_2(b.x(), b.y()),
                           Kernel::Point_2(p.x(), p.y()));
}

bool lexicographic(const Vec2& a, const Vec2& b) {
  return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
}

// p, on the line through a and b, lies strictly between them.
bool between(const Vec2& a, const Vec2& b, const Vec2& p) {
  return (lexicographic(a, p) && lexicographic(p, b)) ||
         (lexicographic(b, p) && lexicographic(p, a));
}

// Direction centre -> p lies strictly inside the angle from centre -> a counter-clockwise to
// centre -> b.
bool in_sector(const Vec2& centre, const Vec2& a, const Vec2& b, const Vec2& p) {
  const int after_a = side(centre, a, p);
  const int before_b = side(centre, p, b);
  const int turn = side(centre, a, b);
  if (turn > 0) return after_a > 0 && before_b > 0;
  if (turn < 0) return !(after_a <= 0 && before_b <= 0) && (after_a > 0 || before_b > 0);
  const bool opposite = (a - centre).dot(b - centre) < 0.0;
  return opposite && after_a > 0;
}

class Crossings {
 public:
  explicit Crossings(const std::vector<Vec2>& path) : p_(path) {}

  // Crossings that belong to the pair of segments i < j: each is found by exactly one pair.
  [[nodiscard]] std::size_t of_pair(std::size_t i, std::size_t j) const {
    if (j <= i + 1) return 0;
    const Vec2 &a = p_[i], &b = p_[i + 1], &c = p_[j], &d = p_[j + 1];
    const int sc = side(a, b, c);
    const int sd = side(a, b, d);
    const int sa = side(c, d, a);
    const int sb = side(c, d, b);
    if (sc * sd < 0 && sa * sb < 0) return 1;
    if (sc == 0 && sd == 0) return overlap(a, b, c, d) ? 1 : 0;
    std::size_t count = 0;
    // A corner is the start of its segment; the path's two ends are no corners.
    if (sc == 0 && between(a, b, c)) count += passes(j, a, b);
    if (sa == 0 && between(c, d, a)) count += passes(i, c, d);
    if (a == c) count += cross_at_corner(i, j);
    return count;
  }

 private:
  static bool overlap(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    const auto [low1, high1] = std::minmax(a, b, lexicographic);
    const auto [low2, high2] = std::minmax(c, d, lexicographic);
    const Vec2& low = lexicographic(low1, low2) ? low2 : low1;
    const Vec2& high = lexicographic(high1, high2) ? high1 : high2;
    return lexicographic(low, high);
  }

  [[nodiscard]] bool is_corner(std::size_t k) const { return k > 0 && k + 1 < p_.size(); }

  // The path changes sides of the line a-b at corner k.
  [[nodiscard]] std::size_t passes(std::size_t k, const Vec2& a, const Vec2& b) const {
    return is_corner(k) && side(a, b, p_[k - 1]) * side(a, b, p_[k + 1]) < 0 ? 1 : 0;
  }

  [[nodiscard]] std::size_t cross_at_corner(std::size_t i, std::size_t j) const {
    if (!is_corner(i) || !is_corner(j)) return 0;
    const auto inside = [&](const Vec2& from, const Vec2& to, const Vec2& q) {
      return in_sector(p_[i], from, to, q);
    };
    const Vec2 &in = p_[i - 1], &out = p_[i + 1];
    const bool first = inside(in, out, p_[j - 1]) && inside(out, in, p_[j + 1]);
    const bool second = inside(out, in, p_[j - 1]) && inside(in, out, p_[j + 1]);
    return first || second ? 1 : 0;
  }

  const std::vector<Vec2>& p_;
};

}  // namespace

std::size_t self_crossings(const std::vector<Vec2>& path) {
  std::vector<Vec2> points;
  for (const Vec2& p : path) {
    if (points.empty() || points.back() != p) points.push_back(p);
  }
  if (points.size() < 4) return 0;
  const Crossings crossings(points);
  std::size_t count = 0;
  for (const auto& [i, j] : internal::segment_pairs(points, 0.0)) count += crossings.of_pair(i, j);
  return count;
}

}  // namespace swathplan
