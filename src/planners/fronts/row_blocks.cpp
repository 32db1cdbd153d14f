#include "planners/fronts/row_blocks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace swathplan {
namespace {

/// Lines of one row lie no farther apart across than this, metres.
constexpr double kSameRow = 1e-3;
/// Lines are cut in steps of this share of a cell.
constexpr double kBlockStepOfCell = 0.5;

/// A line in the frame of its direction.
struct Piece {
  double across, from, to;
  std::size_t line;
};

struct Row {
  double across = 0.0;
  std::vector<Piece> pieces;
};

std::vector<Row> rows_of(const std::vector<SurveyCurve>& lines, const Vec2& u, const Vec2& v) {
  std::vector<Piece> pieces;
  pieces.reserve(lines.size());
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const double a = lines[k].points.front().dot(u);
    const double b = lines[k].points.back().dot(u);
    pieces.push_back({lines[k].points.front().dot(v), std::min(a, b), std::max(a, b), k});
  }
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const Piece& a, const Piece& b) { return a.across < b.across; });
  std::vector<Row> rows;
  for (const Piece& p : pieces) {
    if (rows.empty() || p.across > rows.back().across + kSameRow) rows.push_back({p.across, {}});
    rows.back().pieces.push_back(p);
  }
  return rows;
}

bool overlap(const Piece& a, const Piece& b) { return a.from < b.to && b.from < a.to; }

/// The only piece of a row that overlaps p; nullptr if none does, or several do.
const Piece* only_neighbour(const Piece& p, const Row& row) {
  const Piece* found = nullptr;
  for (const Piece& q : row.pieces) {
    if (!overlap(p, q)) continue;
    if (found != nullptr) return nullptr;
    found = &q;
  }
  return found;
}

/// Metres along from a place to a piece; 0 beside it.
double beyond(const Piece& p, double along) {
  return std::max({0.0, p.from - along, along - p.to});
}

}  // namespace

RowBlocks row_blocks(const std::vector<SurveyCurve>& lines, Angle azimuth,
                     const WaterRaster& raster) {
  const Vec2 u(sin(azimuth), cos(azimuth));
  const Vec2 v(cos(azimuth), -sin(azimuth));
  const std::vector<Row> rows = rows_of(lines, u, v);
  RowBlocks result;
  std::vector<std::int32_t> of_line(lines.size(), RowBlocks::kNone);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (const Piece& p : rows[r].pieces) {
      const Piece* before = r > 0 ? only_neighbour(p, rows[r - 1]) : nullptr;
      if (before != nullptr && only_neighbour(*before, rows[r]) != &p) before = nullptr;
      if (before == nullptr) result.lines.emplace_back();
      of_line[p.line] = before != nullptr ? of_line[before->line]
                                          : static_cast<std::int32_t>(result.lines.size() - 1);
      result.lines[static_cast<std::size_t>(of_line[p.line])].push_back(p.line);
    }
  }
  result.cells.assign(result.lines.size(), 0);
  result.of_cell.assign(raster.size(), RowBlocks::kNone);
  if (rows.empty()) return result;
  for (std::size_t i = 0; i < raster.size(); ++i) {
    if (!raster.in_area(i)) continue;
    const Vec2 at = raster.centre(i);
    const double across = at.dot(v);
    const auto after =
        std::lower_bound(rows.begin(), rows.end(), across,
                         [](const Row& row, double value) { return row.across < value; });
    auto row = after == rows.end() ? std::prev(after) : after;
    if (row != rows.begin() && across - std::prev(row)->across < row->across - across) --row;
    const auto nearest = std::min_element(row->pieces.begin(), row->pieces.end(),
                                          [&](const Piece& a, const Piece& b) {
                                            return beyond(a, at.dot(u)) < beyond(b, at.dot(u));
                                          });
    result.of_cell[i] = of_line[nearest->line];
    ++result.cells[static_cast<std::size_t>(result.of_cell[i])];
  }
  return result;
}

std::vector<SurveyCurve> cut_to_block(const std::vector<SurveyCurve>& lines,
                                      const RowBlocks& blocks, std::int32_t block,
                                      const WaterRaster& raster, double least_m) {
  std::vector<SurveyCurve> result;
  const auto mine = [&](const Vec2& p) {
    const auto cell = raster.cell_at(p);
    return !cell || blocks.of_cell[*cell] == block || blocks.of_cell[*cell] == RowBlocks::kNone;
  };
  for (const SurveyCurve& line : lines) {
    const Vec2 a = line.points.front();
    const Vec2 way = line.points.back() - a;
    const auto steps =
        static_cast<int>(std::ceil(way.norm() / (kBlockStepOfCell * raster.cell_m()))) + 1;
    int begin = -1;
    for (int k = 0; k <= steps + 1; ++k) {
      const bool in = k <= steps && mine(a + way * k / steps);
      if (in && begin < 0) begin = k;
      if (in || begin < 0) continue;
      if (way.norm() * (k - 1 - begin) / steps >= least_m) {
        result.push_back(straight_curve(a + way * begin / steps, a + way * (k - 1) / steps));
      }
      begin = -1;
    }
  }
  return result;
}

}  // namespace swathplan
