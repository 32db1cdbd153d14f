// Smoothing of a NUC skeleton over a square of water with an island: seconds by Ipopt, which must
// grow linearly with the path's length.
//   smooth_bench [kilometres ...]   default: 10 35 70

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "mesh/base/allocator.h"
#include "mesh/synthetic.h"
#include "planners/nuc/nuc.h"
#include "planners/nuc/skeleton_smoothing.h"

namespace {

using namespace swathplan;

/// NUC over faces of kFaceSize W is about so many times as long as area / W.
constexpr double kLengthRatio = 2.95;
constexpr double kDepth = 20.0;

Ring square(double low_m, double high_m, bool counterclockwise) {
  Ring ring{{low_m, low_m}, {high_m, low_m}, {high_m, high_m}, {low_m, high_m}};
  if (!counterclockwise) std::reverse(ring.begin(), ring.end());
  return ring;
}

void run(double kilometres) {
  PlanOptions options;
  const double width = footprint_width_m(options);
  const double side = std::floor(std::sqrt(1000.0 * kilometres / kLengthRatio * width));
  const Seafloor seafloor = flat(side, side, kDepth);
  const DepthQuery depths(seafloor);
  const Area water{{square(0.0, side, true), {square(0.42 * side, 0.58 * side, false)}}};
  const PlanarMesh mesh = planar_mesh(water, {.hypotenuse_m = kFaceSize * width});
  const auto cycles = nuc_skeleton(mesh, shared_edges(mesh));
  SmoothResult verdict;
  const auto begin = std::chrono::steady_clock::now();
  const ThinCover cover(depths, water, options);
  const FannedCover fanned{cover, [&](std::uint32_t) { return fan_for_depth(options, kDepth); }};
  const auto path = smoothed(cycles.front(), {}, water, smoothing_for(options), verdict, &fanned);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  double length = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    length += (path[i].position - path[i - 1].position).norm();
  }
  fmt::print("{:.1f} km, {} skeleton points: {:.1f} s, {:.2f} s a km; {} windows", length / 1000.0,
             cycles.front().size(), took.count(), 1000.0 * took.count() / length, verdict.windows);
  for (const auto& [status, count] : verdict.status) fmt::print(", {}: {}", status, count);
  fmt::print("; {:.0f} m kept\n", verdict.failed_m);
}

}  // namespace

int main(int argc, char** argv) {
  swathplan::keep_freed_memory();
  if (argc < 2) {
    for (const double kilometres : {10.0, 35.0, 70.0}) run(kilometres);
  }
  for (int i = 1; i < argc; ++i) run(std::atof(argv[i]));
  return 0;
}
