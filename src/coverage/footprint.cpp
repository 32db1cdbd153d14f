#include <algorithm>
#include <cmath>
#include <limits>

#include "coverage/footprint_internal.h"

namespace swathplan {

namespace {

// Largest stretch of a footprint by incidence: that of 80 degrees. Beyond it the width of a beam
// says nothing about what it sees.
constexpr float kMaxStretch = 5.76F;
constexpr float kNoHalf = std::numeric_limits<float>::infinity();

// Half-widths across that a beam reaches at most to either side: half its own beam width or half
// the beam spacing, whichever is more, on the slope that it met.
SWATHPLAN_EVERY_CPU
void reach(std::size_t n, const FanSoundings& f, float half_across, float scale, float* port,
           float* starboard) {
  const float* const step = f.table->step.data();
  const float* const next = f.table->next_step.data();
  for (std::size_t i = 0; i < n; ++i) {
    const float facing = std::abs(f.nx[i] * f.dx[i] + f.ny[i] * f.dy[i] + f.nz[i] * f.dz[i]);
    const float up = std::abs(f.nz[i]);
    const float stretch = up < kMaxStretch * facing ? up / facing : kMaxStretch;
    const float size = f.range[i] * stretch * scale;
    port[i] = size * std::max(half_across, 0.5F * step[i]);
    starboard[i] = size * std::max(half_across, 0.5F * next[i]);
  }
}

}  // namespace

BeamWidths::BeamWidths(const Sonar& sonar)
    : half_along(static_cast<float>(tan(sonar.beam_width_along / 2.0))),
      half_across(static_cast<float>(sonar.beam_width_across.rad() / 2.0)) {}

void FootprintPieces::build(const FanSoundings& fan, const BeamWidths& widths,
                            float cells_per_metre) {
  const std::size_t n = fan.table->padded;
  cap_port_.resize(n);
  cap_starboard_.resize(n);
  left.resize(n);
  right.resize(n);
  half_along.resize(n);
  reach(n, fan, widths.half_across, cells_per_metre, cap_port_.data(), cap_starboard_.data());
  const float half = widths.half_along * cells_per_metre;
  std::size_t count = 0;
  float before = -kNoHalf;  // sounding of the last piece
  for (std::size_t i = 0; i < fan.table->beams; ++i) {
    if (!(fan.range[i] > 0.0F)) continue;
    const float at = fan.starboard[i] * cells_per_metre;
    // Beams that climb a wall lie above one another: the first of them stands for all.
    if (!(at > before)) continue;
    left[count] = at - cap_port_[i];
    right[count] = at + cap_starboard_[i];
    half_along[count] = fan.range[i] * half;
    if (count > 0 && right[count - 1] > left[count]) {
      // Where two footprints overlap each gives way to the other about half-way.
      const float border = std::clamp(0.5F * (before + at), left[count], right[count - 1]);
      right[count - 1] = left[count] = border;
    }
    before = at;
    ++count;
  }
  left.resize(count);
  right.resize(count);
  half_along.resize(count);
}

bool FootprintPieces::covers(float along, float starboard) const {
  const auto after = std::upper_bound(left.begin(), left.end(), starboard);
  auto p = static_cast<std::size_t>(after - left.begin());
  while (p-- > 0 && right[p] >= starboard) {
    if (std::abs(along) <= half_along[p]) return true;
  }
  return false;
}

// A ping seen along lines of the grid: `a` counts lines, `b` cells along a line.
struct FootprintSweep::LineFrame {
  std::int32_t line, cell;  // of the boat
  float a, b;               // within its cell
  float along_a, along_b, starboard_a, starboard_b;
  std::int32_t lines, cells;

