#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "coverage/coverage_grid.h"
#include "coverage/cpu_internal.h"
#include "coverage/fan_table_internal.h"

namespace swathplan {

/// Where a ping is and looks, in cells: the whole cells apart, so that floats are enough for the
/// rest.
struct CellFrame {
  std::int32_t column, row;  ///< of the boat
  float x, y;                ///< within that cell, [0, 1)
  float starboard_x, starboard_y;
  float cells_per_metre;
  std::int32_t columns, rows;  ///< of the grid
};

/// What the footprints of one ping hang on; arrays with one entry a beam.
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

/// The footprints of one ping in its own plane, left to right, in cells: piece p reaches from
/// left[p] to right[p] to starboard and half_along[p] ahead and astern. Pieces do not overlap.
struct FootprintPieces {
  std::vector<float> left, right, half_along;
  void build(const FanSoundings& fan, const BeamWidths& widths, float cells_per_metre);
  [[nodiscard]] bool covers(float along, float starboard) const;

 private:
  std::vector<float> cap_port_, cap_starboard_;
};

/// Cells of one line of the grid, from low to high.
struct LineCells {
  std::int32_t line, low, high;
};

/// What a block of pings swept: per line of the grid (a column or a row) one interval of cells, and
/// a few more intervals where the sweep has gaps.
struct SweptPatch {
  bool by_columns = true;
  std::int32_t first_line = 0;
  std::vector<std::int32_t> low, high;  ///< per line; low > high: none
  std::vector<LineCells> more;
  std::uint32_t flags = 0;  ///< to set in the cells
};

/// Gathers footprints ping by ping. Lines run along the axis nearer to the course, so that the
/// intervals of successive pings overlap and grow, and each cell is written about once.
class FootprintSweep {
 public:
  explicit FootprintSweep(const Sonar& sonar) : widths_(sonar) {}

  void add(const FanSoundings& fan, const CellFrame& frame, bool log,
           std::vector<SweptPatch>& patches);
  /// Ends the patch in hand. To be called after the last ping of a block.
  void flush(std::vector<SweptPatch>& patches);

 private:
  struct LineFrame;
  void profile(float reach);
  void add_lines(const LineFrame& f);
  void add_line_exactly(const LineFrame& f, std::int32_t line, float across, std::int32_t low,
                        std::int32_t high, std::int32_t sure_low, std::int32_t sure_high);
  void merge(std::int32_t line, std::int32_t low, std::int32_t high);
  void make_room(std::int32_t first, std::int32_t last);

  BeamWidths widths_;
  FootprintPieces pieces_;
  SweptPatch patch_;
  bool open_ = false;
  // The pieces resampled to whole cells across: least and largest half-length in each, and in the
  // window that a grid line crosses.
  std::int32_t first_bin_ = 0;
  std::vector<float> least_, most_, window_least_, window_most_;
  std::vector<std::int32_t> sure_low_, sure_high_, low_, high_;
};

/// Sets the flags of one band of rows.
void mark_band(const SweptPatch& patch, std::uint32_t band, CoverageGrid& grid);

}  // namespace swathplan
