#include "planners/line_spacing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mesh/base/error.h"
#include "mesh/plane/area_query.h"

namespace swathplan {
namespace {

/// Depths of a block are looked up on a lattice of about so many places, no finer than kFinest.
constexpr double kPlaces = 1e5;
constexpr double kFinest = 0.25;

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::string name_of(const BlockDepth& which) {
  if (which.mean) return "the mean depth";
  if (which.share <= 0.0) return "the shoalest water";
  return fmt::format("the depth that {:g} % of the block do not reach", 100.0 * which.share);
}

Angle half_fan(const PlanOptions& options, double below_m) {
  if (options.opening_angle) return *options.opening_angle / 2.0;
  const Angle widest =
      std::min(options.sonar.max_opening / 2.0, widest_half_angle(options.sonar, below_m));
  return options.angles == Angles::line ? Angle::degrees(std::floor(widest.deg() + 1e-6)) : widest;
}

}  // namespace

std::vector<double> block_depths(const Area& block, const DepthQuery& depths) {
  std::vector<double> found;
  if (block.empty()) return found;
  const Box2 box = extent(block);
  const double step = std::max(kFinest, std::sqrt(area_m2(block) / kPlaces));
  const AreaQuery inside(block);
  for (double y = box.min.y() + 0.5 * step; y < box.max.y(); y += step) {
    for (double x = box.min.x() + 0.5 * step; x < box.max.x(); x += step) {
      if (!inside.contains({x, y})) continue;
      if (const auto depth = depths.depth({x, y})) found.push_back(*depth);
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

double depth_of(const std::vector<double>& block, const BlockDepth& which) {
  if (block.empty()) return 0.0;
  if (which.mean) return mean_of(block);
  const double last = static_cast<double>(block.size() - 1);
  return block[static_cast<std::size_t>(std::lround(which.share * last))];
}

BlockLines lines_of_block(const std::vector<double>& depths, const PlanOptions& options) {
  const RowSpacing& rows = options.rows;
  BlockLines lines;
  lines.depth_m = std::max(0.0, depth_of(depths, rows.depth) - options.vehicle.draft_m);
  const Angle half = half_fan(options, lines.depth_m);
  lines.fan = {half, half};
  lines.swath_m = 2.0 * lines.depth_m * tan(half);
  if (lines.swath_m > 0.0) {
    lines.spacing_m = rows.spacing_m.value_or(lines.swath_m * (1.0 - rows.overlap));
  }
  return lines;
}

double wanted_swath_m(const BlockLines& lines, const PlanOptions& options) {
  const bool by_fan = options.rows.swath_by == SwathBy::fan;
  return by_fan ? lines.spacing_m / (1.0 - options.rows.overlap) : lines.spacing_m;
}

std::string spacing_note(const BlockLines& lines, const PlanOptions& options) {
  const RowSpacing& rows = options.rows;
  const std::string swath =
      fmt::format("the {:.4g} m that a fan of {:.4g} degrees sweeps {:.4g} m below the sonar, {}",
                  lines.swath_m, (lines.fan.port + lines.fan.starboard).deg(), lines.depth_m,
                  name_of(rows.depth));
  const std::string apart = fmt::format("lines lie {:.4g} m apart", lines.spacing_m);
  if (!rows.spacing_m) {
    return fmt::format("{}: an overlap of {:g} % of {}", apart, 100.0 * rows.overlap, swath);
  }
  if (lines.spacing_m <= lines.swath_m) {
    return fmt::format("{}, as asked: an overlap of {:.0f} % of {}", apart,
                       100.0 * (1.0 - lines.spacing_m / lines.swath_m), swath);
  }
  return fmt::format("{}, as asked, and leave gaps: that is more than {}", apart, swath);
}

std::optional<double> usual_lane_m(const Ground& ground, const PlanOptions& options) {
  const std::vector<double> depths = block_depths(ground.survey_area, *ground.depths);
  if (depths.empty()) return std::nullopt;
  PlanOptions how = options;
  how.rows = {.depth = {.mean = true}};
  const double swath = lines_of_block(depths, how).swath_m;
  if (!(swath > 0.0)) return std::nullopt;
  return std::min(swath, footprint_width_m(options));
}

void check_spacing(const RowSpacing& rows) {
  if (rows.swath_by == SwathBy::fan || !rows.spacing_m) return;
  throw UsageError(
      "<spacing> with <swath by> footprint; lines lie W = beams x resolution apart there: leave it "
      "out, or add <swath by> fan");
}

void check_rows(const Area& block, double spacing_m) {
  if (block.empty() || extent(block).size().norm() <= kMostRows * spacing_m) return;
  throw UsageError(fmt::format(
      "lines {:.3g} m apart would be more than {:g} over the area; give a larger <spacing> or a "
      "smaller <overlap>, or space them by deeper water with <spacing depth>",
      spacing_m, kMostRows));
}

}  // namespace swathplan
