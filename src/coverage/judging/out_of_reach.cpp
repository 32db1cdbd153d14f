#include "coverage/judging/out_of_reach.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "mesh/base/parallel.h"
#include "mesh/plane/area_query.h"

namespace swathplan {

namespace {

// A beam that ends so near to the middle of a cell has seen it: rounding, and the slope between.
constexpr double kSeenM = 0.05;
constexpr double kSeenShare = 0.005;

struct ReachBeam {
  double tangent;  // of its angle from nadir
  double reach_m;  // slant
};

ReachBeam beam_of(const Sonar& sonar, double degrees) {
  const Angle angle = Angle::degrees(degrees);
  return {tan(angle), reach_m(sonar, angle)};
}

class ReachSearch {
 public:
  ReachSearch(const Ground& ground, const Sonar& sonar, const Vehicle& vehicle)
      : scene_(ground.scene), water_(ground.water), draft_(vehicle.draft_m) {
    const double widest = sonar.max_opening.deg() / 2.0;
    for (double t = 0.0; t < widest; t += kAngleStepDeg) {
      beams_.push_back(beam_of(sonar, t));
    }
    beams_.push_back(beam_of(sonar, widest));
  }

  [[nodiscard]] bool reaches(const Vec2& target, double depth) const {
    const double below = depth - draft_;
    if (!(below > 0.0)) return false;
    return std::any_of(beams_.begin(), beams_.end(), [&](const ReachBeam& beam) {
      const double away = below * beam.tangent;
      if (std::hypot(away, below) > beam.reach_m) return false;
      const int azimuths = away > 0.0 ? kAzimuths : 1;
      for (int k = 0; k < azimuths; ++k) {
        const double azimuth = 2.0 * std::numbers::pi * k / kAzimuths;
        const Vec2 boat = target + away * Vec2(std::sin(azimuth), std::cos(azimuth));
        if (water_.contains(boat) && sees(boat, target, depth)) return true;
      }
      return false;
    });
  }

 private:
  [[nodiscard]] bool sees(const Vec2& boat, const Vec2& target, double depth) const {
    const Vec3 from(boat.x(), boat.y(), -draft_);
    const Vec3 way = Vec3(target.x(), target.y(), -depth) - from;
    const Eigen::Vector3f direction = way.normalized().cast<float>();
    RayHit hit;
    scene_->trace(from, {&direction, 1}, {&hit, 1});
    return hit.range_m > 0.0F && hit.range_m >= way.norm() * (1.0 - kSeenShare) - kSeenM;
  }

  const RayScene* scene_;
  AreaQuery water_;
  double draft_;
  std::vector<ReachBeam> beams_;
};

}  // namespace

double leave_out_of_reach(std::vector<JudgedGrid>& grids, const Ground& ground, const Sonar& sonar,
                          const Vehicle& vehicle) {
  const ReachSearch search(ground, sonar, vehicle);
  double area = 0.0;
  for (JudgedGrid& grid : grids) {
    std::vector<std::size_t> left(grid.rows, 0);
    for_each_index(std::uint32_t{0}, grid.rows, [&](std::uint32_t row) {
      for (std::size_t i = std::size_t{row} * grid.columns, end = i + grid.columns; i < end; ++i) {
        JudgedCell& cell = grid.cells[i];
        if (!cell.asked || cell.soundings > 0) continue;
        if (search.reaches(grid.centre(i), cell.depth_m)) continue;
        cell.asked = false;
        ++left[row];
      }
    });
    const auto count = std::accumulate(left.begin(), left.end(), std::size_t{0});
    area += static_cast<double>(count) * grid.cell_m * grid.cell_m;
  }
  return area;
}

}  // namespace swathplan
