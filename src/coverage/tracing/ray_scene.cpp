#include "coverage/tracing/ray_scene.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "coverage/tracing/ray_scene_internal.h"
#include "mesh/border_edges.h"

namespace swathplan {

namespace {

// A ray starts this far behind its origin, metres. So a boat exactly above the data's border stands
// inside the curtain when it looks out. Floats some kilometres from the scene's centre round by
// less (2e-4 m), and no survey resolves so little.
constexpr float kStepBack = 0.01F;
// Top of the curtains, metres above the water level: more than a boat heaves.
constexpr double kCurtainTop = 5.0;
// Squared cosine between a vertical face's normal and the plumb line: within 0.006 degrees. Such
// faces may be met from either side, because rounding to floats decides which way they look.
constexpr float kVerticalSquared = 1e-8F;
// A ray that slips through a vertex is traced again this much aside, radians: 0.6 mm at 60 m.
constexpr float kNudge = 1e-5F;

// Curtains stop rays that travel outward and let the others pass.
void keep_outward(const RTCFilterFunctionNArguments* args) {
  for (unsigned i = 0; i < args->N; ++i) {
    if (args->valid[i] == 0) continue;
    const float along = RTCRayN_dir_x(args->ray, args->N, i) * RTCHitN_Ng_x(args->hit, args->N, i) +
                        RTCRayN_dir_y(args->ray, args->N, i) * RTCHitN_Ng_y(args->hit, args->N, i);
    if (!(along > 0.0F)) args->valid[i] = 0;
  }
}

float* vertex_buffer(RTCGeometry geometry, std::size_t count) {
  return static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                     RTC_FORMAT_FLOAT3, 3 * sizeof(float), count));
}

std::uint32_t* index_buffer(RTCGeometry geometry, std::size_t count) {
  return static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), count));
}

constexpr unsigned kSeafloorId = 0;
constexpr unsigned kCurtainId = 1;

void attach(RTCScene scene, RTCGeometry geometry, unsigned id) {
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene, geometry, id);
  rtcReleaseGeometry(geometry);
}

void store(float* to, const Vec3& p) {
  for (int k = 0; k < 3; ++k) to[k] = static_cast<float>(p[k]);
}

void attach_seafloor(RTCDevice device, RTCScene scene, const Seafloor& seafloor,
                     const Vec3& centre) {
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  float* vertices = vertex_buffer(geometry, seafloor.vertices.size());
  for (std::size_t i = 0; i < seafloor.vertices.size(); ++i) {
    store(vertices + 3 * i, seafloor.vertices[i] - centre);
  }
  std::uint32_t* faces = index_buffer(geometry, seafloor.faces.size());
  for (const Seafloor::Face& f : seafloor.faces) faces = std::copy(f.begin(), f.end(), faces);
  attach(scene, geometry, kSeafloorId);
}

void attach_curtains(RTCDevice device, RTCScene scene, const Seafloor& seafloor,
                     const Vec3& centre) {
  auto edges = border_edges(seafloor);
  std::erase_if(edges, [&](const auto& e) {
    return seafloor.vertices[e[0]].template head<2>() == seafloor.vertices[e[1]].template head<2>();
  });
  if (edges.empty()) return;
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  float* vertices = vertex_buffer(geometry, 4 * edges.size());
  std::uint32_t* faces = index_buffer(geometry, 2 * edges.size());
  std::uint32_t base = 0;
  for (const auto& e : edges) {
    for (const std::uint32_t v : e) {
      const Vec3 bottom = seafloor.vertices[v] - centre;
      store(vertices + 3 * std::size_t{base}, bottom);
      store(vertices + 3 * (std::size_t{base} + 1),
            {bottom.x(), bottom.y(), kCurtainTop - centre.z()});
      base += 2;
    }
    // Data lies on the left of the edge, so with this winding the normals look out of it.
    const std::uint32_t a = base - 4;
    faces = std::copy_n(std::array{a, a + 2, a + 3, a, a + 3, a + 1}.begin(), 6, faces);
  }
  rtcSetGeometryIntersectFilterFunction(geometry, keep_outward);
  attach(scene, geometry, kCurtainId);
}

struct alignas(64) Lanes {
  int valid[kPacket];
};

