#include "coverage/tracing/footprint.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace swathplan {

namespace {

// Largest stretch of a footprint by incidence: that of 80 degrees. At more grazing angles the width
// of a beam says nothing about what the beam sees.
constexpr float kMaxStretch = 5.76F;

// How far across a beam reaches at most to either side: half its own width or half the beam
// spacing, whichever is more, on the slope that it met.
SWATHPLAN_EVERY_CPU
void reach(std::size_t n, const FanSoundings& f, float half_across, float scale,
           float* __restrict port, float* __restrict starboard) {
  const float* const step = f.table->step.data();
  const float* const next = f.table->next_step.data();
  const float *const range = f.range, *const dx = f.dx, *const dy = f.dy, *const dz = f.dz;
  const float *const nx = f.nx, *const ny = f.ny, *const nz = f.nz;
  for (std::size_t i = 0; i < n; ++i) {
    const float facing = std::abs(nx[i] * dx[i] + ny[i] * dy[i] + nz[i] * dz[i]);
    // The order matters: 0 / 0 is no number, and std::min then returns its first argument.
    const float stretch = std::min(kMaxStretch, std::abs(nz[i]) / facing);
    const float size = range[i] * stretch * scale;
    port[i] = size * std::max(half_across, 0.5F * step[i]);
    starboard[i] = size * std::max(half_across, 0.5F * next[i]);
  }
}

// Whether every beam met the seafloor farther to starboard than the one before.
SWATHPLAN_EVERY_CPU
bool ascends(std::size_t n, const float* range, const float* at) {
  std::int32_t faults = range[0] > 0.0F ? 0 : 1;
  for (std::size_t i = 1; i < n; ++i) {
    faults |= static_cast<std::int32_t>(!((range[i] > 0.0F) & (at[i] > at[i - 1])));
  }
  return faults == 0;
}

struct Sizes {
  float scale, half;  // cells a metre; half_along in cells at range 1
};

SWATHPLAN_EVERY_CPU
void lengths(std::size_t n, const Sizes& s, const float* range, const float* starboard,
             float* __restrict at, float* __restrict half_along) {
  const float scale = s.scale;
  const float half = s.half;
  for (std::size_t i = 0; i < n; ++i) {
    at[i] = starboard[i] * scale;
    half_along[i] = range[i] * half;
  }
}

// Eight at a time: the compiler makes one instruction of them.
SWATHPLAN_EVERY_CPU
float least_of(std::size_t n, const float* values) {
  constexpr std::size_t kLanes = 8;
  float least[kLanes];
  std::fill_n(least, kLanes, -FanFootprints::kNoFootprint);
  std::size_t i = 0;
  for (; i + kLanes <= n; i += kLanes) {
    for (std::size_t j = 0; j < kLanes; ++j) least[j] = std::min(least[j], values[i + j]);
  }
  for (; i < n; ++i) least[0] = std::min(least[0], values[i]);
  return *std::min_element(least, least + kLanes);
}

// Two footprints that overlap meet about half-way between their soundings.
inline float border_between(float at_port, float at, float left, float right_port) {
  return std::min(std::max(0.5F * (at_port + at), left), right_port);
}

// Left and right ends of a fan that ascends.
SWATHPLAN_EVERY_CPU
void ends(std::size_t n, const float* at, const float* port, const float* starboard, float* left,
          float* right) {
  left[0] = at[0] - port[0];
  right[n - 1] = at[n - 1] + starboard[n - 1];
  for (std::size_t i = 1; i < n; ++i) {
    const float l = at[i] - port[i];
    const float r = at[i - 1] + starboard[i - 1];
    const float border = border_between(at[i - 1], at[i], l, r);
    left[i] = r > l ? border : l;
    right[i - 1] = r > l ? border : r;
  }
}

}  // namespace

BeamWidths::BeamWidths(const Sonar& sonar)
    : half_along(static_cast<float>(tan(sonar.beam_width_along / 2.0))),
      half_across(static_cast<float>(sonar.beam_width_across.rad() / 2.0)) {}

