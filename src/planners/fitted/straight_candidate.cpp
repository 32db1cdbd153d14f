#include <fmt/format.h>

#include "planners/fitted/straight_search_internal.h"
#include "planners/fronts/fitted_straight.h"
#include "planners/wording.h"

namespace swathplan {

std::vector<SurveyCurve> lines_of(const StraightCandidate& c, LineWorkshop& shop) {
  return fitted_straight_lines(shop.raster(), width_of(c, shop), shop.survey_area(),
                               shop.lines_in(),
                               {.azimuth = Angle::degrees(c.azimuth_deg),
                                .percentile = c.percentile,
                                .lines = c.lines,
                                .phase = c.phase,
                                .inset_m = c.inset_m,
                                .end_rows = c.end_rows});
}

const std::vector<float>& width_of(const StraightCandidate& c, LineWorkshop& shop) {
  return shop.width(c.gap);
}

LineAnglesOptions angles_of(const StraightCandidate& c) {
  return {.overlap_m = c.overlap_m, .widest_share = c.widest_share, .by_distance = c.by_distance};
}

BuiltRoute build(const StraightCandidate& c, LineWorkshop& shop) {
  return shop.build(lines_of(c, shop), width_of(c, shop), angles_of(c));
}

std::string describe(const StraightCandidate& c, Angle grid_north) {
  return fmt::format("{} at {}", counted(static_cast<std::size_t>(c.lines), "straight row"),
                     azimuth_text(c.azimuth_deg, grid_north.deg()));
}

}  // namespace swathplan