bool from_above(float dx, float dy, float dz, float nx, float ny, float nz) {
  const bool against = dx * nx + dy * ny + dz * nz < 0.0F;
  const bool vertical = nz * nz <= kVerticalSquared * (nx * nx + ny * ny + nz * nz);
  return against | vertical;
}

// Range of a beam that met nothing at all. One that met something else than the seafloor from above
// has range 0.
constexpr float kMissed = -1.0F;

RTCIntersectContext coherent_context() {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  return context;
}

void fill_rays(RTCRayHit16& packet, const Eigen::Vector3f& origin, const FanBeams& beams,
               std::size_t first, float far) {
  for (std::size_t j = 0; j < kPacket; ++j) {
    const float dx = beams.dx[first + j];
    const float dy = beams.dy[first + j];
    const float dz = beams.dz[first + j];
    packet.ray.dir_x[j] = dx;
    packet.ray.dir_y[j] = dy;
    packet.ray.dir_z[j] = dz;
    packet.ray.org_x[j] = origin.x() - kStepBack * dx;
    packet.ray.org_y[j] = origin.y() - kStepBack * dy;
    packet.ray.org_z[j] = origin.z() - kStepBack * dz;
    packet.ray.tnear[j] = 0.0F;
    packet.ray.tfar[j] = far;
    packet.ray.time[j] = 0.0F;
    packet.ray.mask[j] = ~0U;
    packet.ray.flags[j] = 0;
    packet.hit.geomID[j] = RTC_INVALID_GEOMETRY_ID;
    packet.hit.instID[0][j] = RTC_INVALID_GEOMETRY_ID;
  }
}

void read_hits(const RTCRayHit16& packet, std::size_t first, const FanHits& hits) {
  for (std::size_t j = 0; j < kPacket; ++j) {
    const float nx = packet.hit.Ng_x[j];
    const float ny = packet.hit.Ng_y[j];
    const float nz = packet.hit.Ng_z[j];
    const bool above =
        from_above(packet.ray.dir_x[j], packet.ray.dir_y[j], packet.ray.dir_z[j], nx, ny, nz);
    const float range = above ? packet.ray.tfar[j] - kStepBack : 0.0F;
    const float other = packet.hit.geomID[j] == RTC_INVALID_GEOMETRY_ID ? kMissed : 0.0F;
    hits.range[first + j] = packet.hit.geomID[j] == kSeafloorId ? range : other;
    hits.nx[first + j] = nx;
    hits.ny[first + j] = ny;
    hits.nz[first + j] = nz;
  }
}

// One beam on its own; range as in FanHits or kMissed.
float trace_one(const RayScene::Impl& scene, const Eigen::Vector3f& origin,
                const Eigen::Vector3f& direction, float far, Eigen::Vector3f& normal) {
  RTCIntersectContext context = coherent_context();
  RTCRayHit one{};
  const Eigen::Vector3f start = origin - kStepBack * direction;
  one.ray.org_x = start.x();
  one.ray.org_y = start.y();
  one.ray.org_z = start.z();
  one.ray.dir_x = direction.x();
  one.ray.dir_y = direction.y();
  one.ray.dir_z = direction.z();
  one.ray.tfar = far;
  one.ray.mask = ~0U;
  one.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  one.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene.scene, &context, &one);
  if (one.hit.geomID == RTC_INVALID_GEOMETRY_ID) return kMissed;
  normal = {one.hit.Ng_x, one.hit.Ng_y, one.hit.Ng_z};
  const bool above =
      one.hit.geomID == kSeafloorId &&
      from_above(direction.x(), direction.y(), direction.z(), normal.x(), normal.y(), normal.z());
  return above ? one.ray.tfar - kStepBack : 0.0F;
}

