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

/// Traces blocks of pings; one per thread, for it keeps its buffers.
class PingTracer {
 public:
  PingTracer(const RayScene& scene, const Sonar& sonar, double draft_m, const CoverageGrid& grid,
             Bands bands, bool footprints, double swath_share);

  void trace(std::span<const Ping> pings, BlockTrace& block);

 private:
  void trace_ping(const Ping& ping, BlockTrace& block);

  const RayScene* scene_;
  const Sonar* sonar_;
  double draft_;
  const CoverageGrid* grid_;
  Bands bands_;
  bool footprints_;
  FanTableCache tables_;
  FootprintSweep sweep_;
  std::vector<float> floats_;
  std::vector<std::int32_t> band_of_beam_;
};

/// Counts one band of a batch of blocks into the grid; returns the soundings inside the area.
std::uint64_t count_band(std::span<const BlockTrace> blocks, Bands bands, std::uint32_t band,
                         CoverageGrid& grid);

}  // namespace swathplan
