#include "coverage/holidays.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <unordered_map>

#include "coverage/cell_outline.h"
#include "mesh/plane/union_find.h"

namespace swathplan {

namespace {

constexpr std::uint32_t kNoLabel = ~0U;

// Empty cells next to one another in one row: [first, end).
struct Run {
  std::uint32_t first, end;
  std::uint32_t label;
};

// What is known of a gap while it grows.
struct Gap {
  std::uint32_t label = kNoLabel;
  std::uint64_t first_cell = 0;  // row by row from the south-west
  std::uint64_t cells = 0, footprint_cells = 0;
  double sum_column = 0.0, sum_row = 0.0;
  std::uint32_t low_column = ~0U, high_column = 0, low_row = ~0U, high_row = 0;
  bool touches_outline = false, touches_covered = false;

  void join(const Gap& o) {
    first_cell = std::min(first_cell, o.first_cell);
    cells += o.cells;
    footprint_cells += o.footprint_cells;
    sum_column += o.sum_column;
    sum_row += o.sum_row;
    low_column = std::min(low_column, o.low_column);
    high_column = std::max(high_column, o.high_column);
    low_row = std::min(low_row, o.low_row);
    high_row = std::max(high_row, o.high_row);
    touches_outline = touches_outline || o.touches_outline;
    touches_covered = touches_covered || o.touches_covered;
  }
};

bool larger(const Gap& a, const Gap& b) {
  return std::tuple(b.cells, a.first_cell) < std::tuple(a.cells, b.first_cell);
}

class RowReader {
 public:
  RowReader(const CoverageGrid& grid, bool logged_only)
      : grid_(grid),
        logged_(logged_only),
        mask_(CoverageGrid::kInArea |
              (logged_only ? 7U << CoverageGrid::kLoggedShift : CoverageGrid::kCountMask)) {}

  void read(std::uint32_t row, std::vector<Run>& runs) const {
    runs.clear();
    const std::uint32_t* const words = grid_.words().data() + std::size_t{row} * grid_.columns();
    for (std::uint32_t c = 0; c < grid_.columns(); ++c) {
      if ((words[c] & mask_) != CoverageGrid::kInArea) continue;
      const std::uint32_t first = c;
      while (c < grid_.columns() && (words[c] & mask_) == CoverageGrid::kInArea) ++c;
      runs.push_back({first, c, kNoLabel});
    }
  }

  [[nodiscard]] Gap gap_of(std::uint32_t row, const Run& run) const {
    const std::size_t base = std::size_t{row} * grid_.columns();
    Gap gap;
    gap.first_cell = base + run.first;
    gap.cells = run.end - run.first;
    const auto n = static_cast<double>(gap.cells);
    gap.sum_column = 0.5 * n * (run.first + run.end - 1.0);
    gap.sum_row = n * row;
    gap.low_column = run.first;
    gap.high_column = run.end - 1;
    gap.low_row = gap.high_row = row;
    gap.touches_outline = outline(row, run);
    gap.touches_covered = beside_covered(row, run);
    for (std::uint32_t c = run.first; c < run.end; ++c) {
      gap.footprint_cells += logged_ ? grid_.logged_footprint(base + c) : grid_.footprint(base + c);
    }
    return gap;
  }

 private:
  [[nodiscard]] bool covered(std::size_t cell) const {
    return grid_.counts(cell) && (grid_.words()[cell] & mask_) != CoverageGrid::kInArea;
  }

  [[nodiscard]] bool beside_covered(std::uint32_t row, const Run& run) const {
    const std::size_t base = std::size_t{row} * grid_.columns();
    if (run.first > 0 && covered(base + run.first - 1)) return true;
    if (run.end < grid_.columns() && covered(base + run.end)) return true;
    for (std::uint32_t c = run.first; c < run.end; ++c) {
      if (row > 0 && covered(base + c - grid_.columns())) return true;
      if (row + 1 < grid_.rows() && covered(base + c + grid_.columns())) return true;
    }
    return false;
  }

  [[nodiscard]] bool outline(std::uint32_t row, const Run& run) const {
    if (row == 0 || row + 1 == grid_.rows() || run.first == 0 || run.end == grid_.columns()) {
      return true;
    }
    const std::size_t base = std::size_t{row} * grid_.columns();
    if (!grid_.counts(base + run.first - 1) || !grid_.counts(base + run.end)) return true;
    for (std::uint32_t c = run.first; c < run.end; ++c) {
      if (!grid_.counts(base + c - grid_.columns()) || !grid_.counts(base + c + grid_.columns())) {
        return true;
      }
    }
    return false;
  }