// A beam that met nothing beside one that met the seafloor may have slipped through a vertex.
void retry_slipped(const RayScene::Impl& scene, const Eigen::Vector3f& origin,
                   const FanBeams& beams, float far, const FanHits& hits) {
  static const std::array<Eigen::Vector2f, 4> kNudges{
      Eigen::Vector2f{kNudge, 0.0F}, {-kNudge, 0.0F}, {0.0F, kNudge}, {0.0F, -kNudge}};
  for (std::size_t i = 0; i < beams.count; ++i) {
    if (hits.range[i] != kMissed) continue;
    const bool beside =
        (i > 0 && hits.range[i - 1] > 0.0F) || (i + 1 < beams.count && hits.range[i + 1] > 0.0F);
    if (!beside) continue;
    for (const Eigen::Vector2f& nudge : kNudges) {
      const Eigen::Vector3f direction =
          Eigen::Vector3f(beams.dx[i] + nudge.x(), beams.dy[i] + nudge.y(), beams.dz[i])
              .normalized();
      Eigen::Vector3f normal = Eigen::Vector3f::UnitZ();
      const float range = trace_one(scene, origin, direction, far, normal);
      if (!(range > 0.0F)) continue;
      hits.range[i] = range;
      hits.nx[i] = normal.x();
      hits.ny[i] = normal.y();
      hits.nz[i] = normal.z();
      break;
    }
  }
}

}  // namespace

RayScene::Impl::Impl(const Seafloor& seafloor, Nodata nodata) {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = -low;
  for (const Vec3& v : seafloor.vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  if (!seafloor.vertices.empty()) centre = 0.5 * (low + high);
  // No thread count is given: Embree would set it for all of TBB in this process.
  device = rtcNewDevice(nullptr);
  if (device == nullptr) throw std::runtime_error("Embree cannot start on this machine");
  scene = rtcNewScene(device);
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  attach_seafloor(device, scene, seafloor, centre);
  if (nodata == Nodata::wall) attach_curtains(device, scene, seafloor, centre);
  // One thread builds the tree, so that it is the same on every machine.
  tbb::task_arena(1).execute([this] { rtcJoinCommitScene(scene); });
}

RayScene::Impl::~Impl() {
  rtcReleaseScene(scene);
  rtcReleaseDevice(device);
}

void trace_fan(const RayScene::Impl& scene, const Vec3& origin, const FanBeams& beams,
               float max_range_m, const FanHits& hits) {
  const Eigen::Vector3f start = (origin - scene.centre).cast<float>();
  const float far = max_range_m + kStepBack;
  RTCIntersectContext context = coherent_context();
  RTCRayHit16 packet{};
  Lanes lanes;
  for (std::size_t first = 0; first < beams.padded; first += kPacket) {
    for (std::size_t j = 0; j < kPacket; ++j) lanes.valid[j] = first + j < beams.count ? -1 : 0;
    fill_rays(packet, start, beams, first, far);
    rtcIntersect16(lanes.valid, scene.scene, &context, &packet);
    read_hits(packet, first, hits);
  }
  const bool missed =
      std::any_of(hits.range, hits.range + beams.count, [](float r) { return r == kMissed; });
  if (missed) retry_slipped(scene, start, beams, far, hits);
}

RayScene::RayScene(const Seafloor& seafloor, Nodata nodata)
    : impl_(std::make_unique<Impl>(seafloor, nodata)) {}
RayScene::~RayScene() = default;
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;

void RayScene::trace(const Vec3& origin, std::span<const Eigen::Vector3f> directions,
                     std::span<RayHit> hits) const {
  const std::size_t padded = (directions.size() + kPacket - 1) / kPacket * kPacket;
  std::vector<float> buffer(7 * padded, 0.0F);
  const auto column = [&](std::size_t k) { return buffer.data() + k * padded; };
  for (std::size_t i = 0; i < directions.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) column(k)[i] = directions[i][static_cast<Eigen::Index>(k)];
  }
  trace_fan(*impl_, origin, {directions.size(), padded, column(0), column(1), column(2)},
            std::numeric_limits<float>::infinity(), {column(3), column(4), column(5), column(6)});
  for (std::size_t i = 0; i < directions.size(); ++i) {
    if (!(column(3)[i] > 0.0F)) {
      hits[i] = {};
      continue;
    }
    Eigen::Vector3f normal = Eigen::Vector3f(column(4)[i], column(5)[i], column(6)[i]).normalized();
    if (normal.z() < 0.0F) normal = -normal;
    hits[i] = {column(3)[i], normal.x(), normal.y(), normal.z()};
  }
}

}  // namespace swathplan
