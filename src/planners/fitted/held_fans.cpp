#include "planners/fitted/held_fans.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "coverage/route/ping_clock.h"

namespace swathplan {
namespace {

/// Of a line's metres this share has the angle that it asks for: one jagged place of a raster does
/// not open the fan of a whole line.
constexpr double kServedShare = 0.95;
/// The speed serves this share of a line's metres by depth.
constexpr double kDepthShare = 0.75;
constexpr double kSpeedStep = 0.1;

/// Pairs of a value and the metres that it holds for.
using Weighted = std::vector<std::pair<double, double>>;

/// The value that `share` of the metres do not exceed.
double percentile(Weighted values, double share) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  double total = 0.0;
  for (const auto& [value, metres] : values) total += metres;
  double sum = 0.0;
  for (const auto& [value, metres] : values) {
    sum += metres;
    if (sum >= share * total) return value;
  }
  return values.back().first;
}

Angle whole_degrees(double radians, const Sonar& sonar) {
  // A hair over a whole degree is not the next one.
  constexpr double kDust = 1e-6;
  const double degrees = std::ceil(Angle::radians(radians).deg() - kDust);
  return std::min(Angle::degrees(std::max(degrees, 1.0)), sonar.max_opening / 2.0);
}

/// Middle of the segment from waypoint i on.
Vec2 middle(const std::vector<Waypoint>& line, std::size_t i) {
  return 0.5 * (line[i].position + line[i + 1].position);
}

/// Waypoints beyond the area take the fan of the nearest one in it along the line.
void carry_fans_out(std::vector<Waypoint>& line, const AreaQuery& area) {
  std::optional<FanAngles> last;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    if (area.contains(middle(line, i))) {
      if (!last)
        std::for_each(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(i),
                      [&](Waypoint& w) { w.fan = line[i].fan; });
      last = line[i].fan;
    } else if (last) {
      line[i].fan = last;
    }
  }
  line.back().fan = line[line.size() - 2].fan;
}

double speed_for(const FanAngles& fan, double below_m, const PlanOptions& options) {
  const Angle wider = std::max(fan.port, fan.starboard);
  const double cosine = cos(wider);
  const double gaps = options.sonar.beams - 1;
  const double spacing =
      (fan.port.rad() + fan.starboard.rad()) * below_m / (gaps * cosine * cosine);
  const double interval = ping_interval_s(options.sonar, options.pings,
                                          std::min(below_m / cosine, options.sonar.max_range_m));
  const double cell = options.resolution_m;
  return std::min({options.vehicle.speed_mps, cell / interval,
                   cell * cell / (options.soundings * std::max(spacing, 1e-9) * interval)});
}

}  // namespace

void hold_fans(std::vector<std::vector<Waypoint>>& lines, const WaterRaster& raster,
               const AreaQuery& survey_area, const PlanOptions& options) {
  for (std::vector<Waypoint>& line : lines) {
    if (line.size() < 2) continue;
    Weighted port, starboard, depths;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const Vec2 p = middle(line, i);
      if (!line[i].fan || !survey_area.contains(p)) continue;
      const double metres = (line[i + 1].position - line[i].position).norm();
      port.emplace_back(line[i].fan->port.rad(), metres);
      starboard.emplace_back(line[i].fan->starboard.rad(), metres);
      if (const auto depth = raster.depth_near(p)) depths.emplace_back(*depth, metres);
    }
    FanAngles held;
    if (port.empty()) {
      held = line.front().fan.value_or(
          FanAngles{options.sonar.max_opening / 4.0, options.sonar.max_opening / 4.0});
    } else {
      held = {whole_degrees(percentile(port, kServedShare), options.sonar),
              whole_degrees(percentile(starboard, kServedShare), options.sonar)};
    }
    if (options.opening_angle) {
      held = {*options.opening_angle / 2.0, *options.opening_angle / 2.0};
    }
    const double below = std::max(percentile(depths, kDepthShare) - options.vehicle.draft_m, 0.1);
    const double most = speed_for(held, below, options);
    const double speed = std::floor(most / kSpeedStep + 1e-6) * kSpeedStep;
    if (options.angles == Angles::ping) carry_fans_out(line, survey_area);
    for (Waypoint& w : line) {
      if (options.angles == Angles::line || options.opening_angle) w.fan = held;
      w.speed_mps = std::clamp(speed, options.least_speed_mps, options.vehicle.speed_mps);
    }
  }
}

}  // namespace swathplan
