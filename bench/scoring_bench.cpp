// How fast score() is beside a bare Embree loop (packets of 16, coherent, robust) over the same
// rays with the same number of threads, measured in one run.
//   scoring_bench [threads]   (0 or none: 1 and all cores)

#include <fmt/core.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>

#include "coverage/score.h"
#include "coverage/tracing/fan_table.h"
#include "coverage/tracing/ray_scene_internal.h"
#include "mesh/base/allocator.h"
#include "mesh/survey_area.h"
#include "mesh/synthetic.h"

namespace {

using namespace swathplan;

constexpr int kRepeats = 15;

/// A walk over the box as NUC sails: parallel passes `spacing` apart, joined by short steps, turned
/// by `heading` so that no pass runs along the grid, with a waypoint each metre.
Route winding_route(const Box2& box, double spacing, Angle heading, const FanAngles& fan) {
  Route route;
  const Vec2 centre = 0.5 * (box.min + box.max);
  const double half = 0.5 * box.size().minCoeff() / std::sqrt(2.0);
  bool back = false;
  for (double x = -half; x <= half; x += spacing, back = !back) {
    for (double y = -half; y <= half; y += 1.0) {
      Waypoint w;
      const double along = back ? -y : y;
      w.position =
          centre + along * Vec2(sin(heading), cos(heading)) + x * Vec2(cos(heading), -sin(heading));
      w.fan = fan;
      route.waypoints.push_back(w);
    }
  }
  route.waypoints.back().kind = LegKind::end;
  return route;
}

/// All rays of a route, made before the clock starts.
struct Rays {
  std::vector<Eigen::Vector3f> origins;  // per ping, Embree's frame
  std::vector<float> dx, dy, dz;         // per ray
  std::size_t beams = 0;
};

Rays all_rays(const Route& route, const RayScene& scene, const Sonar& sonar, double draft,
              double spacing) {
  Rays rays;
  rays.beams = static_cast<std::size_t>(sonar.beams);
  PingWalker walker(route, sonar, {.spacing_m = spacing}, {});
  FanTableCache tables(sonar);
  std::vector<Ping> pings;
  while (walker.next(1024, pings)) {
    for (const Ping& p : pings) {
      const Vec3 origin(p.position.x(), p.position.y(), -draft);
      rays.origins.push_back((origin - scene.impl().centre).cast<float>());
      const FanTable& table = tables.get(p.fan);
      for (std::size_t i = 0; i < rays.beams; ++i) {
        rays.dx.push_back(table.sine[i] * static_cast<float>(p.course.y()));
        rays.dy.push_back(table.sine[i] * static_cast<float>(-p.course.x()));
        rays.dz.push_back(-table.cosine[i]);
      }
    }
  }
  return rays;
}

std::size_t trace_ping(const Rays& rays, std::size_t ping, RTCScene scene) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  alignas(64) int valid[kPacket];
  std::fill_n(valid, kPacket, -1);
  std::size_t hits = 0;
  RTCRayHit16 packet{};
  for (std::size_t first = 0; first < rays.beams; first += kPacket) {
    for (std::size_t j = 0; j < kPacket; ++j) {
      const std::size_t ray = ping * rays.beams + first + j;
      packet.ray.org_x[j] = rays.origins[ping].x();
      packet.ray.org_y[j] = rays.origins[ping].y();
      packet.ray.org_z[j] = rays.origins[ping].z();
      packet.ray.dir_x[j] = rays.dx[ray];
      packet.ray.dir_y[j] = rays.dy[ray];
      packet.ray.dir_z[j] = rays.dz[ray];
      packet.ray.tfar[j] = std::numeric_limits<float>::infinity();
      packet.ray.mask[j] = ~0U;
      packet.hit.geomID[j] = RTC_INVALID_GEOMETRY_ID;
      packet.hit.instID[0][j] = RTC_INVALID_GEOMETRY_ID;
    }
    rtcIntersect16(valid, scene, &context, &packet);
    for (std::size_t j = 0; j < kPacket; ++j) hits += packet.hit.geomID[j] == 0;
  }
  return hits;
}

