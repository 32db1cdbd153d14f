#include "planners/fitted/infill.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "planners/fitted/held_fans.h"
#include "planners/fitted/infill_passes_internal.h"
#include "planners/rows/route_stretches.h"

namespace swathplan {
namespace {

/// Rounding of cutting a pass at the outline, metres.
constexpr double kPassDust = 1e-6;

/// The stretches in sailing order. Finds the place between two of them where a pass costs least.
class Itinerary {
 public:
  Itinerary(std::vector<RouteStretch> stretches, const JoinCost& cost)
      : stretches_(std::move(stretches)), cost_(cost) {}

  struct Place {
    std::size_t before = 0;  ///< index of the line before which it goes; size(): at the end
    bool backwards = false;
    double cost = std::numeric_limits<double>::infinity();
  };

  [[nodiscard]] Place cheapest(const InfillPass& pass) const {
    // Straight ways are lower bounds of the ways through the water, so they are compared first.
    std::vector<Place> places;
    for (std::size_t k = 0; k <= stretches_.size(); ++k) {
      if (k < stretches_.size() && (stretches_[k].join || goes_on(k))) continue;
      for (const bool backwards : {false, true}) {
        places.push_back({k, backwards, detour(pass, k, backwards, false)});
      }
    }
    std::stable_sort(places.begin(), places.end(),
                     [](const Place& a, const Place& b) { return a.cost < b.cost; });
    Place best;
    constexpr std::size_t kLook = 8;
    for (std::size_t i = 0; i < std::min(kLook, places.size()); ++i) {
      if (places[i].cost >= best.cost) break;
      places[i].cost = detour(pass, places[i].before, places[i].backwards, true);
      if (places[i].cost < best.cost) best = places[i];
    }
    return best;
  }

  void insert(std::vector<Waypoint> points, std::size_t before) {
    if (before > 0 && before <= stretches_.size() && stretches_[before - 1].join) {
      stretches_[before - 1] = {std::move(points), false};
      return;
    }
    stretches_.insert(stretches_.begin() + static_cast<std::ptrdiff_t>(before),
                      {std::move(points), false});
  }

  /// Runs of stretches that keep the joins between them. Each run is added as one line.
  [[nodiscard]] std::vector<std::vector<Waypoint>> runs() const {
    std::vector<std::vector<Waypoint>> result;
    bool after_join = false;
    for (const RouteStretch& s : stretches_) {
      if (s.join || after_join) {
        if (s.join && !result.empty()) result.back().pop_back();
        if (result.empty()) result.emplace_back();
        result.back().insert(result.back().end(), s.points.begin(), s.points.end());
      } else if (!result.empty() && result.back().back().position == s.points.front().position) {
        // The next leg of one line.
        result.back().pop_back();
        result.back().insert(result.back().end(), s.points.begin(), s.points.end());
      } else {
        result.push_back(s.points);
      }
      after_join = s.join;
    }
    return result;
  }

 private:
  /// Whether stretch k is the next leg of the line before it.
  [[nodiscard]] bool goes_on(std::size_t k) const {
    return k > 0 && !stretches_[k].join && !stretches_[k - 1].join &&
           stretches_[k].points.front().position == stretches_[k - 1].points.back().position;
  }
  [[nodiscard]] double detour(const InfillPass& pass, std::size_t before, bool backwards,
                              bool through_water) const {
    const Vec2 from = backwards ? pass.to : pass.from;
    const Vec2 to = backwards ? pass.from : pass.to;
    const Vec2 course = (to - from).normalized();
    const auto way = [&](const Vec2& a, const Vec2& ca, const Vec2& b, const Vec2& cb) {
      const double metres = through_water ? cost_.way(a, b) : (b - a).norm();
      return metres + cost_.turning(a, ca, b, cb, metres);
    };
    double sum = 0.0;
    const bool join = before > 0 && stretches_[before - 1].join;
    const std::size_t last = join ? before - 1 : before;
    if (last > 0) {
      const LineEnds ends = ends_of(stretches_[last - 1].points);
      sum += way(ends.to, ends.course_to, from, course);
    }
    if (before < stretches_.size()) {
      const LineEnds ends = ends_of(stretches_[before].points);
      sum += way(to, course, ends.from, ends.course_from);
      if (last > 0) {
        const LineEnds previous = ends_of(stretches_[last - 1].points);
        sum -= join ? join_length(before)
                    : way(previous.to, previous.course_to, ends.from, ends.course_from);
      }
    }
    return sum;
  }

  [[nodiscard]] double join_length(std::size_t before) const {
    double length = 0.0;
    const auto& points = stretches_[before - 1].points;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      length += (points[i + 1].position - points[i].position).norm();
    }
    return length + (stretches_[before].points.front().position - points.back().position).norm();
  }

  std::vector<RouteStretch> stretches_;
  const JoinCost& cost_;
};

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
  Itinerary itinerary(stretches(route), shop.joins());
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
    return std::max(0.0, itinerary.cheapest(pass).cost) + length_of(pass) - length_of(found);
  };
  InfilledRoute result;
  double promised = 0.0;
  while (!result.enough && result.passes < static_cast<std::size_t>(options.most_passes) &&
         !shop.options().watch.ended()) {
    const auto found = empty.take_best(detour);
    if (!found) break;
    const InfillPass pass = lengthened(*found, least);
    const Itinerary::Place place = itinerary.cheapest(pass);
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
