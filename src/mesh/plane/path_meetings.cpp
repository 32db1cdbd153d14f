#include "mesh/plane/path_meetings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "mesh/plane/segment_pairs_internal.h"
#include "mesh/plane/segments.h"
#include "mesh/plane/union_find.h"

namespace swathplan {
namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;

/// Share of the segment at which it is nearest to p.
double nearest_share(const Vec2& a, const Vec2& b, const Vec2& p) {
  return nearest_on_segment(a, b, p).share;
}

class Meetings {
 public:
  explicit Meetings(const std::vector<Vec2>& points) : p_(points) {
    along_.push_back(0.0);
    for (std::size_t i = 1; i < p_.size(); ++i) {
      along_.push_back(along_.back() + (p_[i] - p_[i - 1]).norm());
    }
  }

  [[nodiscard]] PathMeetings all() {
    for (const auto& [i, j] : internal::segment_pairs(p_, kTogetherM)) {
      if (j > i + 1 ? meet(i, j) : turns_back(i)) pairs_.emplace_back(i, j);
    }
    PathMeetings result;
    std::vector<std::pair<double, double>> shared;  // stretches of the later pass
    for (const std::vector<Pair>& place : places()) {
      result.crossings += crosses(place) ? 1 : 0;
      const auto stretch = later_stretch(place);
      if (stretch.second - stretch.first < kSharedM) continue;
      ++result.shared_stretches;
      shared.push_back(stretch);
    }
    std::sort(shared.begin(), shared.end());
    double done = 0.0;
    for (const auto& [from, to] : shared) {
      result.shared_m += std::max(0.0, to - std::max(from, done));
      done = std::max(done, to);
    }
    return result;
  }

 private:
  [[nodiscard]] bool near(std::size_t point, std::size_t segment) const {
    return distance_to_segment(p_[segment], p_[segment + 1], p_[point]) <= kTogetherM;
  }

  [[nodiscard]] bool meet(std::size_t i, std::size_t j) const {
    return properly(i, j) || near(i, j) || near(i + 1, j) || near(j, i) || near(j + 1, i);
  }

  /// Neighbours always share a point. They run along each other only where the path turns back.
  [[nodiscard]] bool turns_back(std::size_t i) const { return near(i, i + 1) || near(i + 2, i); }

  [[nodiscard]] bool properly(std::size_t i, std::size_t j) const {
    const Vec2 &a = p_[i], &b = p_[i + 1], &c = p_[j], &d = p_[j + 1];
    return cross(b - a, c - a) * cross(b - a, d - a) < 0.0 &&
           cross(d - c, a - c) * cross(d - c, b - c) < 0.0;
  }

  [[nodiscard]] std::optional<std::uint32_t> find(std::uint32_t i, std::uint32_t j) const {
    const Pair wanted(i, j);
    const auto at = std::lower_bound(pairs_.begin(), pairs_.end(), wanted);
    if (at == pairs_.end() || *at != wanted) return std::nullopt;
    return static_cast<std::uint32_t>(at - pairs_.begin());
  }

  /// Groups of pairs that belong to one place: (i, j) and (i + 1, j) do if the point between the
  /// segments i and i + 1 is near j.
  [[nodiscard]] std::vector<std::vector<Pair>> places() const {
    UnionFind sets(pairs_.size());
    const auto n = static_cast<std::uint32_t>(pairs_.size());
    for (std::uint32_t k = 0; k < n; ++k) {
      const auto [i, j] = pairs_[k];
      const auto along_i = near(i + 1, j) ? find(i + 1, j) : std::nullopt;
      const auto along_j = near(j + 1, i) ? find(i, j + 1) : std::nullopt;
      if (along_i) sets.join(k, *along_i);
      if (along_j) sets.join(k, *along_j);
    }
    std::map<std::uint32_t, std::vector<Pair>> by_root;
    for (std::uint32_t k = 0; k < n; ++k) by_root[sets.find(k)].push_back(pairs_[k]);
    std::vector<std::vector<Pair>> result;
    for (auto& [root, place] : by_root) result.push_back(std::move(place));
    return result;
  }

  /// The point of the segment from-to, seen from `from`, just before it comes near the partners.
  /// Empty if `from` itself is near them: the path begins, ends or turns back there.
  [[nodiscard]] std::optional<Vec2> entry(std::size_t from, std::size_t to,
                                          const std::vector<std::size_t>& partners) const {
    const Vec2 &a = p_[from], &b = p_[to];
    Vec2 away = a;
    if (nearest(away, partners).first <= kTogetherM) return std::nullopt;
    Vec2 close = meeting_point(a, b, partners);
    constexpr int kHalvings = 60;
    for (int k = 0; k < kHalvings; ++k) {
      const Vec2 middle = 0.5 * (away + close);
      (nearest(middle, partners).first <= kTogetherM ? close : away) = middle;
    }
    return away;
  }

