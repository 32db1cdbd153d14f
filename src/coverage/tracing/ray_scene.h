#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "mesh/seafloor.h"

namespace swathplan {

/// What a beam meets beyond the data's border.
enum class Nodata {
  wall,  ///< quays and moles stand there: a beam that leaves the data gives no sounding
  open   ///< it passes
};

/// What one beam met.
struct RayHit {
  float range_m = 0.0F;          ///< > 0 for a sounding, else 0
  float nx = 0, ny = 0, nz = 0;  ///< unit normal there, nz >= 0
};

/// The seafloor as an Embree scene. With Nodata::wall one-sided curtains stand along the data's
/// border, from the seafloor up to 5 m above the water level, higher than any boat heaves. They
/// stop beams that leave the data and let a boat outside look in. Tracing is thread-safe.
class RayScene {
 public:
  RayScene(const Seafloor& seafloor, Nodata nodata);
  ~RayScene();
  RayScene(RayScene&&) noexcept;
  RayScene& operator=(RayScene&&) noexcept;

  /// Traces beams from `origin` (local metres) along unit `directions`, without a limit of range.
  /// `hits` must have the size of `directions`. A beam gives range 0 if the first thing that it
  /// meets is a curtain or a face from below, or if it meets nothing. A vertical face may be met
  /// from either side: rounding decides which way it looks.
  void trace(const Vec3& origin, std::span<const Eigen::Vector3f> directions,
             std::span<RayHit> hits) const;

  struct Impl;
  /// For this room only: ping_tracer.cpp traces whole fans without copies (ray_scene_internal.h).
  [[nodiscard]] const Impl& impl() const { return *impl_; }

 private:
  std::unique_ptr<Impl> impl_;
};

}  // namespace swathplan
