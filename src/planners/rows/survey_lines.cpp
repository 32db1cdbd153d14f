#include "planners/rows/survey_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace swathplan {
namespace {

/// Pieces shorter than this share of the spacing are left out. They lie at corners.
constexpr double kShortestPieceShare = 0.2;
/// Azimuths are tried in these steps, besides the outline's own sides.
constexpr double kStepDeg = 5.0;

Vec2 along(Angle azimuth) { return {sin(azimuth), cos(azimuth)}; }
Vec2 across(Angle azimuth) { return {cos(azimuth), -sin(azimuth)}; }

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

Range range_along(const Area& area, const Vec2& direction) {
  Range range;
  for (const Polygon& polygon : area) {
    for (const Vec2& p : polygon.outer) {
      range.low = std::min(range.low, p.dot(direction));
      range.high = std::max(range.high, p.dot(direction));
    }
  }
  return range;
}

double rows_across(double width, const ParallelLinesOptions& options) {
  constexpr double kDust = 1e-6;  // a row for the width of a rounding error is one too many
  if (!(options.swath_m > 0.0)) return std::round(width / options.spacing_m);
  return 1.0 + std::ceil((width - options.swath_m) / options.spacing_m - kDust);
}

}  // namespace

std::vector<SurveyLine> parallel_lines(const Area& area, const ParallelLinesOptions& options) {
  std::vector<SurveyLine> lines;
  if (area.empty()) return lines;
  const Vec2 u = along(options.azimuth);
  const Vec2 v = across(options.azimuth);
  const Range rows = range_along(area, v);
  const Range reach = range_along(area, u);
  const double width = rows.high - rows.low;
  const auto count = static_cast<int>(std::max(1.0, rows_across(width, options)));
  const double first = rows.low + 0.5 * (width - options.spacing_m * (count - 1)) + options.shift_m;
  for (int row = 0; row < count; ++row) {
    const double offset = first + options.spacing_m * row;
    const Vec2 a = v * offset + u * (reach.low - 1.0);
    const Vec2 b = v * offset + u * (reach.high + 1.0);
    const double length = (b - a).norm();
    auto pieces = clip_segment(area, a, b);
    double longest = 0.0;
    for (const auto& [t0, t1] : pieces) longest = std::max(longest, (t1 - t0) * length);
    for (const auto& [t0, t1] : pieces) {
      const double piece = (t1 - t0) * length;
      if (piece < kShortestPieceShare * options.spacing_m && piece < longest) continue;
      const double inset = std::min(options.inset_m, 0.45 * piece);
      lines.push_back({a + u * (t0 * length + inset), a + u * (t1 * length - inset), row});
    }
  }
  return lines;
}

std::vector<SurveyLine> no_shorter_than(double least_m, std::vector<SurveyLine> lines) {
  const auto is_short = [&](const SurveyLine& line) {
    return (line.to - line.from).norm() < least_m;
  };
  if (std::all_of(lines.begin(), lines.end(), is_short)) return lines;
  std::erase_if(lines, is_short);
  return lines;
}

Angle best_azimuth(const Area& area, double spacing_m) {
  std::vector<double> candidates;
  for (double deg = 0.0; deg < 180.0; deg += kStepDeg) candidates.push_back(deg);
  // Ring by ring: a region of a chart has thousands of them, and only their edges are asked for.
  for (const Polygon& whole : area) {
    for (const Polygon& polygon : simplify({{whole.outer, {}}}, 0.1 * spacing_m)) {
      for (std::size_t i = 0, j = polygon.outer.size() - 1; i < polygon.outer.size(); j = i++) {
        const Vec2 d = polygon.outer[i] - polygon.outer[j];
        if (d.norm() < spacing_m) continue;
        const double deg = Angle::radians(std::atan2(d.x(), d.y())).deg();
        candidates.push_back(std::fmod(deg + 360.0, 180.0));
      }
    }
  }
  double best_width = std::numeric_limits<double>::infinity();
  Angle best;
  for (const double deg : candidates) {
    const Angle azimuth = Angle::degrees(deg);
    const Range range = range_along(area, across(azimuth));
    const double width = range.high - range.low;
    // Where the area is narrowest, it needs the fewest lines. A direction must win by more than
    // rounding.
    if (width < best_width * (1.0 - 1e-9)) {
      best_width = width;
      best = azimuth;
    }
  }
  return best;
}

namespace {

/// Lines of consecutive rows, one a row.
using Block = std::vector<SurveyLine>;

bool overlap(const SurveyLine& a, const SurveyLine& b, const Vec2& u) {
  return std::min(a.to.dot(u), b.to.dot(u)) > std::max(a.from.dot(u), b.from.dot(u));
}

std::vector<Block> blocks_of(const std::vector<SurveyLine>& lines) {
  std::vector<Block> blocks;
  if (lines.empty()) return blocks;
  const Vec2 u = (lines[0].to - lines[0].from).normalized();
  std::vector<std::size_t> block_of(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto partners = [&](std::size_t of, int row) {
      std::vector<std::size_t> found;
      for (std::size_t j = 0; j < lines.size(); ++j) {
        if (lines[j].row == row && overlap(lines[of], lines[j], u)) found.push_back(j);
      }
      return found;
    };
    const auto below = partners(i, lines[i].row - 1);
    if (below.size() == 1 && partners(below[0], lines[i].row).size() == 1) {
      block_of[i] = block_of[below[0]];
      blocks[block_of[i]].push_back(lines[i]);
    } else {
      block_of[i] = blocks.size();
      blocks.push_back({lines[i]});
    }
  }
  return blocks;
}

SurveyLine reversed(const SurveyLine& line) { return {line.to, line.from, line.row}; }

}  // namespace

std::vector<SurveyLine> to_and_fro(const std::vector<SurveyLine>& lines,
                                   const std::optional<Vec2>& start) {
  std::vector<Block> left = blocks_of(lines);
  std::vector<SurveyLine> result;
  bool anywhere = !start.has_value();
  Vec2 at = start.value_or(Vec2::Zero());
  while (!left.empty()) {
    std::size_t pick = 0;
    bool from_last = false;
    bool backwards = false;
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t b = 0; !anywhere && b < left.size(); ++b) {
      for (const bool last : {false, true}) {
        const SurveyLine& entry = last ? left[b].back() : left[b].front();
        for (const bool back : {false, true}) {
          const double distance = ((back ? entry.to : entry.from) - at).norm();
          if (distance < best) {
            best = distance;
            pick = b;
            from_last = last;
            backwards = back;
          }
        }
      }
    }
    Block block = left[pick];
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(pick));
    if (from_last) std::reverse(block.begin(), block.end());
    for (const SurveyLine& line : block) {
      result.push_back(backwards ? reversed(line) : line);
      backwards = !backwards;
    }
    at = result.back().to;
    anywhere = false;
  }
  return result;
}

}  // namespace swathplan
