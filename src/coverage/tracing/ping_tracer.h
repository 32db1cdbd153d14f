#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "coverage/route/pings.h"
#include "coverage/tracing/coverage_grid.h"
#include "coverage/tracing/cpu.h"
#include "coverage/tracing/fan_table.h"
#include "coverage/tracing/footprint.h"
#include "coverage/tracing/ray_scene.h"

namespace swathplan {

/// Neighbouring beams of one ping whose soundings fell in the same band of rows.
struct CellRun {
  std::uint32_t first, count;  ///< into BlockTrace::cells
  std::uint32_t leg;
  bool log;
};

/// What a block of pings gave, ready to be counted band by band.
struct BlockTrace {
  std::vector<std::uint32_t> cells;        ///< cell index per beam
  std::vector<std::vector<CellRun>> runs;  ///< per band
  std::vector<SweptPatch> swept;           ///< footprints, if wanted
  std::uint64_t rays = 0;
};

/// Where the beams of a block of pings met the seafloor, fan after fan.
struct BlockHits {
  std::vector<float> floats;        ///< per ping: ranges and normals
  std::vector<std::size_t> starts;  ///< of each ping, into `floats`
};

/// Traces blocks of pings. Each thread needs its own: it keeps its buffers between blocks.
class PingTracer {
 public:
  PingTracer(const RayScene& scene, const Sonar& sonar, double draft_m, const CoverageGrid& grid,
             Bands bands, bool footprints, double swath_share);

  /// Traces the pings and sorts their soundings into the grid's cells.
  void trace(std::span<const Ping> pings, BlockTrace& block);

  /// The same in two steps, where the next ping hangs on what this one met. First the rays of one
  /// ping more of a block; returns the slant range of its farthest sounding, 0 without one.
  float trace_rays(const Ping& ping, BlockHits& hits);
  /// Then the cells of a whole block.
  void sort_soundings(std::span<const Ping> pings, BlockHits& hits, BlockTrace& block);

 private:
  struct Fan;
  void start(BlockTrace& block) const;
  Fan aimed(const Ping& ping);
  float trace_rays(const Ping& ping, const Fan& fan, float* hits) const;
  void sort_soundings(const Ping& ping, const Fan& fan, float* hits, BlockTrace& block);

  const RayScene* scene_;
  const Sonar* sonar_;
  double draft_;
  const CoverageGrid* grid_;
  Bands bands_;
  bool footprints_;
  FanTableCache tables_;
  FootprintSweep sweep_;
  std::vector<float> floats_, hits_;
  std::vector<std::int32_t> band_of_beam_;
};

/// Counts one band of some blocks into the grid, and returns the soundings in counting cells.
std::uint64_t count_band(std::span<const BlockTrace> blocks, Bands bands, std::uint32_t band,
                         CoverageGrid& grid);

}  // namespace swathplan
