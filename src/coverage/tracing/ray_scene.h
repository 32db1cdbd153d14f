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

/// A fan's beams from one origin; results per beam.
struct RayHit {
  float range_m = 0.0F;          ///< > 0 where the beam met the seafloor from above, else 0
  float nx = 0, ny = 0, nz = 0;  ///< unit normal there, nz >= 0
};

/// The seafloor as an Embree scene: robust flags, local origin, packets of 16 coherent rays.
/// Walls at the data's border are one-sided curtains from the border edge up to the water level
/// that stop beams leaving the data and let a boat outside look in. Thread-safe for tracing.
class RayScene {
 public:
  RayScene(const Seafloor& seafloor, Nodata nodata);
  ~RayScene();
  RayScene(RayScene&&) noexcept;
  RayScene& operator=(RayScene&&) noexcept;

  /// Traces beams from `origin` (local metres) along unit `directions`; hits.size() ==
  /// directions.size(). A beam that meets a curtain, nothing, or a face from below gives range 0.
  void trace(const Vec3& origin, std::span<const Eigen::Vector3f> directions,
             std::span<RayHit> hits) const;

  struct Impl;
  /// For the scorer, which traces whole fans without copying (ray_scene_internal.h).
  [[nodiscard]] const Impl& impl() const { return *impl_; }

 private:
  std::unique_ptr<Impl> impl_;
};

}  // namespace swathplan
