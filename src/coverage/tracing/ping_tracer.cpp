#include "coverage/tracing/ping_tracer.h"

#include <algorithm>
#include <cmath>

#include "coverage/tracing/ray_scene_internal.h"

namespace swathplan {

namespace {

constexpr std::int32_t kNoBand = -1;
// Of a beam's hit: its range and the three parts of its normal.
constexpr std::size_t kHitFloats = 4;

// The fan's plane in the world: starboard is the course turned clockwise by a right angle.
struct FanPose {
  float starboard_x, starboard_y;
  float cos_roll, sin_roll;
};

FanPose fan_pose(const Ping& ping) {
  return {static_cast<float>(ping.course.y()), static_cast<float>(-ping.course.x()),
          static_cast<float>(cos(ping.roll)), static_cast<float>(sin(ping.roll))};
}

// Unit directions of all beams. When roll presses the starboard side down, the fan swings to port:
// a beam's angle becomes (angle - roll). `across` keeps its sine, for the way back to the plane.
SWATHPLAN_EVERY_CPU
void aim(std::size_t n, const FanPose& pose, const float* sine, const float* cosine,
         float* __restrict across, float* __restrict dx, float* __restrict dy,
         float* __restrict dz) {
  const auto [starboard_x, starboard_y, cos_roll, sin_roll] = pose;
  for (std::size_t i = 0; i < n; ++i) {
    const float s = sine[i] * cos_roll - cosine[i] * sin_roll;
    const float c = cosine[i] * cos_roll + sine[i] * sin_roll;
    across[i] = s;
    dx[i] = s * starboard_x;
    dy[i] = s * starboard_y;
    dz[i] = -c;
  }
}

// Cells from the grid's corner. No sounding of a ping farther off falls in the grid.
constexpr double kFar = 1e8;

CellFrame cell_frame(const Ping& ping, const FanPose& pose, const CoverageGrid& grid) {
  const Vec2 at = ((ping.position - grid.origin()) / grid.resolution_m())
                      .cwiseMax(Vec2::Constant(-kFar))
                      .cwiseMin(Vec2::Constant(kFar));
  CellFrame frame{};
  frame.column = static_cast<std::int32_t>(std::floor(at.x()));
  frame.row = static_cast<std::int32_t>(std::floor(at.y()));
  frame.x = static_cast<float>(at.x() - frame.column);
  frame.y = static_cast<float>(at.y() - frame.row);
  frame.starboard_x = pose.starboard_x;
  frame.starboard_y = pose.starboard_y;
  frame.cells_per_metre = static_cast<float>(1.0 / grid.resolution_m());
  frame.columns = static_cast<std::int32_t>(grid.columns());
  frame.rows = static_cast<std::int32_t>(grid.rows());
  return frame;
}

// Distance to starboard, cell and band of rows of each sounding. The band is kNoBand for a beam
// without a sounding in the grid.
SWATHPLAN_EVERY_CPU
void to_cells(std::size_t n, const CellFrame& frame, Bands bands, const float* range,
              const float* across, float* starboard, std::uint32_t* cell, std::int32_t* band) {
  const float per_x = frame.starboard_x * frame.cells_per_metre;
  const float per_y = frame.starboard_y * frame.cells_per_metre;
  for (std::size_t i = 0; i < n; ++i) {
    const float v = range[i] * across[i];
    starboard[i] = v;
    const std::int32_t column = frame.column + floor_to_int(frame.x + v * per_x);
    const std::int32_t row = frame.row + floor_to_int(frame.y + v * per_y);
    const bool inside = (range[i] > 0.0F) & (column >= 0) & (column < frame.columns) & (row >= 0) &
                        (row < frame.rows);
    cell[i] = static_cast<std::uint32_t>(row) * static_cast<std::uint32_t>(frame.columns) +
              static_cast<std::uint32_t>(column);
    band[i] =
        inside ? static_cast<std::int32_t>(bands.of_row(static_cast<std::uint32_t>(row))) : kNoBand;
  }
}

// Takes away soundings beyond what their beam reaches; returns the range of the farthest one left.
SWATHPLAN_EVERY_CPU
float farthest_within(std::size_t n, const float* reach, float* range) {
  float farthest = 0.0F;
  for (std::size_t i = 0; i < n; ++i) {
    range[i] = range[i] <= reach[i] ? range[i] : 0.0F;
    farthest = std::max(farthest, range[i]);
  }
  return farthest;
}

void split_into_runs(std::size_t n, const std::int32_t* band, std::uint32_t first, const Ping& ping,
                     BlockTrace& block) {
  for (std::size_t i = 0; i < n;) {
    std::size_t end = i + 1;
    while (end < n && band[end] == band[i]) ++end;
    if (band[i] != kNoBand) {
      block.runs[static_cast<std::uint32_t>(band[i])].push_back(
          {first + static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(end - i), ping.leg,
           ping.log});
    }
    i = end;
  }
}

// A cell's word after a sounding of the leg `code` (1..1022).
template <bool kLog>
inline std::uint32_t count_sounding(std::uint32_t word, std::uint32_t code) {
  constexpr std::uint32_t kLogged = 7U << CoverageGrid::kLoggedShift;
  word += static_cast<std::uint32_t>((word & CoverageGrid::kCountMask) != CoverageGrid::kCountMask);
  if constexpr (kLog) {
    word += static_cast<std::uint32_t>((word & kLogged) != kLogged) << CoverageGrid::kLoggedShift;
  }
  // Nearly always the cell has this leg already, or none, so the processor guesses the branches
  // right.
  const std::uint32_t leg = word >> CoverageGrid::kLegShift;
  if (leg != code) {
    word |= (leg == 0 ? code : CoverageGrid::kLegMask) << CoverageGrid::kLegShift;
  }
  return word;
}

template <bool kLog>
std::uint64_t count_run(std::span<const std::uint32_t> cells, std::uint32_t code,
                        std::uint32_t* words) {
  std::uint64_t soundings = 0;
  for (const std::uint32_t cell : cells) {
    const std::uint32_t word = words[cell];
    if ((word & CoverageGrid::kInArea) == 0) continue;
    words[cell] = count_sounding<kLog>(word, code);
    ++soundings;
  }
  return soundings;
}

}  // namespace

PingTracer::PingTracer(const RayScene& scene, const Sonar& sonar, double draft_m,
                       const CoverageGrid& grid, Bands bands, bool footprints, double swath_share)
    : scene_(&scene),
      sonar_(&sonar),
      draft_(draft_m),
      grid_(&grid),
      bands_(bands),
      footprints_(footprints),
      tables_(sonar, swath_share),
      sweep_(sonar) {}

// A fan in the world: its table, and its beams in the tracer's buffer.
struct PingTracer::Fan {
  const FanTable* table;
  FanBeams beams;
  const float* across;
};

PingTracer::Fan PingTracer::aimed(const Ping& ping) {
  const FanTable& table = tables_.get(ping.fan);
  const std::size_t n = table.padded;
  floats_.resize(5 * n);
  const auto column = [&](std::size_t k) { return floats_.data() + k * n; };
  const FanPose pose = fan_pose(ping);
  aim(n, pose, table.sine.data(), table.cosine.data(), column(0), column(1), column(2), column(3));
  return {&table, {table.beams, n, column(1), column(2), column(3)}, column(0)};
}

float PingTracer::trace_rays(const Ping& ping, const Fan& fan, float* hits) const {
  const std::size_t n = fan.beams.padded;
  const Vec3 origin(ping.position.x(), ping.position.y(), ping.heave_m - draft_);
  trace_fan(scene_->impl(), origin, fan.beams, static_cast<float>(sonar_->max_range_m),
            {hits, hits + n, hits + 2 * n, hits + 3 * n});
  return farthest_within(fan.table->beams, fan.table->reach.data(), hits);
}

void PingTracer::sort_soundings(const Ping& ping, const Fan& fan, float* hits, BlockTrace& block) {
  const std::size_t n = fan.beams.padded;
  band_of_beam_.resize(n);
  float* const starboard = floats_.data() + 4 * n;
  const auto first = static_cast<std::uint32_t>(block.cells.size());
  block.cells.resize(block.cells.size() + n);
  const CellFrame frame = cell_frame(ping, fan_pose(ping), *grid_);
  to_cells(n, frame, bands_, hits, fan.across, starboard, block.cells.data() + first,
           band_of_beam_.data());
  split_into_runs(fan.table->beams, band_of_beam_.data(), first, ping, block);
  block.rays += fan.table->beams;
  if (footprints_) {
    sweep_.add({fan.table, hits, starboard, fan.beams.dx, fan.beams.dy, fan.beams.dz, hits + n,
                hits + 2 * n, hits + 3 * n},
               frame, ping.log, block.swept);
  }
}

void PingTracer::start(BlockTrace& block) const {
  block.cells.clear();
  block.runs.resize(bands_.count);
  for (auto& runs : block.runs) runs.clear();
  block.rays = 0;
  block.swept.clear();
}

void PingTracer::trace(std::span<const Ping> pings, BlockTrace& block) {
  start(block);
  for (const Ping& ping : pings) {
    const Fan fan = aimed(ping);
    hits_.resize(kHitFloats * fan.beams.padded);
    trace_rays(ping, fan, hits_.data());
    sort_soundings(ping, fan, hits_.data(), block);
  }
  sweep_.flush(block.swept);
}

float PingTracer::trace_rays(const Ping& ping, BlockHits& hits) {
  const Fan fan = aimed(ping);
  const std::size_t start = hits.floats.size();
  hits.starts.push_back(start);
  hits.floats.resize(start + kHitFloats * fan.beams.padded);
  return trace_rays(ping, fan, hits.floats.data() + start);
}

void PingTracer::sort_soundings(std::span<const Ping> pings, BlockHits& hits, BlockTrace& block) {
  start(block);
  for (std::size_t i = 0; i < pings.size(); ++i) {
    sort_soundings(pings[i], aimed(pings[i]), hits.floats.data() + hits.starts[i], block);
  }
  sweep_.flush(block.swept);
}

std::uint64_t count_band(std::span<const BlockTrace> blocks, Bands bands, std::uint32_t band,
                         CoverageGrid& grid) {
  std::uint64_t soundings = 0;
  std::uint32_t* const words = grid.words().data();
  for (const BlockTrace& block : blocks) {
    for (const CellRun& run : block.runs[band]) {
      const std::uint32_t code = run.leg % (CoverageGrid::kLegMask - 1U) + 1U;
      const auto cells = std::span(block.cells).subspan(run.first, run.count);
      soundings +=
          run.log ? count_run<true>(cells, code, words) : count_run<false>(cells, code, words);
    }
    for (const SweptPatch& patch : block.swept) mark_band(patch, bands, band, grid);
  }
  return soundings;
}

}  // namespace swathplan
