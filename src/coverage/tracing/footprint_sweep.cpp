#include <algorithm>
#include <cmath>
#include <limits>

#include "coverage/tracing/footprint.h"

namespace swathplan {

namespace {

// Cells by which rounding may misplace a footprint.
constexpr float kSweepDust = 2e-3F;

struct Between {
  float from_key, to_next;  // cells of path
};

struct SureSpans {
  const float *low, *high, *least;
  explicit SureSpans(const SureReach& r)
      : low(r.low.data()), high(r.high.data()), least(r.least.data()) {}
};

// How much of a beam's footprint the key pings before and behind surely cover. kHeld: all of it, or
// the beam has none. kNotHeld: nothing is sure. The others: all but a strip on one side, as is
// usual for the outermost beams.
enum Held : std::int32_t { kNotHeld = 0, kHeld = 1, kAllButPort = 2, kAllButStarboard = 3 };

SWATHPLAN_EVERY_CPU
void held_beams(std::size_t n, const Between& way, const float* left, const float* right,
                const float* half, const SureSpans& one, const SureSpans& two,
                float* __restrict low, float* __restrict high, std::int32_t* __restrict held) {
  const float from_key = way.from_key;
  const float to_next = way.to_next;
  const float whole = from_key + to_next + kSweepDust;
  const float *const low1 = one.low, *const high1 = one.high, *const least1 = one.least;
  const float *const low2 = two.low, *const high2 = two.high, *const least2 = two.least;
  // With both sides open two strips would be left. Such a beam counts as not held.
  constexpr std::int32_t kTwice = kAllButStarboard + kAllButPort - kHeld;
  for (std::size_t i = 0; i < n; ++i) {
    const float h = half[i] + kSweepDust;
    const float least_1 = least1[i], least_2 = least2[i];
    const float from = std::max(low1[i], low2[i]) + kSweepDust;
    const float to = std::min(high1[i], high2[i]) - kSweepDust;
    low[i] = from;
    high[i] = to;
    const bool deep =
        (h <= least_1 + from_key) & (h <= least_2 + to_next) & (whole <= least_1 + least_2);
    const auto port = static_cast<std::int32_t>(left[i] >= from);
    const auto starboard = static_cast<std::int32_t>(right[i] <= to);
    const std::int32_t code =
        port * kAllButStarboard + starboard * kAllButPort - (port & starboard) * kTwice;
    const std::int32_t known = static_cast<std::int32_t>(deep) * code;
    const auto none = static_cast<std::int32_t>(half[i] < 0.0F);
    held[i] = none * kHeld + (1 - none) * known;
  }
}

// Whether ping b continues the straight line of ping a and logs as a does; `way` is the path
// between them, in cells.
bool follows(const FanFootprints& a, const FanFootprints& b, float& way) {
  const CellFrame& f = a.frame;
  const CellFrame& g = b.frame;
  // Courses of one straight line differ in the last bit. At the end of a long fan that makes 0.001
  // cells.
  constexpr float kSameCourse = 1e-6F;
  if (std::abs(f.starboard_x - g.starboard_x) > kSameCourse ||
      std::abs(f.starboard_y - g.starboard_y) > kSameCourse || a.log != b.log ||
      a.beams() != b.beams()) {
    return false;
  }
  const float dx = static_cast<float>(g.column - f.column) + (g.x - f.x);
  const float dy = static_cast<float>(g.row - f.row) + (g.y - f.y);
  way = -dx * f.starboard_y + dy * f.starboard_x;
  const float aside = dx * f.starboard_x + dy * f.starboard_y;
  return std::abs(aside) < 0.5F * kSweepDust && way >= 0.0F;
}

}  // namespace

FootprintSweep::LineFrame::LineFrame(const CellFrame& f, bool by_columns) {
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

namespace {

// A patch keeps its axis while the course stays within about 54 degrees of it. Else a course near
// 45 degrees would change the axis again and again.
constexpr float kKeepAxis = 0.585F;

// out[i] = best of in[i - r .. i + r], in O(log r) passes. Both are padded with r on each side.
template <class Best>
void slide(const std::vector<float>& in, std::vector<float>& out, std::size_t r, Best best) {
  out = in;
  const std::size_t window = 2 * r + 1;
  std::size_t span = 1;
  for (; 2 * span <= window; span *= 2) {
    for (std::size_t i = 0; i + span < out.size(); ++i) out[i] = best(out[i], out[i + span]);
  }
  const std::size_t rest = window - span;
  // out[i] covers [i, i + span) now. This pass covers the whole window.
  for (std::size_t i = 0; i + rest < out.size(); ++i) out[i] = best(out[i], out[i + rest]);
}

}  // namespace

// Puts the pieces on whole cells across, with `reach` cells more on each side. Then takes the least
// and the most over windows of +-reach.
void FootprintSweep::profile(float reach) {
  const auto r = static_cast<std::int32_t>(std::ceil(reach));
  const std::int32_t low = floor_to_int(pieces_.left.front());
  const std::int32_t high = floor_to_int(pieces_.right.back());
  const auto bins = static_cast<std::size_t>(high - low) + 4 * static_cast<std::size_t>(r) + 5;
  least_.assign(bins, -FanFootprints::kNoFootprint);
  most_.assign(bins, 0.0F);
  constexpr auto kNoPiece = std::numeric_limits<std::uint32_t>::max();
  pieces_.first_in_bin.assign(bins, kNoPiece);
  const std::int32_t base = low - 2 * (r + 1);
  pieces_.first_bin = base;
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
      pieces_.first_in_bin[bin] =
          std::min(pieces_.first_in_bin[bin], static_cast<std::uint32_t>(p));
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
  float first_across;  // where the first line crosses the fan's plane: distance across
  float per_line;      // its growth from line to line
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

  const auto n = static_cast<std::size_t>(last - first) + 1;
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
  const auto offset = static_cast<std::size_t>(f.line + first - patch_.first_line);
  const auto known = [&](std::size_t i) {  // nothing new where the line has it all already
    return low_[i] > high_[i] || (f.cell + low_[i] >= patch_.low[offset + i] &&
                                  f.cell + high_[i] <= patch_.high[offset + i]);
  };
  for (std::size_t i = 0; i < n; ++i) {
    if (sure_low_[i] > sure_high_[i] || known(i)) continue;
    merge(f.line + first + static_cast<std::int32_t>(i), f.cell + sure_low_[i],
          f.cell + sure_high_[i]);
  }
  test_unsure();
  for (std::size_t i = 0; i < n; ++i) {
    if (known(i) || (low_[i] == sure_low_[i] && high_[i] == sure_high_[i])) continue;
    unsure_.lines.push_back(
        {first + static_cast<std::int32_t>(i), low_[i], high_[i], sure_low_[i], sure_high_[i]});
  }
  if (unsure_.lines.empty()) return;
  unsure_.frame = f;
  std::swap(unsure_.pieces, pieces_);
}

// Tests one by one the cells that the ping before may cover and that the next has not covered.
void FootprintSweep::test_unsure() {
  for (const UnsureLine& line : unsure_.lines) test_unsure_line(unsure_.frame, line);
  unsure_.lines.clear();
}

void FootprintSweep::test_unsure_line(const LineFrame& f, const UnsureLine& open) {
  const auto i = static_cast<std::size_t>(f.line + open.line - patch_.first_line);
  const std::int32_t had_low = patch_.low[i] - f.cell;
  const std::int32_t had_high = patch_.high[i] - f.cell;
  if (open.low >= had_low && open.high <= had_high) return;
  const float across = static_cast<float>(open.line) + 0.5F - f.a;
  const auto covered = [&](std::int32_t cell) {
    if (cell >= open.sure_low && cell <= open.sure_high) return true;
    if (cell >= had_low && cell <= had_high) return true;
    const float db = static_cast<float>(cell) + 0.5F - f.b;
    return unsure_.pieces.covers(across * f.along_a + db * f.along_b,
                                 across * f.starboard_a + db * f.starboard_b);
  };
  for (std::int32_t cell = open.low; cell <= open.high;) {
    if (!covered(cell)) {
      ++cell;
      continue;
    }
    const std::int32_t start = cell;
    while (cell <= open.high && covered(cell)) {
      cell =
          cell == open.sure_low && open.sure_low <= open.sure_high ? open.sure_high + 1 : cell + 1;
    }
    merge(f.line + open.line, f.cell + start, f.cell + cell - 1);
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
  constexpr std::int32_t kNone = 1 << 30;  // no cell; room left to take a position off it
  if (patch_.low.empty()) patch_.first_line = first;
  if (first < patch_.first_line) {
    const auto extra = static_cast<std::size_t>(patch_.first_line - first);
    patch_.low.insert(patch_.low.begin(), extra, kNone);
    patch_.high.insert(patch_.high.begin(), extra, -1);
    patch_.first_line = first;
  }
  const auto size = static_cast<std::size_t>(last - patch_.first_line) + 1;
  if (patch_.low.size() < size) {
    patch_.low.resize(size, kNone);
    patch_.high.resize(size, -1);
  }
}

// Opens a new patch where the one in hand cannot take this fan's footprints.
void FootprintSweep::open_patch(const FanFootprints& fan, std::vector<SweptPatch>& patches) {
  const std::uint32_t flags =
      CoverageGrid::kFootprint | (fan.log ? CoverageGrid::kLoggedFootprint : 0U);
  const float along_columns = std::abs(fan.frame.starboard_x);  // |course.y|
  const float along_rows = std::abs(fan.frame.starboard_y);
  const bool turned = (patch_.by_columns ? along_columns : along_rows) < kKeepAxis;
  if (open_ && (turned || patch_.flags != flags)) close_patch(patches);
  if (!open_) {
    patch_.by_columns = along_columns >= along_rows;
    patch_.flags = flags;
    open_ = true;
  }
}

void FootprintSweep::add_beams(const FanFootprints& fan, std::size_t first, std::size_t end,
                               std::vector<SweptPatch>& patches) {
  pieces_.assign(fan, first, end);
  if (pieces_.left.empty()) return;
  open_patch(fan, patches);
  add_lines(LineFrame(fan.frame, patch_.by_columns));
}

// Adds the cells of a beam's footprint between two distances across.
void FootprintSweep::add_strip(const FanFootprints& fan, std::size_t beam, float from, float to) {
  const LineFrame f(fan.frame, patch_.by_columns);
  const float left = fan.left[beam];
  const float right = fan.right[beam];
  const float half = fan.half_along[beam];
  const float spread = half * std::abs(f.along_a);
  const float low_a = std::min(from * f.starboard_a, to * f.starboard_a) - spread - kSweepDust;
  const float high_a = std::max(from * f.starboard_a, to * f.starboard_a) + spread + kSweepDust;
  const std::int32_t first = std::max(-f.line, -floor_to_int(-(low_a + f.a - 0.5F)));
  const std::int32_t last = std::min(f.lines - 1 - f.line, floor_to_int(high_a + f.a - 0.5F));
  const float per_b = 1.0F / f.along_b;
  // Along a line that runs with the course, all cells lie at the same distance across.
  const bool slanted = std::abs(f.starboard_b) > 1e-3F;
  const float per_across = slanted ? 1.0F / f.starboard_b : 0.0F;
  for (std::int32_t line = first; line <= last; ++line) {
    const float da = static_cast<float>(line) + 0.5F - f.a;
    const float middle = -da * f.along_a * per_b;
    float low = middle - half * std::abs(per_b);
    float high = middle + half * std::abs(per_b);
    if (slanted) {
      const float b1 = (from - da * f.starboard_a) * per_across;
      const float b2 = (to - da * f.starboard_a) * per_across;
      low = std::max(low, std::min(b1, b2));
      high = std::min(high, std::max(b1, b2));
    }
    const std::int32_t end = floor_to_int(high + kSweepDust + f.b - 0.5F);
    for (std::int32_t cell = -floor_to_int(-(low - kSweepDust + f.b - 0.5F)); cell <= end; ++cell) {
      const float db = static_cast<float>(cell) + 0.5F - f.b;
      const float along = da * f.along_a + db * f.along_b;
      const float across = da * f.starboard_a + db * f.starboard_b;
      if (across < left || across > right || std::abs(along) > half) continue;
      make_room(f.line + line, f.line + line);
      merge(f.line + line, f.cell + cell, f.cell + cell);
    }
  }
}

// Adds the beams of a ping that the key pings around it do not surely cover, run by run.
void FootprintSweep::add_rest(const FanFootprints& fan, std::vector<SweptPatch>& patches) {
  const std::size_t n = fan.beams();
  for (std::size_t i = 0; i < n; ++i) {
    if (held_[i] == kHeld) continue;
    if (held_[i] == kNotHeld) {
      const std::size_t first = i;
      while (i + 1 < n && held_[i + 1] == kNotHeld) ++i;
      add_beams(fan, first, i + 1, patches);
    } else {
      open_patch(fan, patches);
      const bool port = held_[i] == kAllButPort;
      add_strip(fan, i, port ? fan.left[i] : std::max(fan.left[i], high_sure_[i]),
                port ? std::min(fan.right[i], low_sure_[i]) : fan.right[i]);
    }
  }
}

// Makes the last waiting ping the next key ping.
void FootprintSweep::make_next_key(std::vector<SweptPatch>& patches) {
  if (waiting_count_ == 0) return;
  FanFootprints& next = waiting_[waiting_count_ - 1];
  next_reach_.build(next);
  for (auto* array : {&low_sure_, &high_sure_}) array->resize(next.beams());
  held_.resize(next.beams());
  add_beams(next, 0, next.beams(), patches);
  for (std::size_t k = 0; k + 1 < waiting_count_; ++k) {
    const FanFootprints& fan = waiting_[k];
    Between way{};
    follows(key_, fan, way.from_key);
    follows(fan, next, way.to_next);
    held_beams(fan.beams(), way, fan.left.data(), fan.right.data(), fan.half_along.data(),
               SureSpans(key_reach_), SureSpans(next_reach_), low_sure_.data(), high_sure_.data(),
               held_.data());
    add_rest(fan, patches);
  }
  std::swap(key_, next);
  std::swap(key_reach_, next_reach_);
  waiting_count_ = 0;
}

void FootprintSweep::add(const FanSoundings& soundings, const CellFrame& frame, bool log,
                         std::vector<SweptPatch>& patches) {
  // Key pings that lie so many half-lengths of a footprint apart still overlap well.
  constexpr float kKeyShare = 1.5F;
  FanFootprints& fan = waiting_[waiting_count_];
  fan.log = log;
  fan.build(soundings, widths_, frame);
  float way = 0.0F;
  if (has_key_ && follows(key_, fan, way)) {
    ++waiting_count_;
    const float step = way / static_cast<float>(waiting_count_);
    if (waiting_count_ > kMostBetween || way + step > kKeyShare * key_.shortest)
      make_next_key(patches);
    return;
  }
  if (waiting_count_ > 0) {
    FanFootprints first = std::move(fan);
    make_next_key(patches);
    waiting_[0] = std::move(first);
  }
  add_beams(waiting_[0], 0, waiting_[0].beams(), patches);
  std::swap(key_, waiting_[0]);
  key_reach_.build(key_);
  has_key_ = true;
}

void FootprintSweep::flush(std::vector<SweptPatch>& patches) {
  make_next_key(patches);
  close_patch(patches);
  has_key_ = false;
}

void FootprintSweep::close_patch(std::vector<SweptPatch>& patches) {
  test_unsure();
  if (open_ && !patch_.low.empty()) patches.push_back(std::move(patch_));
  patch_ = {};
  open_ = false;
}

}  // namespace swathplan
