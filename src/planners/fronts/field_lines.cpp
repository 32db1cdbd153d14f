#include "planners/fronts/field_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "mesh/plane/segments.h"
#include "planners/fronts/level_lines.h"

namespace swathplan {
namespace {

std::vector<FrontCell> front_of(const WaterRaster& raster, const std::vector<float>& width,
                                const FieldWall& wall, double tolerance_m) {
  std::vector<FrontCell> cells;
  const double reach = tolerance_m + 1.5 * raster.cell_m();
  for (std::size_t i = 0; i < raster.size(); ++i) {
    if (!raster.in_area(i)) continue;
    const bool rim = !raster.in_area(i - 1) || !raster.in_area(i + 1) ||
                     !raster.in_area(i - raster.columns()) || !raster.in_area(i + raster.columns());
    if (!rim || distance_to_segment(wall.from, wall.to, raster.centre(i)) > reach) continue;
    // The outline lies half a cell before the centres.
    cells.push_back({i, 0.5 * raster.cell_m() / static_cast<double>(width[i]), 0});
  }
  return cells;
}

}  // namespace

std::vector<FieldWall> long_walls(const Area& area, double tolerance_m, std::size_t at_most) {
  std::vector<FieldWall> walls;
  for (const Polygon& polygon : simplify(area, tolerance_m)) {
    for (std::size_t i = 0, j = polygon.outer.size() - 1; i < polygon.outer.size(); j = i++) {
      walls.push_back({polygon.outer[j], polygon.outer[i]});
    }
  }
  std::stable_sort(walls.begin(), walls.end(), [](const FieldWall& a, const FieldWall& b) {
    return (a.to - a.from).norm() > (b.to - b.from).norm();
  });
  if (walls.size() > at_most) walls.resize(at_most);
  return walls;
}

std::vector<FrontCell> front_along(const WaterRaster& raster, const std::vector<float>& width,
                                   const std::vector<SurveyCurve>& curves) {
  // Cells this near to a curve get their true distance. The front takes the others from these.
  constexpr double kReachOfCell = 1.5;
  constexpr double kStepOfCell = 0.1;
  std::vector<FrontCell> cells;
  std::unordered_map<std::size_t, std::size_t> known;
  const double reach = kReachOfCell * raster.cell_m();
  for (const SurveyCurve& curve : curves) {
    for (const Vec2& p : resampled(curve, kStepOfCell * raster.cell_m()).points) {
      for (double dy = -1.0; dy <= 1.0; dy += 1.0) {
        for (double dx = -1.0; dx <= 1.0; dx += 1.0) {
          const auto i = raster.cell_at(p + raster.cell_m() * Vec2(dx, dy));
          if (!i || !raster.in_area(*i) || !(width[*i] > 0.0F)) continue;
          const double metres = (raster.centre(*i) - p).norm();
          if (metres > reach) continue;
          const double value = metres / static_cast<double>(width[*i]);
          const auto [it, fresh] = known.try_emplace(*i, cells.size());
          if (fresh) cells.push_back({*i, value, 0});
          cells[it->second].value = std::min(cells[it->second].value, value);
        }
      }
    }
  }
  return cells;
}

std::vector<SurveyCurve> front_lines(const WaterRaster& raster, const Front& front, double first,
                                     double spacing, double step_m, int smooth_passes) {
  double farthest = 0.0;
  for (const float u : front.u) {
    if (std::isfinite(u)) farthest = std::max(farthest, static_cast<double>(u));
  }
  std::vector<SurveyCurve> lines;
  for (int k = 0; first + k * spacing < farthest; ++k) {
    for (const SurveyCurve& chain : level_lines(raster, front.u, first + k * spacing)) {
      lines.push_back(smoothed(resampled(chain, step_m), smooth_passes));
    }
  }
  return lines;
}

std::vector<SurveyCurve> pieces_of(const std::vector<SurveyCurve>& curves,
                                   const WaterRaster& raster, const std::vector<float>& width,
                                   const AreaQuery& lines_in) {
  std::vector<SurveyCurve> lines;
  for (const SurveyCurve& smooth : curves) {
    for (SurveyCurve& piece : cut_to(splined(smooth, kFieldParts), lines_in)) {
      if (piece.points.size() < 3) continue;
      const auto at = raster.cell_at(piece.points[piece.points.size() / 2]);
      const double swath = at ? static_cast<double>(width[*at]) : 0.0;
      if (length_m(piece) >= kShortestField * swath) lines.push_back(std::move(piece));
    }
  }
  return lines;
}

std::vector<SurveyCurve> field_lines(const WaterRaster& raster, const std::vector<float>& width,
                                     const AreaQuery& lines_in, const FieldWall& wall,
                                     double tolerance_m, const FieldLinesOptions& options) {
  const Front front = march(raster, width, front_of(raster, width, wall, tolerance_m));
  return pieces_of(front_lines(raster, front, 0.5 * options.spacing, options.spacing,
                               options.step_m, options.smooth_passes),
                   raster, width, lines_in);
}

double least_line_m(const WaterRaster& raster, const std::vector<float>& width) {
  double sum = 0.0;
  for (std::size_t i = 0; i < raster.size(); ++i) {
    if (raster.in_area(i)) sum += 1.0 / static_cast<double>(width[i]);
  }
  return sum * raster.cell_m() * raster.cell_m();
}

}  // namespace swathplan
