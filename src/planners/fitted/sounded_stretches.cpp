#include "planners/fitted/sounded_stretches.h"

#include <algorithm>
#include <limits>

#include "planners/rows/route_stretches.h"

namespace swathplan {
namespace {

/// A piece is so long: this share of a usual swath, and no less than so many cells.
constexpr double kPieceOfSwath = 0.06, kPieceOfCell = 2.0;

double usual_swath_m(LineWorkshop& shop) {
  std::vector<float> some;
  for (const float w : shop.width(1.0)) {
    if (w > 0.0F) some.push_back(w);
  }
  if (some.empty()) return 0.0;
  const auto middle = some.begin() + static_cast<std::ptrdiff_t>(some.size() / 2);
  std::nth_element(some.begin(), middle, some.end());
  return static_cast<double>(*middle);
}

/// The route's lines and the joins before them, not yet in pieces.
std::vector<SoundedLine> lines_of(const Route& route) {
  std::vector<SoundedLine> lines;
  std::vector<Waypoint> join;
  bool new_line = true;
  for (RouteStretch& s : stretches(route)) {
    if (s.join) {
      if (lines.empty()) return {};
      join = std::move(s.points);
      new_line = true;
      continue;
    }
    if (new_line) {
      lines.push_back({std::move(s.points), {}, std::move(join)});
      join.clear();
      new_line = false;
      continue;
    }
    // The next leg of the same line.
    auto& points = lines.back().points;
    points.pop_back();
    points.insert(points.end(), s.points.begin(), s.points.end());
  }
  if (new_line) return {};
  return lines;
}

void cut_into_pieces(SoundedLine& line, double piece_m) {
  SoundedPiece piece;
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
    const double metres = (line.points[i + 1].position - line.points[i].position).norm();
    piece.metres += metres;
    piece.seconds += metres / line.points[i].speed_mps;
    piece.end = i + 1;
    if (piece.metres < piece_m && i + 2 < line.points.size()) continue;
    line.pieces.push_back(piece);
    piece = {};
    piece.begin = i + 1;
  }
}

/// Gathers soundings of pieces that come one after another.
class Gatherer {
 public:
  explicit Gatherer(std::size_t cells) : place_(cells, 0), owner_(cells, kNone) {}
  void add(std::uint32_t number, std::span<const std::uint32_t> cells, SoundedPiece& piece,
           const CoverageGrid& grid) {
    for (const std::uint32_t cell : cells) {
      if (!grid.counts(cell)) continue;
      if (owner_[cell] == number) {
        ++piece.cells[place_[cell]].second;
        continue;
      }
      owner_[cell] = number;
      place_[cell] = static_cast<std::uint32_t>(piece.cells.size());
      piece.cells.emplace_back(cell, 1U);
    }
  }

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> place_, owner_;
};

}  // namespace

SoundedLines sounded_stretches(const Route& route, LineWorkshop& shop) {
  SoundedLines result{lines_of(route), 0, shop.empty_score()};
  const PlanOptions& options = shop.options();
  const double piece_m =
      std::max(kPieceOfSwath * usual_swath_m(shop), kPieceOfCell * options.resolution_m);
  // The route again, with a number of its own for each piece.
  Route numbered;
  std::vector<std::pair<std::size_t, std::size_t>> pieces;  // line, piece
  int number = 0;
  for (std::size_t k = 0; k < result.lines.size(); ++k) {
    SoundedLine& line = result.lines[k];
    cut_into_pieces(line, piece_m);
    auto& w = numbered.waypoints;
    for (Waypoint point : line.join) {
      point.line.reset();
      w.push_back(point);
    }
    for (std::size_t p = 0; p < line.pieces.size(); ++p) {
      ++number;
      pieces.emplace_back(k, p);
      for (std::size_t i = line.pieces[p].begin; i < line.pieces[p].end; ++i) {
        w.push_back(line.points[i]);
        w.back().line = number;
      }
    }
    if (k + 1 == result.lines.size()) {
      w.push_back(line.points.back());
      w.back().kind = LegKind::end;
      w.back().log = false;
      w.back().line.reset();
    }
  }
  if (result.lines.empty()) return result;
  std::vector<std::uint32_t> number_of_leg;
  for (const Leg& leg : legs(numbered)) {
    const std::optional<int> line = numbered.waypoints[leg.first].line;
    number_of_leg.push_back(line ? static_cast<std::uint32_t>(*line) : 0U);
  }
  // The empty grid says which cells count.
  const CoverageGrid& grid = result.scored.grid;
  Gatherer gatherer(grid.words().size());
  ScoredRoute scored =
      shop.score(numbered, [&](std::uint32_t leg, std::span<const std::uint32_t> cells) {
        const std::uint32_t n = number_of_leg[leg];
        if (n == 0) return;
        const auto& [k, p] = pieces[n - 1];
        gatherer.add(n, cells, result.lines[k].pieces[p], grid);
      });
  result.scored = std::move(scored);
  result.counting = result.scored.score.cells;
  return result;
}

}  // namespace swathplan