std::size_t bare_loop(const Rays& rays, const RayScene& scene, tbb::task_arena& arena) {
  std::size_t hits = 0;
  arena.execute([&] {
    hits = tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, rays.origins.size(), 64), std::size_t{0},
        [&](const tbb::blocked_range<std::size_t>& range, std::size_t sum) {
          for (std::size_t p = range.begin(); p != range.end(); ++p) {
            sum += trace_ping(rays, p, scene.impl().scene);
          }
          return sum;
        },
        std::plus<>());
  });
  return hits;
}

template <class Work>
double best_seconds(Work work) {
  double best = 1e300;
  for (int i = 0; i < kRepeats; ++i) {
    const auto start = std::chrono::steady_clock::now();
    work();
    best = std::min(
        best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return best;
}

void compare(const char* name, const Seafloor& seafloor, const Route& route, double resolution,
             int threads) {
  const DepthQuery depths(seafloor);
  const RayScene scene(seafloor, Nodata::open);
  const RayScene walled(seafloor, Nodata::wall);
  const Area area = outline(seafloor);
  const Sonar sonar;
  const Vehicle vehicle;
  const Rays rays = all_rays(route, scene, sonar, vehicle.draft_m, 0.10);
  tbb::task_arena arena(threads);
  std::size_t hits = 0;
  const double bare = best_seconds([&] { hits = bare_loop(rays, scene, arena); });
  const auto count = static_cast<double>(rays.dx.size());
  fmt::print("{}: {} triangles, {:.3g} rays ({:.1f} % hit), {} threads\n", name,
             seafloor.faces.size(), count, 100.0 * static_cast<double>(hits) / count, threads);
  fmt::print("  bare loop               {:6.1f} Mrays/s\n", count / bare * 1e-6);
  const auto run = [&](const char* what, const RayScene& used, bool footprint) {
    const Ground ground{&seafloor, &depths, area, area, &used};
    ScoreOptions options;
    options.resolution_m = resolution;
    options.footprint = footprint;
    options.threads = threads;
    const double seconds =
        best_seconds([&] { (void)score(route, ground, sonar, vehicle, options); });
    fmt::print("  {:<23} {:6.1f} Mrays/s, {:3.0f} % of it\n", what, count / seconds * 1e-6,
               100.0 * bare / seconds);
  };
  run("hits, open", scene, false);
  run("hits, walls", walled, false);
  run("hits + footprints, open", scene, true);
  run("hits + footprints, walls", walled, true);
}

/// The saddle at a larger size, with as many triangles as asked for.
Seafloor large_saddle(int cells) {
  Seafloor s;
  const double size = 400.0;
  const auto n = static_cast<std::uint32_t>(cells + 1);
  for (std::uint32_t r = 0; r < n; ++r) {
    for (std::uint32_t c = 0; c < n; ++c) {
      const double x = size * (c / static_cast<double>(cells) - 0.5);
      const double y = size * (r / static_cast<double>(cells) - 0.5);
      s.vertices.emplace_back(x, y,
                              (x * x - y * y) / 3200.0 - 20.0 + 0.2 * std::sin(x) * std::cos(y));
    }
  }
  for (std::uint32_t r = 0; r + 1 < n; ++r) {
    for (std::uint32_t c = 0; c + 1 < n; ++c) {
      const std::uint32_t a = r * n + c;
      s.faces.push_back({a, a + 1, a + n + 1});
      s.faces.push_back({a, a + n + 1, a + n});
    }
  }
  return s;
}

void run_all(int threads) {
  const Sonar sonar;
  const Angle half = half_angle(sonar, footprint_width_m(sonar, 0.10), 35.0);
  const Angle heading = Angle::degrees(30);
  const Seafloor small = saddle();
  compare("saddle at 0.10 m", small, winding_route(extent(small), 7.5, heading, {half, half}), 0.10,
          threads);
  const Seafloor large = large_saddle(500);
  const Angle wide = half_angle(sonar, footprint_width_m(sonar, 0.10), 20.0);
  compare("500k triangles at 0.10 m", large,
          winding_route(extent(large), 7.5, heading, {wide, wide}), 0.10, threads);
}

}  // namespace

int main(int argc, char** argv) {
  keep_freed_memory();
  const int asked = argc > 1 ? std::atoi(argv[1]) : 0;
  if (asked > 0) {
    run_all(asked);
    return 0;
  }
  run_all(1);
  const int all = tbb::task_arena().max_concurrency();
  if (all > 1) run_all(all);
  return 0;
}
