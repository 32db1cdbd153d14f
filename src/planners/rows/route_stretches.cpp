#include "planners/rows/route_stretches.h"

namespace swathplan {

std::vector<RouteStretch> stretches(const Route& route) {
  std::vector<RouteStretch> result;
  const auto& w = route.waypoints;
  for (const Leg& leg : legs(route)) {
    const LegKind kind = w[leg.first].kind;
    RouteStretch s;
    s.join = kind == LegKind::turn || kind == LegKind::transit;
    s.points.assign(w.begin() + static_cast<std::ptrdiff_t>(leg.first),
                    w.begin() + static_cast<std::ptrdiff_t>(leg.last));
    if (!s.join) {
      s.points.push_back(s.points.back());
      s.points.back().position = w[leg.last].position;
    }
    const bool goes_on = !result.empty() && result.back().join == s.join;
    if (goes_on && s.join) {
      result.back().points.insert(result.back().points.end(), s.points.begin(), s.points.end());
    } else {
      result.push_back(std::move(s));
    }
  }
  return result;
}

}  // namespace swathplan
