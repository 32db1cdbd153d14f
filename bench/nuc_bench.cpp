// NUC over lattices of right isosceles triangles: time for the shared edges and the skeleton, which
// must grow linearly with the faces.

#include <benchmark/benchmark.h>

#include <cmath>

#include "mesh/base/allocator.h"
#include "planners/nuc/nuc.h"

namespace {

using namespace swathplan;

/// At least `faces` triangles in a square lattice.
PlanarMesh lattice(std::int64_t faces) {
  const auto side =
      static_cast<std::uint32_t>(std::ceil(std::sqrt(static_cast<double>(faces) / 2.0)));
  PlanarMesh mesh;
  for (std::uint32_t y = 0; y <= side; ++y) {
    for (std::uint32_t x = 0; x <= side; ++x) mesh.vertices.emplace_back(x, y);
  }
  for (std::uint32_t y = 0; y < side; ++y) {
    for (std::uint32_t x = 0; x < side; ++x) {
      const std::uint32_t a = y * (side + 1) + x;
      mesh.faces.push_back({a, a + 1, a + side + 2});
      mesh.faces.push_back({a, a + side + 2, a + side + 1});
    }
  }
  return mesh;
}

void BM_Nuc(benchmark::State& state) {
  const PlanarMesh mesh = lattice(state.range(0));
  for (auto _ : state) {
    const auto edges = shared_edges(mesh);
    benchmark::DoNotOptimize(nuc_skeleton(mesh, edges));
  }
  const auto faces = static_cast<double>(mesh.faces.size());
  state.counters["faces"] = faces;
  state.counters["ns_per_face"] = benchmark::Counter(
      faces * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(BM_Nuc)->Arg(10000)->Arg(100000)->Arg(1000000)->MinWarmUpTime(0.5)->Unit(
    benchmark::kMillisecond);

}  // namespace

int main(int argc, char** argv) {
  swathplan::keep_freed_memory();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
