#pragma once

#include <vector>

#include "mesh/plane/polygons.h"
#include "mesh/seafloor.h"
#include "planners/plan.h"

namespace swathplan {

/// Estimates the area that a path leaves empty by a smooth function of its points, and tells where
/// the points should move to leave less. rho(x) is the number of soundings per cell at x. The
/// path's fans are laid over the seafloor and spread by a Gaussian of kSpreadM. About exp(-rho) of
/// the cells at x stay empty, so E = integral of exp(-rho) over the survey area. Cost: O(points x
/// kRays + area / kCellM^2).
class ThinCover {
 public:
  /// The depths must outlive it.
  ThinCover(const DepthQuery& depths, const Area& survey_area, const PlanOptions& options);

  struct Pull {
    std::vector<Vec2> down;  ///< -dE/dp of each point, square metres a metre
    double empty_m2 = 0.0;   ///< E
  };
  /// `fans[i]` is the fan at point i.
  [[nodiscard]] Pull pull(const std::vector<Vec2>& points,
                          const std::vector<FanAngles>& fans) const;

  static constexpr double kCellM = 0.8;
  static constexpr double kSpreadM = 1.2;
  static constexpr int kRays = 32;

 private:
  struct Ray {
    double across_m;  // to port
    Vec2 at;
  };
  [[nodiscard]] std::vector<Ray> rays(const Vec2& p, const Vec2& course,
                                      const FanAngles& fan) const;
  [[nodiscard]] std::vector<double> blurred(const std::vector<double>& field) const;
  [[nodiscard]] std::ptrdiff_t index(int x, int y) const {
    return static_cast<std::ptrdiff_t>(y) * width_ + x;
  }

  const DepthQuery& depths_;
  Sonar sonar_;
  PingTiming pings_;
  double draft_m_, beams_, speed_mps_, cell_area_m2_;
  Vec2 corner_;
  int width_, height_;
  std::vector<char> wanted_;    // cells whose centre lies in the survey area
  std::vector<double> kernel_;  // half of it, the middle first
};

}  // namespace swathplan
