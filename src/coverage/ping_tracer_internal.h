#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "coverage/coverage_grid.h"
#include "coverage/cpu_internal.h"
#include "coverage/fan_table_internal.h"
#include "coverage/footprint_internal.h"
#include "coverage/pings.h"
#include "coverage/ray_scene.h"

namespace swathplan {

/// Neighbouring beams of one ping whose soundings fell in the same strip of rows.
struct CellRun {
  std::uint32_t first, count;  ///< into BlockTrace::cells
  std::uint32_t leg;
  bool log;
};

/// What a block of pings gave, ready to be counted band by band.
struct BlockTrace {
  std::vector<std::uint32_t> cells;  ///< cell index per beam
  std::array<std::vector<CellRun>, kBands> runs;
  std::vector<SweptPatch> swept;  ///< footprints, if wanted
  std::uint64_t rays = 0;
};

/// Traces blocks of pings; one per thread, for it keeps its buffers.
class PingTracer {
 public:
  PingTracer(const RayScene& scene, const Sonar& sonar, double draft_m, const CoverageGrid& grid,
             bool footprints);

  void trace(std::span<const Ping> pings, BlockTrace& block);

 private:
  void trace_ping(const Ping& ping, BlockTrace& block);

  const RayScene* scene_;
  const Sonar* sonar_;
  double draft_;
  const CoverageGrid* grid_;
  bool footprints_;
  FanTableCache tables_;
  FootprintSweep sweep_;
  std::vector<float> floats_;
  std::vector<std::int32_t> strips_;
};

/// Counts one band of a batch of blocks into the grid; returns the soundings inside the area.
std::uint64_t count_band(std::span<const BlockTrace> blocks, std::uint32_t band,
                         CoverageGrid& grid);

}  // namespace swathplan
