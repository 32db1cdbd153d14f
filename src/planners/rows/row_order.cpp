#include "planners/rows/row_order.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace swathplan {
namespace {

/// Routes that differ by less are equally good, metres.
constexpr double kSame = 1e-6;
/// Ends of lines nearer than this are the same end, metres. It finds the ends of an infeasible join
/// again, since such a join cuts nothing off its lines.
constexpr double kSamePlace = 1e-3;
/// Number of orders of least way that are built.
constexpr int kMostOrders = 4;

struct Price {
  double infeasible_m = 0.0;
  double way_m = 0.0;  ///< less the worth of lines
};

Price price(const Route& route) {
  Price price;
  const auto& w = route.waypoints;
  for (std::size_t i = 0; i + 1 < w.size(); ++i) {
    const double metres = (w[i + 1].position - w[i].position).norm();
    if (!w[i].feasible) price.infeasible_m += metres;
    price.way_m += w[i].log ? metres - kLineWorth * metres : metres;
  }
  return price;
}

bool better(const Route& a, const Route& b) {
  const Price x = price(a), y = price(b);
  if (std::abs(x.infeasible_m - y.infeasible_m) > kSame) return x.infeasible_m < y.infeasible_m;
  return x.way_m < y.way_m - kSame;
}

/// From the end of the line before to the beginning of the line after.
std::vector<std::pair<Vec2, Vec2>> infeasible_joins(const Route& route) {
  std::vector<std::pair<Vec2, Vec2>> joins;
  for (const Leg& leg : legs(route)) {
    const Waypoint& first = route.waypoints[leg.first];
    if (first.feasible || first.log) continue;
    joins.emplace_back(first.position, route.waypoints[leg.last].position);
  }
  return joins;
}

bool among(const std::vector<std::pair<Vec2, Vec2>>& joins, const Vec2& a, const Vec2& b) {
  return std::any_of(joins.begin(), joins.end(), [&](const auto& join) {
    const auto& [from, to] = join;
    const double there = std::max((from - a).norm(), (to - b).norm());
    const double back = std::max((from - b).norm(), (to - a).norm());
    return std::min(there, back) < kSamePlace;
  });
}

}  // namespace

bool rows_need_skips(const PlanOptions& options) {
  return 2.0 * options.vehicle.turn_radius_m > lane_m(options);
}

std::vector<SurveyLine> ordered(const std::vector<SurveyLine>& lines, const RowOrder& order,
                                const JoinCost& cost, double turn_radius_m,
                                const std::optional<Vec2>& start) {
  auto given = to_and_fro(lines, start);
  if (order.to_and_fro) return given;
  std::vector<LineEnds> ends;
  ends.reserve(given.size());
  for (const SurveyLine& line : given) {
    const Vec2 course = (line.to - line.from).normalized();
    ends.push_back({line.from, line.to, course, course});
  }
  // For bulbs between near rows JoinCost gives too few metres.
  const auto metres = [&](const Vec2& a, const Vec2& ca, const Vec2& b, const Vec2& cb) {
    const double way = cost.way(a, b);
    const double bulb = dubins_length_m({a, ca}, {b, cb}, turn_radius_m) - (b - a).norm();
    if (among(order.avoided, a, b)) return way + JoinCost::kNoWay;
    return way + std::max(bulb, cost.turning(a, ca, b, cb, way));
  };
  std::vector<SurveyLine> result;
  result.reserve(given.size());
  for (const OrderedLine& next : line_order(ends, LineCost(metres), start)) {
    SurveyLine line = given[next.line];
    if (next.backwards) std::swap(line.from, line.to);
    result.push_back(line);
  }
  return result;
}

BuiltRoute shorter_order(const PlanOptions& options,
                         const std::function<BuiltRoute(const RowOrder&)>& build) {
  BuiltRoute best = build({});
  if (!rows_need_skips(options)) return best;
  bool skips = false;
  RowOrder order{false, infeasible_joins(best.route)};
  for (int k = 0; k < kMostOrders; ++k) {
    BuiltRoute next = build(order);
    const auto failed = infeasible_joins(next.route);
    order.avoided.insert(order.avoided.end(), failed.begin(), failed.end());
    if (better(next.route, best.route)) {
      best = std::move(next);
      skips = true;
    }
    if (failed.empty()) break;
  }
  if (!skips) return best;
  best.notes.push_back(
      fmt::format("rows are sailed in the order of the least way, not to and fro: twice the turn "
                  "radius of {:g} m is more than the {:g} m between them",
                  options.vehicle.turn_radius_m, lane_m(options)));
  return best;
}

}  // namespace swathplan
