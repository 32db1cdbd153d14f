#include "planners/steering/led_round.h"

#include "mesh/plane/area_query.h"
#include "planners/steering/water_path.h"

namespace swathplan {
namespace {

constexpr double kShortestPart = 1.0;  // metres
/// Ways may come so much nearer than lines end, so that each end of a line lies in their water.
constexpr double kNearerShare = 0.9;
constexpr double kTouch = 1e-6;  // metres; what is less comes from rounding

/// A part of a survey line.
struct LinePart {
  Waypoint begin;
  Vec2 end = Vec2::Zero();
};

/// The rest of [0, 1].
std::vector<std::pair<double, double>> outside(
    const std::vector<std::pair<double, double>>& inside) {
  std::vector<std::pair<double, double>> rest;
  double at = 0.0;
  for (const auto& [low, high] : inside) {
    if (low > at) rest.emplace_back(at, low);
    at = high;
  }
  if (at < 1.0) rest.emplace_back(at, 1.0);
  return rest;
}

std::vector<LinePart> parts_outside(const Route& route, const AreaQuery& area,
                                    std::vector<CutLine>& cut) {
  std::vector<LinePart> parts;
  for (std::size_t i = 0; i + 1 < route.waypoints.size(); ++i) {
    const Waypoint& from = route.waypoints[i];
    if (!is_survey(from.kind)) continue;
    const Vec2 way = route.waypoints[i + 1].position - from.position;
    const auto inside = area.clip(from.position, from.position + way);
    if (inside.empty()) {
      parts.push_back({from, from.position + way});
      continue;
    }
    double sailed_m = 0.0;
    for (const auto& [low, high] : outside(inside)) {
      const double length = (high - low) * way.norm();
      if (length < kShortestPart) continue;
      sailed_m += length;
      LinePart part{from, from.position + high * way};
      part.begin.position = from.position + low * way;
      parts.push_back(part);
    }
    if (cut.empty() || cut.back().line != from.line) cut.push_back({from.line, 0.0});
    cut.back().left_out_m += way.norm() - sailed_m;
  }
  return parts;
}

}  // namespace

LedRound led_round(const Route& route, const Area& area, const Area& water, double room_m) {
  LedRound result;
  const Area kept_off = offset(area, room_m);
  const AreaQuery blocked(kept_off);
  const std::vector<LinePart> parts = parts_outside(route, blocked, result.cut);
  std::optional<WaterPath> ways;  // costs more than all else, and is seldom needed
  std::vector<Waypoint>& sailed = result.route.waypoints;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    sailed.push_back(parts[k].begin);
    const bool last = k + 1 == parts.size();
    const Vec2 next = last ? parts[k].end : parts[k + 1].begin.position;
    if (!last && parts[k].end == next) continue;  // the line bends here
    Waypoint corner;
    corner.position = parts[k].end;
    corner.kind = last ? LegKind::end : LegKind::transit;
    corner.log = false;
    corner.speed_mps = parts[k].begin.speed_mps;
    sailed.push_back(corner);
    if (last || blocked.inside_length(corner.position, next) <= kTouch) continue;
    if (!ways) ways.emplace(subtract(water, offset(area, kNearerShare * room_m)));
    const auto way = ways->find(corner.position, next);
    for (std::size_t i = 1; way && i + 1 < way->size(); ++i) {
      corner.position = (*way)[i];
      sailed.push_back(corner);
    }
  }
  return result;
}

}  // namespace swathplan
