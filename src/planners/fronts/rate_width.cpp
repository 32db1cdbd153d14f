#include "planners/fronts/rate_width.h"

#include <algorithm>
#include <cmath>

#include "coverage/standards/criterion_fan.h"
#include "coverage/standards/judge.h"

namespace swathplan {

namespace {

/// The question at one depth: the criterion's own cells and soundings, if there is one. Empty where
/// it accepts no sounding.
std::optional<RateQuestion> question_at(const PlanOptions& options, double stretch, double below) {
  const RateQuestion plain = rate_question(options, stretch);
  if (options.criterion == nullptr) return plain;
  std::optional<RateQuestion> asked =
      asked_by(*options.criterion, *options.uncertainty, plain, below, options.vehicle.draft_m);
  if (!asked) return asked;
  asked->cell_m *= stretch;
  asked->soundings *= stretch * stretch;
  if (asked->ping_spacing_m) *asked->ping_spacing_m *= stretch;
  return asked;
}

}  // namespace

RateQuestion rate_question(const PlanOptions& options, double stretch) {
  RateQuestion question;
  question.sonar = options.sonar;
  question.max_half_angle = options.sonar.max_opening / 2.0;
  question.cell_m = stretch * options.resolution_m;
  question.soundings = stretch * stretch * options.soundings;
  question.max_speed_mps = options.vehicle.speed_mps;
  question.least_speed_mps = options.least_speed_mps;
  question.sound_speed_mps = options.pings.sound_speed_mps;
  return question;
}

LeastHours hours_and_reach(const WaterRaster& raster, const PlanOptions& options) {
  const double cell_m2 = raster.cell_m() * raster.cell_m();
  std::vector<DepthArea> places;
  double depths = 0.0;
  for (std::size_t i = 0; i < raster.size(); ++i) {
    if (!raster.in_area(i)) continue;
    places.push_back({raster.depth(i) - options.vehicle.draft_m, cell_m2});
    depths += raster.depth(i);
  }
  if (options.criterion == nullptr) return least_hours(rate_question(options), places);
  const Criterion& criterion = *options.criterion;
  const bool spread = criterion.gap == GapRule::spread && !places.empty();
  const double between = spread ? depths_apart_m(depths / static_cast<double>(places.size())) : 0.0;
  LeastHours hours =
      least_hours([&](double below) { return question_at(options, 1.0, below); }, places, between);
  if (!spread) hours.hours *= lines_asked(criterion);
  return hours;
}

double least_hours(const WaterRaster& raster, const PlanOptions& options) {
  return hours_and_reach(raster, options).hours;
}

std::vector<float> rate_width_field(const WaterRaster& raster, const PlanOptions& options,
                                    double stretch, double overlap) {
  // Where each place must be seen by two lines, neighbours lie half as far apart.
  const double lines = options.criterion != nullptr ? lines_asked(*options.criterion) : 1.0;
  // The swath depends on the depth alone, so a table saves one search per cell.
  double deepest = 0.0;
  for (std::size_t i = 0; i < raster.size(); ++i) deepest = std::max(deepest, raster.depth(i));
  constexpr std::size_t kDepths = 512;
  std::vector<double> table(kDepths + 2, 0.0);
  const double step = std::max(deepest, 1e-3) / static_cast<double>(kDepths);
  for (std::size_t k = 0; k < table.size(); ++k) {
    const double depth = static_cast<double>(k) * step;
    const double below = std::max(depth - options.vehicle.draft_m, 1e-3);
    const auto question = question_at(options, stretch, below);
    const auto best = question ? best_area_rate(*question, below) : std::nullopt;
    table[k] = best ? 2.0 * below * tan(best->half_angle)
                    : gap_free_width_m(options, depth, stretch * options.resolution_m);
  }
  std::vector<float> widths(raster.size(), 0.0F);
  for (std::size_t i = 0; i < raster.size(); ++i) {
    if (!raster.in_area(i)) continue;
    const double at = raster.depth(i) / step;
    const auto k = static_cast<std::size_t>(at);
    const double share = at - static_cast<double>(k);
    widths[i] = static_cast<float>((1.0 - overlap) / lines *
                                   ((1.0 - share) * table[k] + share * table[k + 1]));
  }
  return widths;
}

}  // namespace swathplan