  LineFrame(const CellFrame& f, bool by_columns) {
    const float course_x = -f.starboard_y;
    const float course_y = f.starboard_x;
    if (by_columns) {
      line = f.column, cell = f.row, a = f.x, b = f.y;
      along_a = course_x, along_b = course_y;
      starboard_a = f.starboard_x, starboard_b = f.starboard_y;
      lines = f.columns, cells = f.rows;
    } else {
      line = f.row, cell = f.column, a = f.y, b = f.x;
      along_a = course_y, along_b = course_x;
      starboard_a = f.starboard_y, starboard_b = f.starboard_x;
      lines = f.rows, cells = f.columns;
    }
  }
};

namespace {

// A patch keeps its axis while the course stays within about 54 degrees of it, so that a course
// near 45 degrees does not swing between the two.
constexpr float kKeepAxis = 0.585F;

// out[i] = best of in[i - r .. i + r], in O(log r) passes; in and out padded with r on each side.
template <class Best>
void slide(const std::vector<float>& in, std::vector<float>& out, std::size_t r, Best best) {
  out = in;
  const std::size_t window = 2 * r + 1;
  std::size_t span = 1;
  for (; 2 * span <= window; span *= 2) {
    for (std::size_t i = 0; i + span < out.size(); ++i) out[i] = best(out[i], out[i + span]);
  }
  const std::size_t rest = window - span;
  // Now out[i] covers [i, i + span); place the window's middle.
  for (std::size_t i = 0; i + rest < out.size(); ++i) out[i] = best(out[i], out[i + rest]);
}

}  // namespace

// Resamples the pieces to whole cells across, `reach` cells wider on each side, and takes the least
// and the most over windows of +-reach.
void FootprintSweep::profile(float reach) {
  const auto r = static_cast<std::int32_t>(std::ceil(reach));
  const std::int32_t low = floor_to_int(pieces_.left.front());
  const std::int32_t high = floor_to_int(pieces_.right.back());
  first_bin_ = low - r - 1;
  const auto bins = static_cast<std::size_t>(high - low + 1 + 4 * (r + 1));
  least_.assign(bins, kNoHalf);
  most_.assign(bins, 0.0F);
  const std::int32_t base = low - 2 * (r + 1);
  const auto gap = [&](std::int32_t from, std::int32_t to) {
    for (std::int32_t k = from; k <= to; ++k) least_[static_cast<std::size_t>(k - base)] = 0.0F;
  };
  gap(base, low);
  for (std::size_t p = 0; p < pieces_.left.size(); ++p) {
    const std::int32_t end = floor_to_int(pieces_.right[p]);
    for (std::int32_t k = floor_to_int(pieces_.left[p]); k <= end; ++k) {
      const auto bin = static_cast<std::size_t>(k - base);
      least_[bin] = std::min(least_[bin], pieces_.half_along[p]);
      most_[bin] = std::max(most_[bin], pieces_.half_along[p]);
    }
    if (p + 1 < pieces_.left.size() && pieces_.right[p] < pieces_.left[p + 1]) {
      gap(end, floor_to_int(pieces_.left[p + 1]));
    }
  }
  gap(high, base + static_cast<std::int32_t>(bins) - 1);
  const auto window = static_cast<std::size_t>(r);
  slide(least_, window_least_, window, [](float x, float y) { return std::min(x, y); });
  slide(most_, window_most_, window, [](float x, float y) { return std::max(x, y); });
  first_bin_ = base + r;  // window_[i] is centred on bin base + r + i
}

namespace {

struct LineSums {
  float first_across;  // distance across, at no distance along, of the first line
  float per_line;      // and how it grows from line to line
  float first_middle;  // cell where the first line crosses the fan's plane, less half a cell
  float middle_per_line;
  float per_half;  // cells along the line per cell along the course
};

// Cells of each line that are surely covered, and those that may be.
SWATHPLAN_EVERY_CPU
void line_intervals(std::size_t n, const LineSums& s, std::int32_t first_bin, const float* least,
                    const float* most, std::int32_t* sure_low, std::int32_t* sure_high,
                    std::int32_t* low, std::int32_t* high) {
  for (std::size_t i = 0; i < n; ++i) {
    const auto k = static_cast<float>(static_cast<std::int32_t>(i));
    const std::int32_t bin = floor_to_int(s.first_across + k * s.per_line) - first_bin;
    const float middle = s.first_middle + k * s.middle_per_line;
    // Nothing is sure in a gap, not even a cell right in the fan's plane.
    const float inner = least[bin] > 0.0F ? least[bin] * s.per_half : -1.0F;
    const float outer = most[bin] > 0.0F ? most[bin] * s.per_half : -1.0F;
    sure_low[i] = -floor_to_int(inner - middle);
    sure_high[i] = floor_to_int(inner + middle);
    low[i] = -floor_to_int(outer - middle);
    high[i] = floor_to_int(outer + middle);
  }
}

}  // namespace

void FootprintSweep::add_lines(const LineFrame& f) {
  const float left = pieces_.left.front();
  const float right = pieces_.right.back();
  const float longest = *std::max_element(pieces_.half_along.begin(), pieces_.half_along.end());
  const float per_along = f.starboard_b / f.along_b;  // across per along, on a line
  profile(longest * std::abs(per_along) + 1.0F);
  // Lines that the fan can meet.
  const float spread = longest * std::abs(f.along_a);
  const float low_a = std::min(left * f.starboard_a, right * f.starboard_a) - spread;
  const float high_a = std::max(left * f.starboard_a, right * f.starboard_a) + spread;
  const std::int32_t first = std::max(-f.line, -floor_to_int(-(low_a + f.a - 0.5F)));
  const std::int32_t last = std::min(f.lines - 1 - f.line, floor_to_int(high_a + f.a - 0.5F));
  if (first > last) return;
  make_room(f.line + first, f.line + last);

  const auto n = static_cast<std::size_t>(last - first + 1);
  sure_low_.resize(n);
  sure_high_.resize(n);
  low_.resize(n);
  high_.resize(n);
  const float per_line = f.starboard_a - f.along_a * per_along;
  const float da = static_cast<float>(first) + 0.5F - f.a;
  const LineSums sums{da * per_line, per_line, -da * f.along_a / f.along_b + f.b - 0.5F,
                      -f.along_a / f.along_b, 1.0F / std::abs(f.along_b)};
  line_intervals(n, sums, first_bin_, window_least_.data(), window_most_.data(), sure_low_.data(),
                 sure_high_.data(), low_.data(), high_.data());
  for (std::size_t i = 0; i < n; ++i) {
    if (low_[i] > high_[i]) continue;
    const std::int32_t line = first + static_cast<std::int32_t>(i);
    if (low_[i] == sure_low_[i] && high_[i] == sure_high_[i]) {
      merge(f.line + line, f.cell + low_[i], f.cell + high_[i]);
    } else {
      add_line_exactly(f, line, static_cast<float>(line) + 0.5F - f.a, low_[i], high_[i],
                       sure_low_[i], sure_high_[i]);
    }
  }
}

// Tests the cells that the profile leaves open one by one and merges what is covered, run by run.
void FootprintSweep::add_line_exactly(const LineFrame& f, std::int32_t line, float across,
                                      std::int32_t low, std::int32_t high, std::int32_t sure_low,
                                      std::int32_t sure_high) {
  const auto covered = [&](std::int32_t cell) {
    if (cell >= sure_low && cell <= sure_high) return true;
    const float db = static_cast<float>(cell) + 0.5F - f.b;
    return pieces_.covers(across * f.along_a + db * f.along_b,
                          across * f.starboard_a + db * f.starboard_b);
  };
  for (std::int32_t cell = low; cell <= high;) {
    if (!covered(cell)) {
      ++cell;
      continue;
    }
    const std::int32_t start = cell;
    while (cell <= high && covered(cell))
      cell = cell == sure_low && sure_low <= sure_high ? sure_high + 1 : cell + 1;
    merge(f.line + line, f.cell + start, f.cell + cell - 1);
  }
}

void FootprintSweep::merge(std::int32_t line, std::int32_t low, std::int32_t high) {
  const auto i = static_cast<std::size_t>(line - patch_.first_line);
  std::int32_t& l = patch_.low[i];
  std::int32_t& h = patch_.high[i];
  if (l > h) {
    l = low;
    h = high;
  } else if (low <= h + 1 && high >= l - 1) {
    l = std::min(l, low);
    h = std::max(h, high);
  } else {
    patch_.more.push_back({line, l, h});
    l = low;
    h = high;
  }
}

// Widens the patch to the lines first..last.
void FootprintSweep::make_room(std::int32_t first, std::int32_t last) {
  constexpr std::int32_t kNone = std::numeric_limits<std::int32_t>::max();
  if (patch_.low.empty()) patch_.first_line = first;
  if (first < patch_.first_line) {
    const auto extra = static_cast<std::size_t>(patch_.first_line - first);
    patch_.low.insert(patch_.low.begin(), extra, kNone);
    patch_.high.insert(patch_.high.begin(), extra, -1);
    patch_.first_line = first;
  }
  const auto size = static_cast<std::size_t>(last - patch_.first_line + 1);
  if (patch_.low.size() < size) {
    patch_.low.resize(size, kNone);
    patch_.high.resize(size, -1);
  }
}

void FootprintSweep::add(const FanSoundings& fan, const CellFrame& frame, bool log,
                         std::vector<SweptPatch>& patches) {
  pieces_.build(fan, widths_, frame.cells_per_metre);
  if (pieces_.left.empty()) return;
  const std::uint32_t flags =
      CoverageGrid::kFootprint | (log ? CoverageGrid::kLoggedFootprint : 0U);
  const float along_columns = std::abs(frame.starboard_x);  // |course.y|
  const float along_rows = std::abs(frame.starboard_y);
  const bool turned = (patch_.by_columns ? along_columns : along_rows) < kKeepAxis;
  if (open_ && (turned || patch_.flags != flags)) flush(patches);
  if (!open_) {
    patch_.by_columns = along_columns >= along_rows;
    patch_.flags = flags;
    open_ = true;
  }
  add_lines(LineFrame(frame, patch_.by_columns));
}

void FootprintSweep::flush(std::vector<SweptPatch>& patches) {
  if (open_ && !patch_.low.empty()) patches.push_back(std::move(patch_));
  patch_ = {};
  open_ = false;
}

namespace {

inline std::uint32_t flagged(std::uint32_t word, std::uint32_t flags) {
  const std::uint32_t in_area = (word & CoverageGrid::kInArea) != 0 ? ~0U : 0U;
  return word | (flags & in_area);
}

SWATHPLAN_EVERY_CPU
void mark_across(std::uint32_t* words, std::size_t n, std::int32_t cell, const std::int32_t* low,
                 const std::int32_t* high, std::uint32_t flags) {
  for (std::size_t i = 0; i < n; ++i) {
    words[i] = flagged(words[i], (low[i] <= cell) & (cell <= high[i]) ? flags : 0U);
  }
}

SWATHPLAN_EVERY_CPU
void mark_along(std::uint32_t* words, std::size_t n, std::uint32_t flags) {
  for (std::size_t i = 0; i < n; ++i) words[i] = flagged(words[i], flags);
}

void mark_row(std::int32_t row, std::int32_t low, std::int32_t high, std::uint32_t flags,
              CoverageGrid& grid) {
  low = std::max(low, 0);
  high = std::min(high, static_cast<std::int32_t>(grid.columns()) - 1);
  if (low > high) return;
  mark_along(grid.words().data() + static_cast<std::size_t>(row) * grid.columns() +
                 static_cast<std::size_t>(low),
             static_cast<std::size_t>(high - low + 1), flags);
}

template <class Visit>
void rows_of_band(std::int32_t low, std::int32_t high, std::uint32_t band, const CoverageGrid& grid,
                  Visit visit) {
  low = std::max(low, 0);
  high = std::min(high, static_cast<std::int32_t>(grid.rows()) - 1);
  for (std::int32_t row = low; row <= high; ++row) {
    if (band_of_row(static_cast<std::uint32_t>(row)) == band) visit(row);
  }
}

void mark_columns(const SweptPatch& patch, std::uint32_t band, CoverageGrid& grid) {
  const std::int32_t low = *std::min_element(patch.low.begin(), patch.low.end());
  const std::int32_t high = *std::max_element(patch.high.begin(), patch.high.end());
  rows_of_band(low, high, band, grid, [&](std::int32_t row) {
    mark_across(grid.words().data() + static_cast<std::size_t>(row) * grid.columns() +
                    static_cast<std::size_t>(patch.first_line),
                patch.low.size(), row, patch.low.data(), patch.high.data(), patch.flags);
  });
  for (const LineCells& more : patch.more) {
    rows_of_band(more.low, more.high, band, grid,
                 [&](std::int32_t row) { mark_row(row, more.line, more.line, patch.flags, grid); });
  }
}

void mark_rows(const SweptPatch& patch, std::uint32_t band, CoverageGrid& grid) {
  const auto lines = static_cast<std::int32_t>(patch.low.size());
  rows_of_band(patch.first_line, patch.first_line + lines - 1, band, grid, [&](std::int32_t row) {
    const auto i = static_cast<std::size_t>(row - patch.first_line);
    mark_row(row, patch.low[i], patch.high[i], patch.flags, grid);
  });
  for (const LineCells& more : patch.more) {
    if (band_of_row(static_cast<std::uint32_t>(more.line)) == band) {
      mark_row(more.line, more.low, more.high, patch.flags, grid);
    }
  }
}

}  // namespace

void mark_band(const SweptPatch& patch, std::uint32_t band, CoverageGrid& grid) {
  if (patch.by_columns) {
    mark_columns(patch, band, grid);
  } else {
    mark_rows(patch, band, grid);
  }
}

}  // namespace swathplan
