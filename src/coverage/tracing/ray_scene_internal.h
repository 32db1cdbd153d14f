#pragma once

#include <embree3/rtcore.h>

#include <limits>

#include "coverage/tracing/ray_scene.h"

namespace swathplan {

/// Rays of one packet.
inline constexpr std::size_t kPacket = 16;

struct RayScene::Impl {
  Impl(const Seafloor& seafloor, Nodata nodata);
  ~Impl();
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  Vec3 centre = Vec3::Zero();  ///< local metres; Embree's own origin, so that its floats stay small
};

/// The beams of one fan. Every array holds `padded` floats, a multiple of kPacket.
struct FanBeams {
  std::size_t count = 0;   ///< beams
  std::size_t padded = 0;  ///< count rounded up to whole packets
  const float* dx = nullptr;
  const float* dy = nullptr;
  const float* dz = nullptr;  ///< unit directions
};

/// Where a fan's beams met the seafloor; arrays of `padded` floats.
struct FanHits {
  float* range = nullptr;  ///< > 0: a sounding; else none
  float* nx = nullptr;
  float* ny = nullptr;
  float* nz = nullptr;  ///< normal of any length, up or, on vertical faces, down; undefined
                        ///< without a sounding
};

/// Traces a fan from `origin` (local metres) as far as `max_range_m`.
void trace_fan(const RayScene::Impl& scene, const Vec3& origin, const FanBeams& beams,
               float max_range_m, const FanHits& hits);

}  // namespace swathplan
