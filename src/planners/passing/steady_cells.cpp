#include "planners/passing/steady_cells.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace swathplan {
namespace {

constexpr double kPingsOfCell = 2.0;
constexpr double kMostThinning = 8.0;
/// Lines that lie beside one another belong to different groups.
constexpr std::size_t kGroups = 3;

double thinning_of(const SurveyJudge& judge, const PlanOptions& options) {
  const double depth = depth_range(*judge.ground().seafloor).mean;
  const double below = std::max(depth - options.vehicle.draft_m, 0.1);
  const double spacing = ping_spacing_m(options.sonar, options.pings, below,
                                        options.sonar.max_opening / 2.0, options.vehicle.speed_mps);
  return std::clamp(cell_m(judge.criterion(), depth) / kPingsOfCell / spacing, 1.0, kMostThinning);
}

/// Of one group of lines: what is left of a cell on both sailings.
JudgedCell least(const JudgedCell& a, const JudgedCell& b) {
  JudgedCell cell = a;
  cell.lines = std::min(a.lines, b.lines);
  cell.soundings = std::min(a.soundings, b.soundings);
  cell.accepted = std::min(a.accepted, b.accepted);
  cell.tvu_m = std::max(a.tvu_m, b.tvu_m);
  cell.thu_m = std::max(a.thu_m, b.thu_m);
  cell.feature_pings = std::min(a.feature_pings, b.feature_pings);
  cell.feature_beams = std::min(a.feature_beams, b.feature_beams);
  return cell;
}

std::uint16_t sum(std::uint16_t a, std::uint16_t b) {
  return static_cast<std::uint16_t>(std::min(a + b, 65535));
}

/// What several groups of lines leave together.
void join(JudgedCell& cell, const JudgedCell& other) {
  cell.lines = static_cast<std::uint8_t>(std::min(cell.lines + other.lines, 2));
  cell.soundings = sum(cell.soundings, other.soundings);
  cell.accepted = sum(cell.accepted, other.accepted);
  cell.tvu_m = std::min(cell.tvu_m, other.tvu_m);
  cell.thu_m = std::min(cell.thu_m, other.thu_m);
  if (std::min(other.feature_pings, other.feature_beams) >
      std::min(cell.feature_pings, cell.feature_beams)) {
    cell.feature_pings = other.feature_pings;
    cell.feature_beams = other.feature_beams;
  }
}

/// The route with the sonar off but for every kGroups-th of its logged lines. Empty: there is none.
std::optional<Route> group_of(const Route& route, std::size_t group) {
  Route result = route;
  std::optional<int> line;
  std::size_t index = 0;
  bool any = false;
  for (const Leg& leg : legs(route)) {
    const Waypoint& first = route.waypoints[leg.first];
    const bool logged = first.log && first.fan;
    if (logged && !(line && first.line == line)) ++index;
    if (logged) line = first.line;
    const bool on = logged && index % kGroups == group;
    any = any || on;
    for (std::size_t i = leg.first; i < leg.last && !on; ++i) result.waypoints[i].fan.reset();
  }
  return any ? std::optional(std::move(result)) : std::nullopt;
}

std::uint16_t times(std::uint16_t count, double factor) {
  return static_cast<std::uint16_t>(std::min(std::round(count * factor), 65535.0));
}

}  // namespace

std::vector<JudgedGrid> steady_cells(const SurveyJudge& judge, const Route& route,
                                     const PlanOptions& options, const Unsteadiness& unsteady) {
  ScoreOptions scoring;
  scoring.resolution_m = options.resolution_m;
  scoring.pings = options.pings;
  scoring.threads = options.threads;
  const double thinning = thinning_of(judge, options);
  scoring.pings.thinning *= thinning;
  const auto sailed = [&](const Route& part, double side) {
    scoring.noise.lateral_offset_m = side * unsteady.aside_m;
    scoring.noise.heading_offset = unsteady.heading * side;
    return judge.filled(part, options.sonar, options.vehicle, scoring);
  };
  std::vector<JudgedGrid> all;
  for (std::size_t group = 0; group < kGroups; ++group) {
    const std::optional<Route> part = group_of(route, group);
    if (!part) continue;
    std::vector<JudgedGrid> grids = sailed(*part, 1.0);
    const std::vector<JudgedGrid> other = sailed(*part, -1.0);
    for (std::size_t g = 0; g < grids.size(); ++g) {
      for (std::size_t i = 0; i < grids[g].cells.size(); ++i) {
        JudgedCell& cell = grids[g].cells[i];
        cell = least(cell, other[g].cells[i]);
        cell.soundings = times(cell.soundings, thinning);
        cell.accepted = times(cell.accepted, thinning);
        if (!all.empty()) join(all[g].cells[i], cell);
      }
    }
    if (all.empty()) all = std::move(grids);
  }
  return all;
}

}  // namespace swathplan
