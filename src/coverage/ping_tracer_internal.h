#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "coverage/coverage_grid.h"
#include "coverage/fan_table_internal.h"
#include "coverage/pings.h"
#include "coverage/ray_scene.h"

/// Hot loops in one build for every processor: the widest instructions are chosen at run time. The
/// results are the same bits, for no multiply-add is ever contracted. The sanitizers cannot stand
/// code that is chosen before they start.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define SWATHPLAN_EVERY_CPU __attribute__((target_clones("avx2", "default")))
#else
#define SWATHPLAN_EVERY_CPU
#endif

namespace swathplan {

/// Bands of grid rows: 16 rows make a strip, strips are dealt to the bands in turn, and one task
/// counts one band, so that no word of the grid is ever written by two.
inline constexpr std::uint32_t kBands = 16;
inline constexpr int kStripShift = 4;
[[nodiscard]] constexpr std::uint32_t band_of_row(std::uint32_t row) {
  return (row >> kStripShift) % kBands;
}

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
  std::uint64_t rays = 0;
};

/// Traces blocks of pings; one per thread, for it keeps its buffers.
class PingTracer {
 public:
  PingTracer(const RayScene& scene, const Sonar& sonar, double draft_m, const CoverageGrid& grid);

  void trace(std::span<const Ping> pings, BlockTrace& block);

 private:
  void trace_ping(const Ping& ping, BlockTrace& block);

  const RayScene* scene_;
  const Sonar* sonar_;
  double draft_;
  const CoverageGrid* grid_;
  FanTableCache tables_;
  std::vector<float> floats_;
  std::vector<std::int32_t> strips_;
};

/// Counts one band of a batch of blocks into the grid; returns the soundings inside the area.
std::uint64_t count_band(std::span<const BlockTrace> blocks, std::uint32_t band,
                         CoverageGrid& grid);

}  // namespace swathplan