  /// Distance and number of the nearest of some segments.
  [[nodiscard]] std::pair<double, std::size_t> nearest(
      const Vec2& point, const std::vector<std::size_t>& segments) const {
    std::pair best(std::numeric_limits<double>::infinity(), std::size_t{0});
    for (const std::size_t s : segments) {
      best = std::min(best, std::pair(distance_to_segment(p_[s], p_[s + 1], point), s));
    }
    return best;
  }

  /// A point of a-b near the segments.
  [[nodiscard]] Vec2 meeting_point(const Vec2& a, const Vec2& b,
                                   const std::vector<std::size_t>& partners) const {
    Vec2 best = b;
    double least = nearest(b, partners).first;
    const auto look = [&](double share) {
      const Vec2 point = a + share * (b - a);
      const double d = nearest(point, partners).first;
      if (d < least) {
        least = d;
        best = point;
      }
    };
    for (const std::size_t s : partners) {
      const Vec2 way = p_[s + 1] - p_[s];
      const double slant = cross(b - a, way);
      if (slant != 0.0) look(std::clamp(cross(p_[s] - a, way) / slant, 0.0, 1.0));
      look(nearest_share(a, b, p_[s]));
      look(nearest_share(a, b, p_[s + 1]));
    }
    return best;
  }

  /// 1: to port of the later pass, -1: to starboard, 0: beyond an end of the path.
  [[nodiscard]] int side(const Vec2& point, const std::vector<std::size_t>& partners) const {
    const std::size_t s = nearest(point, partners).second;
    const double share = nearest_share(p_[s], p_[s + 1], point);
    const Vec2 way = (p_[s + 1] - p_[s]).normalized();
    if (share > 0.0 && share < 1.0) return cross(way, point - p_[s]) > 0.0 ? 1 : -1;
    const std::size_t corner = share > 0.0 ? s + 1 : s;
    if (corner == 0 || corner + 1 == p_.size()) return 0;
    const Vec2 both =
        (p_[corner] - p_[corner - 1]).normalized() + (p_[corner + 1] - p_[corner]).normalized();
    return cross(both, point - p_[corner]) > 0.0 ? 1 : -1;
  }

  [[nodiscard]] static std::vector<std::size_t> partners_of(const std::vector<Pair>& place,
                                                            std::uint32_t segment) {
    std::vector<std::size_t> partners;
    for (const auto& [i, j] : place) {
      if (i == segment) partners.push_back(j);
    }
    return partners;
  }

  [[nodiscard]] bool crosses(const std::vector<Pair>& place) const {
    const std::uint32_t first = place.front().first;
    const std::uint32_t last = place.back().first;
    const auto before = partners_of(place, first);
    const auto after = partners_of(place, last);
    const auto in = entry(first, first + 1, before);
    const auto out = entry(last + 1, last, after);
    return in && out && side(*in, before) * side(*out, after) < 0;
  }

  /// From where to where the later pass is near the earlier one, metres of path.
  [[nodiscard]] std::pair<double, double> later_stretch(const std::vector<Pair>& place) const {
    double from = along_.back();
    double to = 0.0;
    const auto take = [&](double at) {
      from = std::min(from, at);
      to = std::max(to, at);
    };
    for (const auto& [i, j] : place) {
      const auto at = [this, k = j](double share) {
        return along_[k] + share * (along_[k + 1] - along_[k]);
      };
      if (near(j, i)) take(along_[j]);
      if (near(j + 1, i)) take(along_[j + 1]);
      if (near(i, j)) take(at(nearest_share(p_[j], p_[j + 1], p_[i])));
      if (near(i + 1, j)) take(at(nearest_share(p_[j], p_[j + 1], p_[i + 1])));
    }
    return {from, std::max(from, to)};
  }

  const std::vector<Vec2>& p_;
  std::vector<double> along_;
  std::vector<Pair> pairs_;
};

}  // namespace

PathMeetings path_meetings(const std::vector<Vec2>& path) {
  // Points so close to each other that all would count as together would hide what is a crossing.
  std::vector<Vec2> points;
  for (const Vec2& p : path) {
    if (points.empty() || (p - points.back()).norm() > 2.0 * kTogetherM) points.push_back(p);
  }
  if (points.size() < 4) return {};
  return Meetings(points).all();
}

}  // namespace swathplan