void FanFootprints::build(const FanSoundings& fan, const BeamWidths& widths,
                          const CellFrame& cells) {
  frame = cells;
  const std::size_t n = fan.table->padded;
  for (auto* array : {&cap_port_, &cap_starboard_, &at, &left, &right, &half_along}) {
    array->resize(n);
  }
  const float scale = cells.cells_per_metre;
  reach(n, fan, widths.half_across, scale, cap_port_.data(), cap_starboard_.data());
  const std::size_t count = fan.table->beams;
  lengths(count, {scale, widths.half_along * scale}, fan.range, fan.starboard, at.data(),
          half_along.data());
  if (ascends(count, fan.range, at.data())) {
    ends(count, at.data(), cap_port_.data(), cap_starboard_.data(), left.data(), right.data());
    shortest = least_of(count, half_along.data());
  } else {
    build_with_gaps(fan);
  }
  for (auto* array : {&at, &left, &right, &half_along}) array->resize(count);
}

// Beams that climb a wall meet it above one another. Only the first of them has a footprint.
void FanFootprints::build_with_gaps(const FanSoundings& fan) {
  const std::size_t count = fan.table->beams;
  std::size_t last = count;  // the footprint before
  shortest = -kNoFootprint;
  for (std::size_t i = 0; i < count; ++i) {
    const float v = at[i];
    left[i] = right[i] = v;
    if (!(fan.range[i] > 0.0F) || (last < count && !(v > at[last]))) {
      half_along[i] = kNoFootprint;
      continue;
    }
    left[i] = v - cap_port_[i];
    right[i] = v + cap_starboard_[i];
    shortest = std::min(shortest, half_along[i]);
    if (last < count && right[last] > left[i]) {
      right[last] = left[i] = border_between(at[last], v, left[i], right[last]);
    }
    last = i;
  }
}

namespace {

// Beams to either side over which a reach is sure. A floor that slopes along the course moves
// soundings across by a few beams between key pings.
constexpr std::size_t kSureBeams = 4;
constexpr std::size_t kSureSpan = 2 * kSureBeams + 1;
SWATHPLAN_EVERY_CPU
void least_of_span(std::size_t n, const float* values, float* least) {
  for (std::size_t i = 0; i < n; ++i) least[i] = values[i];
  for (std::size_t j = 1; j < kSureSpan; ++j) {
    for (std::size_t i = 0; i < n; ++i) least[i] = std::min(least[i], values[i + j]);
  }
}

}  // namespace

void SureReach::build(const FanFootprints& fan) {
  const std::size_t n = fan.beams();
  // Beyond the outermost beams no beam asks, and nothing is covered.
  at_.assign(n + 2 * kSureBeams, n > 0 ? fan.left[0] : 0.0F);
  cover_.assign(n + 2 * kSureBeams, -FanFootprints::kNoFootprint);
  low.resize(n);
  high.resize(n);
  least.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const bool joined = i + 1 == n || fan.right[i] >= fan.left[i + 1];
    at_[i + kSureBeams] = fan.at[i];
    cover_[i + kSureBeams] = joined ? fan.half_along[i] : FanFootprints::kNoFootprint;
  }
  for (std::size_t j = 0; j < kSureBeams && n > 0; ++j) at_[n + kSureBeams + j] = fan.right[n - 1];
  std::copy_n(at_.begin(), n, low.begin());
  std::copy_n(at_.begin() + 2 * kSureBeams, n, high.begin());
  least_of_span(n, cover_.data(), least.data());
}

void FootprintPieces::assign(const FanFootprints& fan, std::size_t first, std::size_t end) {
  left.clear();
  right.clear();
  half_along.clear();
  for (std::size_t i = first; i < end; ++i) {
    if (fan.half_along[i] < 0.0F) continue;
    left.push_back(fan.left[i]);
    right.push_back(fan.right[i]);
    half_along.push_back(fan.half_along[i]);
  }
}

bool FootprintPieces::covers(float along, float starboard) const {
  const std::int64_t bin = std::int64_t{floor_to_int(starboard)} - first_bin;
  if (bin < 0 || bin >= static_cast<std::int64_t>(first_in_bin.size())) return false;
  for (std::size_t p = first_in_bin[static_cast<std::size_t>(bin)];
       p < left.size() && left[p] <= starboard; ++p) {
    if (right[p] >= starboard && std::abs(along) <= half_along[p]) return true;
  }
  return false;
}

}  // namespace swathplan