  const CoverageGrid& grid_;
  bool logged_;
  std::uint32_t mask_;  // in the area, and soundings
};

// Calls visit(run above, run) for all pairs that share a column. Both lists go from west to east.
template <class Visit>
void touching(const std::vector<Run>& above, std::vector<Run>& runs, Visit visit) {
  std::size_t a = 0;
  for (Run& run : runs) {
    while (a < above.size() && above[a].end <= run.first) ++a;
    for (std::size_t k = a; k < above.size() && above[k].first < run.end; ++k) {
      visit(above[k], run);
    }
  }
}

// First sweep: finds the gaps, row by row. A gap that the row does not reach is complete. So only
// growing gaps and listed ones are held in memory.
class GapSweep {
 public:
  GapSweep(const CoverageGrid& grid, const HolidayOptions& options)
      : grid_(grid), options_(options), reader_(grid, options.logged_only) {
    least_cells_ = options.smallest_m2 / (grid.resolution_m() * grid.resolution_m());
  }

  void run(Holidays& result) {
    std::vector<Run> above;
    std::vector<Run> runs;
    for (std::uint32_t row = 0; row < grid_.rows(); ++row) {
      reader_.read(row, runs);
      touching(above, runs, [&](const Run& up, Run& run) { join(up, run); });
      for (Run& run : runs) add(row, run);
      for (const Run& up : above) close_if_done(up, row, result);
      above.swap(runs);
    }
    for (const Run& up : above) close_if_done(up, grid_.rows(), result);
    prune();
    const double cell = grid_.resolution_m() * grid_.resolution_m();
    result.largest_m2 = static_cast<double>(largest_) * cell;
    result.total_m2 = static_cast<double>(cells_) * cell;
  }

  std::vector<Gap>& listed() { return listed_; }
  UnionFind& labels() { return labels_; }

 private:
  void join(const Run& up, Run& run) {
    const std::uint32_t root = labels_.find(up.label);
    if (run.label == kNoLabel) {
      run.label = root;
      return;
    }
    const std::uint32_t mine = labels_.find(run.label);
    if (mine == root) return;
    gaps_[slot_[mine]].join(gaps_[slot_[root]]);
    free_.push_back(slot_[root]);
    labels_.join_under(mine, root);
  }

  void add(std::uint32_t row, Run& run) {
    const Gap part = reader_.gap_of(row, run);
    if (run.label != kNoLabel) {
      gaps_[slot_[labels_.find(run.label)]].join(part);
      return;
    }
    run.label = labels_.add();
    if (free_.empty()) {
      free_.push_back(static_cast<std::uint32_t>(gaps_.size()));
      gaps_.emplace_back();
    }
    slot_.push_back(free_.back());
    free_.pop_back();
    gaps_[slot_.back()] = part;
  }

  void close_if_done(const Run& up, std::uint32_t row, Holidays& result) {
    const std::uint32_t root = labels_.find(up.label);
    if (slot_[root] == kNoLabel || gaps_[slot_[root]].high_row >= row) return;
    Gap& gap = gaps_[slot_[root]];
    gap.label = root;
    ++result.count;
    cells_ += gap.cells;
    largest_ = std::max(largest_, gap.cells);
    if (static_cast<double>(gap.cells) >= least_cells_) list(gap);
    free_.push_back(slot_[root]);
    slot_[root] = kNoLabel;
  }

  void list(const Gap& gap) {
    listed_.push_back(gap);
    if (listed_.size() <= 2 * options_.list_at_most + 1024) return;
    const auto kept = listed_.begin() + static_cast<std::ptrdiff_t>(options_.list_at_most);
    std::nth_element(listed_.begin(), kept, listed_.end(), larger);
    listed_.erase(kept, listed_.end());
  }

  void prune() {
    std::sort(listed_.begin(), listed_.end(), larger);
    if (listed_.size() > options_.list_at_most) listed_.resize(options_.list_at_most);
  }

