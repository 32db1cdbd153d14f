#pragma once

#include <memory>
#include <vector>

#include "coverage/ground.h"
#include "coverage/route/sonar.h"
#include "coverage/route/vehicle.h"
#include "coverage/standards/judge.h"

namespace swathplan {

/// Ground that a boat in safe water cannot survey, square metres.
struct OutOfReach {
  double hidden_m2 = 0.0;  ///< no place in safe water shows it to the sonar
  /// Shown only from places that the boat cannot be steered through (steerable_poses.h), or that it
  /// would have to hold better than its position error.
  double unsteerable_m2 = 0.0;
  [[nodiscard]] double total_m2() const { return hidden_m2 + unsteerable_m2; }
};

/// Finds out what the sonar can see from safe water. Places are looked for in kAzimuths directions
/// and each kAngleStepDeg of the widest fan's half. A place serves if the boat can be steered
/// through it at right angles to the beam, and if the beam still sees the ground from so far to
/// either side as the vehicle's position error.
class ReachSearch {
 public:
  ReachSearch(const Ground& ground, const Sonar& sonar, const Vehicle& vehicle);
  ~ReachSearch();
  ReachSearch(ReachSearch&&) noexcept;
  ReachSearch& operator=(ReachSearch&&) noexcept;

  /// Takes back the asked cells that hold no sounding and that are out of reach.
  [[nodiscard]] OutOfReach leave_out(std::vector<JudgedGrid>& grids) const;

  static constexpr int kAzimuths = 32;
  static constexpr double kAngleStepDeg = 5.0;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Whether a beam from the sonar at `boat` meets the ground at `target` first: what stands between
/// them would end it sooner.
[[nodiscard]] bool in_sight(const RayScene& scene, const Vec2& boat, double draft_m,
                            const Vec2& target, double depth_m);

}  // namespace swathplan
