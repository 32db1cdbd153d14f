#include "coverage/route/route.h"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace swathplan {
namespace {

constexpr std::array<std::pair<LegKind, std::string_view>, 9> kNames{{
    {LegKind::line, "line"},
    {LegKind::turn, "turn"},
    {LegKind::transit, "transit"},
    {LegKind::cross, "cross"},
    {LegKind::infill, "infill"},
    {LegKind::patch, "patch"},
    {LegKind::run_in, "run_in"},
    {LegKind::run_out, "run_out"},
    {LegKind::end, "end"},
}};

bool same_leg(const Waypoint& a, const Waypoint& b) {
  return a.kind == b.kind && a.log == b.log && a.line == b.line && a.region == b.region &&
         a.feasible == b.feasible && a.fan.has_value() == b.fan.has_value();
}

bool is_half_angle(Angle a) { return a.deg() > 0.0 && a.deg() < 90.0; }

}  // namespace

std::string_view name(LegKind kind) {
  for (const auto& [k, text] : kNames) {
    if (k == kind) return text;
  }
  return "line";
}

bool is_survey(LegKind kind) {
  return kind == LegKind::line || kind == LegKind::cross || kind == LegKind::infill ||
         kind == LegKind::patch;
}

std::optional<LegKind> leg_kind(std::string_view text) {
  for (const auto& [k, known] : kNames) {
    if (known == text) return k;
  }
  return std::nullopt;
}

std::vector<Vec2> positions(const std::vector<Waypoint>& waypoints) {
  std::vector<Vec2> result;
  result.reserve(waypoints.size());
  for (const Waypoint& w : waypoints) result.push_back(w.position);
  return result;
}

double length_m(const Route& route) {
  double sum = 0.0;
  for (std::size_t i = 1; i < route.waypoints.size(); ++i) {
    sum += (route.waypoints[i].position - route.waypoints[i - 1].position).norm();
  }
  return sum;
}

std::vector<Leg> legs(const Route& route) {
  std::vector<Leg> result;
  const auto& w = route.waypoints;
  for (std::size_t first = 0; first + 1 < w.size();) {
    std::size_t last = first + 1;
    while (last + 1 < w.size() && same_leg(w[first], w[last])) ++last;
    result.push_back({first, last});
    first = last;
  }
  return result;
}

std::optional<std::string> fault(const Route& route) {
  const auto& w = route.waypoints;
  if (w.size() < 2) {
    return fmt::format("a route needs at least two waypoints; this one has {}", w.size());
  }
  for (std::size_t i = 0; i < w.size(); ++i) {
    if (!w[i].position.allFinite()) return fmt::format("waypoint {} has no finite position", i);
    if ((w[i].kind == LegKind::end) != (i + 1 == w.size())) {
      return fmt::format("waypoint {}: kind 'end' belongs to the last waypoint and no other", i);
    }
    if (w[i].fan && !(is_half_angle(w[i].fan->port) && is_half_angle(w[i].fan->starboard))) {
      return fmt::format("waypoint {}: half-angles {:.3f} and {:.3f} degrees; must lie in (0, 90)",
                         i, w[i].fan->port.deg(), w[i].fan->starboard.deg());
    }
    if (!(w[i].speed_mps > 0.0)) {
      return fmt::format("waypoint {}: speed {} m/s; must be above 0", i, w[i].speed_mps);
    }
  }
  return std::nullopt;
}

}  // namespace swathplan
