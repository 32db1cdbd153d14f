#include "coverage/water/leg_water.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "coverage/route/route_figures.h"

namespace swathplan {
namespace {

constexpr double kNoDepthYet = std::numeric_limits<double>::infinity();

/// Looks along one leg.
class LegSounder {
 public:
  LegSounder(const DepthQuery& depths, const Vehicle& vehicle, const Sailing& sailing)
      : depths_(depths), vehicle_(vehicle), sailing_(sailing) {}

  /// `seconds` of the route are behind before the segment.
  void sail(const Vec2& from, const Vec2& to, double speed_mps, double seconds) {
    const double length = (to - from).norm();
    const double steps = std::max(1.0, std::ceil(length / kDepthStepM));
    // Nothing is said of a leg without a depth, however far beyond the data it runs on.
    for (double k = 0.0; k <= steps && !unknown_; ++k) {
      look(from + k / steps * (to - from), seconds + k / steps * length / speed_mps);
    }
  }

  void finish(LegWater& water) const {
    if (unknown_ || least_m_ == kNoDepthYet) return;
    water.least_depth_m = least_m_;
    const double safe = safe_depth_m(vehicle_);
    if (sailing_.tide == nullptr) {
      water.under_keel_m = least_m_ - vehicle_.draft_m;
      water.short_of_water = least_m_ < safe;
      return;
    }
    water.windows = sailing_.tide->spans_above(safe - least_m_);
    if (!sailing_.departure_s || beyond_table_) return;
    water.under_keel_m = least_when_sailed_m_ - vehicle_.draft_m;
    water.short_of_water = least_when_sailed_m_ < safe;
  }

 private:
  void look(const Vec2& p, double seconds) {
    const auto depth = depths_.depth(p);
    if (!depth) {
      unknown_ = true;
      return;
    }
    least_m_ = std::min(least_m_, *depth);
    if (sailing_.tide == nullptr || !sailing_.departure_s) return;
    const auto height = sailing_.tide->height_m(*sailing_.departure_s + seconds);
    beyond_table_ = beyond_table_ || !height;
    if (height) least_when_sailed_m_ = std::min(least_when_sailed_m_, *depth + *height);
  }

  const DepthQuery& depths_;
  const Vehicle& vehicle_;
  const Sailing& sailing_;
  double least_m_ = kNoDepthYet, least_when_sailed_m_ = kNoDepthYet;
  bool unknown_ = false, beyond_table_ = false;
};

/// A part of a leg, and when it begins if not at the end of the one before.
struct TimedLeg {
  Leg leg{};
  std::optional<double> begins_s;
};

std::vector<TimedLeg> timed_legs(const Route& route, const std::vector<Beginning>& beginnings) {
  std::vector<TimedLeg> parts;
  auto next = beginnings.begin();
  for (const Leg& leg : legs(route)) {
    Leg part = leg;
    std::optional<double> begins;
    for (; next != beginnings.end() && next->waypoint < leg.last; ++next) {
      if (next->waypoint > part.first) parts.push_back({{part.first, next->waypoint}, begins});
      part.first = next->waypoint;
      begins = next->begins_s;
    }
    parts.push_back({part, begins});
  }
  return parts;
}

}  // namespace

std::vector<LegWater> water_of_legs(const Route& route, const Vehicle& vehicle,
                                    const DepthQuery& depths, const Sailing& sailing) {
  std::vector<LegWater> result;
  double seconds = 0.0;
  for (const auto& [leg, begins_s] : timed_legs(route, sailing.beginnings)) {
    seconds = begins_s.value_or(seconds);
    LegWater water;
    water.leg = leg;
    water.start_s = seconds;
    LegSounder sounder(depths, vehicle, sailing);
    for (std::size_t i = leg.first; i < leg.last; ++i) {
      const Waypoint& w = route.waypoints[i];
      const Vec2& next = route.waypoints[i + 1].position;
      sounder.sail(w.position, next, w.speed_mps, seconds);
      seconds += (next - w.position).norm() / w.speed_mps;
    }
    water.end_s = seconds;
    sounder.finish(water);
    result.push_back(std::move(water));
  }
  return result;
}

void add_water(const Route& route, const std::vector<LegWater>& legs, RouteFigures& figures) {
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const LegWater& leg = legs[i];
    if (!leg.under_keel_m) continue;
    const Waypoint& w = route.waypoints[leg.leg.first];
    if (!figures.least_water || *leg.under_keel_m < figures.least_water->under_keel_m) {
      figures.least_water = {.leg = i + 1,
                             .kind = w.kind,
                             .line = w.line,
                             .under_keel_m = *leg.under_keel_m,
                             .start_s = leg.start_s};
    }
    if (!w.line || !is_survey(w.kind)) continue;
    const auto [known, is_new] = figures.under_keel_by_line_m.emplace(*w.line, *leg.under_keel_m);
    if (!is_new) known->second = std::min(known->second, *leg.under_keel_m);
  }
}

}  // namespace swathplan
