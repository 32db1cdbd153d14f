#pragma once

#include <cstdint>
#include <vector>

#include "planners/fronts/survey_curve.h"
#include "planners/fronts/water_raster.h"

namespace swathplan {

/// The seafloor for estimates of swaths without rays. The depth below the sonar is linear between
/// cell centres; beyond the area it is that of the nearest cell. The fan at p opens to each side to
/// atan(W(p)/2 / depth below the sonar). Its outermost beam is followed down to the floor, so that
/// a swath reaches farther down a slope than up. Ground that a nearer shoal hides counts as seen,
/// so use it for smooth floors only. `raster` and `width` (as width_field or opening_width give it)
/// must outlive it.
class SweptGround {
 public:
  SweptGround(const WaterRaster& raster, const std::vector<float>& width, double draft_m);

  [[nodiscard]] const WaterRaster& raster() const { return raster_; }
  [[nodiscard]] const std::vector<float>& width() const { return width_; }
  /// Water below the sonar at p, metres.
  [[nodiscard]] double below_m(const Vec2& p) const { return between(below_, p); }
  /// W at p, metres.
  [[nodiscard]] double width_m(const Vec2& p) const {
    return 2.0 * between(below_, p) * between(tangent_, p);
  }
  /// Horizontal metres from p to where the outermost beam of the side meets the floor, or to where
  /// it leaves the area. `side`: unit vector.
  [[nodiscard]] double reach_m(const Vec2& p, const Vec2& side) const;

 private:
  [[nodiscard]] double between(const std::vector<float>& values, const Vec2& p) const;

  const WaterRaster& raster_;
  const std::vector<float>& width_;
  std::vector<float> below_, tangent_;  // of every cell, also beyond the area
};

/// W = 2 tan(opening / 2) x depth below the sonar of every cell of the area; 0 outside, metres.
/// `opening`: full fan, (0, 180) degrees.
[[nodiscard]] std::vector<float> opening_width(const WaterRaster& raster, Angle opening,
                                               double draft_m);

/// A line and what it sweeps, step by step.
struct SweptLine {
  std::vector<Vec2> points;             ///< of the line, about kSweepStepOfCell of a cell apart
  std::vector<Vec2> port, starboard;    ///< where the outermost beams of each point end
  std::vector<std::uint32_t> cells;     ///< of the area: those that step 0 sweeps, then step 1, ...
  std::vector<std::size_t> first_cell;  ///< of each step, an index into `cells`; then their number
  [[nodiscard]] std::size_t steps() const { return points.empty() ? 0 : points.size() - 1; }
};
inline constexpr double kSweepStepOfCell = 0.7;

[[nodiscard]] SweptLine swept(const SurveyCurve& line, const SweptGround& ground);
[[nodiscard]] std::vector<SweptLine> swept(const std::vector<SurveyCurve>& lines,
                                           const SweptGround& ground);

/// The curve carried on straight at both ends for `share` x W, as far as lines may run there.
/// Closed curves stay as they are.
[[nodiscard]] SurveyCurve carried_on(SurveyCurve curve, double share, const SweptGround& ground,
                                     const AreaQuery& lines_in);

/// Figures of a set of lines, without their turns.
struct LinesFigures {
  std::size_t lines = 0;
  double length_m = 0.0;
  double least_m = 0.0;  ///< integral of 1/W over the area
  double missed = 0.0;   ///< share of the area's cells that no line sweeps
  double overlap = 0.0;  ///< lines per swept cell, less 1
  [[nodiscard]] double ratio() const { return least_m > 0.0 ? length_m / least_m : 0.0; }
};
[[nodiscard]] LinesFigures judge_lines(const std::vector<SweptLine>& lines,
                                       const SweptGround& ground);

/// Shortens lines at their ends where a metre of line brings less than `gain` x W square metres
/// that no other line sweeps. With `gain` 0 only metres that bring nothing are cut. Lines of which
/// nothing is left are dropped.
void trim_ends(std::vector<SweptLine>& lines, const SweptGround& ground, double gain);

}  // namespace swathplan
