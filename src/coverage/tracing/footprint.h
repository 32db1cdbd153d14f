#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "coverage/tracing/coverage_grid.h"
#include "coverage/tracing/cpu.h"
#include "coverage/tracing/fan_table.h"

namespace swathplan {

/// Where a ping is and which way it looks, in cells. Whole cells are kept apart as integers, so
/// that floats are exact enough for the rest.
struct CellFrame {
  std::int32_t column, row;  ///< of the boat
  float x, y;                ///< within that cell, [0, 1)
  float starboard_x, starboard_y;
  float cells_per_metre;
  std::int32_t columns, rows;  ///< of the grid
};

/// What the footprints of one ping are made from; arrays with one entry a beam.
struct FanSoundings {
  const FanTable* table;
  const float* range;      ///< > 0: a sounding
  const float* starboard;  ///< metres across
  const float *dx, *dy, *dz, *nx, *ny, *nz;
};

/// Beam widths that footprints are made of.
struct BeamWidths {
  explicit BeamWidths(const Sonar& sonar);
  float half_along;  ///< half the along-track width at range 1
  float half_across;
};

/// The footprints of one ping, in cells, one entry a beam. Across the course a footprint reaches
/// from `left` to `right`, counted from the boat, starboard positive. Along the course it reaches
/// half_along ahead and astern; kNoFootprint stands for a beam without one. Footprints do not
/// overlap, and they follow one another from port to starboard.
struct FanFootprints {
  static constexpr float kNoFootprint = -1e30F;
  CellFrame frame{};
  bool log = true;
  std::vector<float> at, left, right, half_along;
  float shortest = -kNoFootprint;  ///< least half_along of all footprints

  void build(const FanSoundings& fan, const BeamWidths& widths, const CellFrame& cells);
  [[nodiscard]] std::size_t beams() const { return at.size(); }

 private:
  void build_with_gaps(const FanSoundings& fan);
  std::vector<float> cap_port_, cap_starboard_;
};

/// What a ping surely covers around each of its beams. All over the span from low to high it
/// reaches at least `least` ahead and astern. `least` is kNoFootprint where a beam of the span has
/// no footprint or there is a gap.
struct SureReach {
  std::vector<float> low, high, least;
  void build(const FanFootprints& fan);

 private:
  std::vector<float> at_, cover_;
};

/// Footprints of some neighbouring beams, without those that have none.
struct FootprintPieces {
  std::vector<float> left, right, half_along;
  /// The first piece that reaches into each whole cell across; cells from `first_bin` on.
  std::vector<std::uint32_t> first_in_bin;
  std::int32_t first_bin = 0;
  void assign(const FanFootprints& fan, std::size_t first, std::size_t end);
  [[nodiscard]] bool covers(float along, float starboard) const;
};

/// Cells of one line of the grid, from low to high.
struct LineCells {
  std::int32_t line, low, high;
};

/// What a block of pings swept. Each line of the grid (a column or a row) has one interval of
/// cells; `more` holds further intervals where the sweep has gaps.
struct SweptPatch {
  bool by_columns = true;
  std::int32_t first_line = 0;
  std::vector<std::int32_t> low, high;  ///< per line; low > high: none
  std::vector<LineCells> more;
  std::uint32_t flags = 0;  ///< to set in the cells
};

/// Gathers footprints ping by ping. Pings stand much closer than footprints are long. So most
/// footprints of a ping lie within those of one ping before and one behind it. Some pings, the key
/// pings, are added whole. A ping between two key pings adds only the beams that these do not
/// surely cover.
/// Lines of the grid run along the axis nearer to the course. So the intervals of successive pings
/// overlap, and each cell is written about once.
class FootprintSweep {
 public:
  explicit FootprintSweep(const Sonar& sonar) : widths_(sonar) {}

  void add(const FanSoundings& fan, const CellFrame& frame, bool log,
           std::vector<SweptPatch>& patches);
  /// Hands out what is still held back. Must be called after the last ping of a block.
  void flush(std::vector<SweptPatch>& patches);

 private:
  /// A ping seen along lines of the grid: `a` counts lines, `b` cells along a line.
  struct LineFrame {
    std::int32_t line = 0, cell = 0;  ///< of the boat
    float a = 0, b = 0;               ///< within its cell
    float along_a = 0, along_b = 0, starboard_a = 0, starboard_b = 0;
    std::int32_t lines = 0, cells = 0;

    LineFrame() = default;
    LineFrame(const CellFrame& f, bool by_columns);
  };
  /// Cells of a line, counted from the boat, that may be covered, and those that surely are.
  struct UnsureLine {
    std::int32_t line, low, high, sure_low, sure_high;
  };
  /// The cells that one ping may or may not cover. They are tested after the next ping, which
  /// covers nearly all of them.
  struct Unsure {
    LineFrame frame;
    FootprintPieces pieces;
    std::vector<UnsureLine> lines;
  };
  static constexpr std::size_t kMostBetween = 16;

  void make_next_key(std::vector<SweptPatch>& patches);
  void open_patch(const FanFootprints& fan, std::vector<SweptPatch>& patches);
  void add_rest(const FanFootprints& fan, std::vector<SweptPatch>& patches);
  void add_strip(const FanFootprints& fan, std::size_t beam, float from, float to);
  void add_beams(const FanFootprints& fan, std::size_t first, std::size_t end,
                 std::vector<SweptPatch>& patches);
  void close_patch(std::vector<SweptPatch>& patches);
  void profile(float reach);
  void add_lines(const LineFrame& f);
  void test_unsure();
  void test_unsure_line(const LineFrame& f, const UnsureLine& open);
  void merge(std::int32_t line, std::int32_t low, std::int32_t high);
  void make_room(std::int32_t first, std::int32_t last);

  BeamWidths widths_;
  FanFootprints key_;
  SureReach key_reach_, next_reach_;
  bool has_key_ = false;
  std::vector<FanFootprints> waiting_ = std::vector<FanFootprints>(kMostBetween + 1);
  std::size_t waiting_count_ = 0;
  std::vector<std::int32_t> held_;           // of the beams of a ping between key pings
  std::vector<float> low_sure_, high_sure_;  // span that the key pings surely hold around each
  FootprintPieces pieces_;
  Unsure unsure_;
  SweptPatch patch_;
  bool open_ = false;
  // The pieces on whole cells across: their least and largest half-length in each cell, and in the
  // window of cells that a grid line crosses.
  std::int32_t first_bin_ = 0;
  std::vector<float> least_, most_, window_least_, window_most_;
  std::vector<std::int32_t> sure_low_, sure_high_, low_, high_;
};

/// Sets the flags in one of the bands of rows.
void mark_band(const SweptPatch& patch, Bands bands, std::uint32_t band, CoverageGrid& grid);

}  // namespace swathplan
