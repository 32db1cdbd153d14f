#include "planners/fitted/infill.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "planners/fitted/held_fans.h"
#include "planners/fitted/infill_passes_internal.h"
#include "planners/fitted/itinerary.h"

namespace swathplan {
namespace {

/// Rounding of cutting a pass at the outline, metres.
constexpr double kPassDust = 1e-6;

double length_of(const InfillPass& pass) { return (pass.to - pass.from).norm(); }

/// The pass, as long at both ends as brings it to `least_m`.
InfillPass lengthened(InfillPass pass, double least_m) {
  const double length = length_of(pass);
  if (length >= least_m || !(length > 0.0)) return pass;
  const Vec2 end = 0.5 * (least_m - length) / length * (pass.to - pass.from);
  pass.from -= end;
  pass.to += end;
  return pass;
}

double median_width(const std::vector<float>& width) {
  std::vector<float> positive;
  std::copy_if(width.begin(), width.end(), std::back_inserter(positive),
               [](float w) { return w > 0.0F; });
  if (positive.empty()) return 0.0;
  const auto middle = positive.begin() + static_cast<std::ptrdiff_t>(positive.size() / 2);
  std::nth_element(positive.begin(), middle, positive.end());
  return static_cast<double>(*middle);
}

}  // namespace

InfilledRoute with_infill(const Route& route, const CoverageGrid& grid, LineWorkshop& shop,
                          const InfillOptions& options) {
  Itinerary itinerary(route, shop.joins());
  const std::vector<float>& width = shop.width(1.0);
  EmptyGround empty(grid, shop, options.least_gain * median_width(width), options.smallest_m2);
  // A pass is no use if the boat cannot turn onto it or away from it.
  const double least = shop.options().least_line_m;
  const auto detour = [&](const InfillPass& found) {
    const InfillPass pass = lengthened(found, least);
    if (least > 0.0 &&
        shop.lines_in().inside_length(pass.from, pass.to) < length_of(pass) - kPassDust)
      return std::numeric_limits<double>::infinity();
    if (!shop.connector().has_room({pass.from, pass.to}))
      return std::numeric_limits<double>::infinity();
    return std::max(0.0, itinerary.cheapest(pass.from, pass.to).cost) + length_of(pass) -
           length_of(found);
  };
  InfilledRoute result;
  double promised = 0.0;
  while (!result.enough && result.passes < static_cast<std::size_t>(options.most_passes) &&
         !shop.options().watch.ended()) {
    const auto found = empty.take_best(detour);
    if (!found) break;
    const InfillPass pass = lengthened(*found, least);
    const Itinerary::Place place = itinerary.cheapest(pass.from, pass.to);
    const SurveyCurve line =
        place.backwards ? straight_curve(pass.to, pass.from) : straight_curve(pass.from, pass.to);
    auto opened = opened_lines({line}, shop.raster(), width, shop.survey_area(), shop.options(),
                               {.overlap_m = 0.0, .widest_share = 0.5, .by_distance = false});
    if (shop.options().counted == Counted::logged) {
      hold_fans(opened, shop.raster(), shop.survey_area(), shop.options(), options.edge_share);
    }
    std::vector<Waypoint>& points = opened[0];
    for (Waypoint& point : points) {
      point.kind = LegKind::infill;
      point.line.reset();
    }
    itinerary.insert(std::move(points), place.before);
    ++result.passes;
    promised += found->gain_m2;
    result.enough = promised >= options.enough_m2;
  }
  if (result.passes == 0) {
    result.built.route = route;
    return result;
  }
  result.built = shop.join(itinerary.runs());
  return result;
}

InfilledRoute infilled(const Route& route, const Ground& ground, const PlanOptions& options,
                       double enough_pct, int rounds) {
  LineWorkshop shop(ground, options);
  InfilledRoute result;
  result.built.route = route;
  for (int round = 0; round < rounds && !options.watch.ended(); ++round) {
    const ScoredRoute scored = shop.score(result.built.route);
    if (shop.cover_pct(scored) >= enough_pct) break;
    InfilledRoute more = with_infill(result.built.route, scored.grid, shop);
    if (more.passes == 0) break;
    more.passes += result.passes;
    result = std::move(more);
    options.watch.tried(result.passes, 0,
                        fmt::format("{:.2f} % before the last of them", shop.cover_pct(scored)));
  }
  if (result.passes > 0) result.built = shop.with_smooth_joins(std::move(result.built));
  return result;
}

}  // namespace swathplan