  const CoverageGrid& grid_;
  const HolidayOptions& options_;
  RowReader reader_;
  double least_cells_ = 0.0;
  std::uint64_t cells_ = 0, largest_ = 0;
  UnionFind labels_;
  std::vector<std::uint32_t> slot_;  // of each label's gap while it is alive
  std::vector<std::uint32_t> free_;
  std::vector<Gap> gaps_;
  std::vector<Gap> listed_;
};

// Second sweep: finds for each listed gap the cell nearest its centroid, and its cells if outlines
// are wanted. Its labels are the same as in the first sweep, and their roots are final.
class PositionSweep {
 public:
  PositionSweep(const CoverageGrid& grid, const HolidayOptions& options, GapSweep& first)
      : grid_(grid), reader_(grid, options.logged_only), first_(first) {
    for (std::size_t i = 0; i < first.listed().size(); ++i) {
      index_[first.labels().find(first.listed()[i].label)] = i;
    }
    distance_.assign(first.listed().size(), 1e300);
    if (options.outline_corners > 0) cells_.resize(first.listed().size());
  }

  /// The cells of each listed gap; none if no outlines are wanted.
  [[nodiscard]] const std::vector<std::vector<RowRun>>& cells() const { return cells_; }

  void run(std::vector<Holiday>& holidays) {
    if (index_.empty()) return;
    std::vector<Run> above;
    std::vector<Run> runs;
    std::uint32_t next = 0;
    for (std::uint32_t row = 0; row < grid_.rows(); ++row) {
      reader_.read(row, runs);
      touching(above, runs, [](const Run& up, Run& run) { run.label = up.label; });
      for (Run& run : runs) {
        if (run.label == kNoLabel) run.label = next++;
        place(row, run, holidays);
      }
      above.swap(runs);
    }
  }

 private:
  void place(std::uint32_t row, const Run& run, std::vector<Holiday>& holidays) {
    const auto found = index_.find(first_.labels().find(run.label));
    if (found == index_.end()) return;
    if (!cells_.empty()) cells_[found->second].push_back({row, run.first, run.end});
    const Gap& gap = first_.listed()[found->second];
    const auto n = static_cast<double>(gap.cells);
    const double column =
        std::clamp(std::round(gap.sum_column / n), static_cast<double>(run.first), run.end - 1.0);
    const double distance = std::hypot(column - gap.sum_column / n, row - gap.sum_row / n);
    if (distance >= distance_[found->second]) return;
    distance_[found->second] = distance;
    holidays[found->second].position = grid_.centre(static_cast<std::uint32_t>(column), row);
  }

  const CoverageGrid& grid_;
  RowReader reader_;
  GapSweep& first_;
  std::unordered_map<std::uint32_t, std::size_t> index_;
  std::vector<double> distance_;
  std::vector<std::vector<RowRun>> cells_;
};

HolidayCause cause_of(const Gap& gap) {
  if (2 * gap.footprint_cells >= gap.cells) return HolidayCause::between_beams;
  if (!gap.touches_covered) return HolidayCause::no_line;
  return gap.touches_outline ? HolidayCause::edge : HolidayCause::between_lines;
}

Holiday holiday_of(const Gap& gap, const CoverageGrid& grid) {
  const double r = grid.resolution_m();
  Holiday holiday;
  holiday.cells = gap.cells;
  holiday.area_m2 = static_cast<double>(gap.cells) * r * r;
  holiday.box.extend(grid.origin() + r * Vec2(gap.low_column, gap.low_row));
  holiday.box.extend(grid.origin() + r * Vec2(gap.high_column + 1.0, gap.high_row + 1.0));
  holiday.cause = cause_of(gap);
  return holiday;
}

}  // namespace

std::string_view name(HolidayCause cause) {
  switch (cause) {
    case HolidayCause::between_beams:
      return "between_beams";
    case HolidayCause::no_line:
      return "no_line";
    case HolidayCause::edge:
      return "edge";
    case HolidayCause::between_lines:
      break;
  }
  return "between_lines";
}

Holidays find_holidays(const CoverageGrid& grid, const HolidayOptions& options) {
  Holidays result;
  GapSweep gaps(grid, options);
  gaps.run(result);
  for (const Gap& gap : gaps.listed()) result.list.push_back(holiday_of(gap, grid));
  PositionSweep positions(grid, options, gaps);
  positions.run(result.list);
  std::size_t corners = 0;
  for (std::size_t i = 0; i < positions.cells().size() && corners < options.outline_corners; ++i) {
    result.list[i].outline = cell_outline(positions.cells()[i], grid.origin(), grid.resolution_m());
    corners += corner_count(result.list[i].outline);
  }
  return result;
}

}  // namespace swathplan
