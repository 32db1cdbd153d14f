#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "mesh/plane/area_query.h"
#include "planners/steering/dubins.h"

namespace swathplan {

/// A way pulled taut, and the metres left to go along it from places near it.
class TautWay {
 public:
  explicit TautWay(std::vector<Vec2> points) : points_(std::move(points)), left_(points_.size()) {
    for (std::size_t i = points_.size() - 1; i-- > 0;) {
      left_[i] = left_[i + 1] + (points_[i + 1] - points_[i]).norm();
    }
  }

  [[nodiscard]] double length_m() const { return left_.front(); }

  /// Metres from p to the end of the way. From p the boat goes straight to the nearest point of one
  /// segment; the segment with the shortest total is taken.
  [[nodiscard]] double to_go(const Vec2& p) const {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) best = std::min(best, by(i, p).metres);
    return best;
  }

  /// The same, only over points that p can see. Where the way doubles back around a mole, its end
  /// may be near and yet a long way off.
  [[nodiscard]] double to_go_in_sight(const Vec2& p, const AreaQuery& water) const {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
      const Over over = by(i, p);
      if (over.metres >= best) continue;
      const double apart = (over.point - p).norm();
      if (water.inside_length(p, over.point) >= apart - kHidden) best = over.metres;
    }
    return std::isfinite(best) ? best : left_.front() + (points_.front() - p).norm();
  }

 private:
  static constexpr double kHidden = 0.5;  ///< metres of land that do not hide a point

  struct Over {
    double metres;
    Vec2 point;
  };
  [[nodiscard]] Over by(std::size_t i, const Vec2& p) const {
    const Vec2 u = points_[i + 1] - points_[i];
    const double t = std::clamp((p - points_[i]).dot(u) / std::max(u.squaredNorm(), 1e-12), 0., 1.);
    const Vec2 point = points_[i] + t * u;
    return {(p - point).norm() + left_[i] - t * u.norm(), point};
  }

  std::vector<Vec2> points_;
  std::vector<double> left_;
};

/// Adds poses on the straights of a way, with the courses of these straights: one near either end,
/// or one in the middle of a short straight. Between two of them lies at most one corner.
void add_stages(const std::vector<Vec2>& way, double radius, std::vector<Pose>& stages);

}  // namespace swathplan
