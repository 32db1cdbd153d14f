#include "coverage/route/leg_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "mesh/base/error.h"

namespace swathplan {

namespace {

// The first waypoint from `from` up to `to` that a row lies at.
std::optional<std::size_t> met_at(const std::vector<Waypoint>& points, std::size_t from,
                                  std::size_t to, const Vec2& row) {
  for (std::size_t i = from; i < to; ++i) {
    if ((points[i].position - row).norm() <= kLegTableM) return i;
  }
  return std::nullopt;
}

bool near(const Waypoint& a, const Waypoint& b) {
  return (a.position - b.position).norm() <= kLegTableM;
}

// Where the path first comes back to the place of waypoint `from`, before `to`.
std::optional<std::size_t> come_back(const std::vector<Waypoint>& points, std::size_t from,
                                     std::size_t to) {
  bool away = false;
  for (std::size_t i = from + 1; i < to; ++i) {
    if (!near(points[i], points[from]))
      away = true;
    else if (away)
      return i;
  }
  return std::nullopt;
}

bool begins_logged(const Waypoint& row) { return row.kind != LegKind::end && row.log; }

// The row since the last logged one that begins where the logged row k does: a turn or a way that
// leads back to its own beginning.
std::optional<std::size_t> loop_before(const std::vector<Waypoint>& rows, std::size_t k) {
  for (std::size_t i = k; i-- > 0 && !begins_logged(rows[i]);) {
    if (near(rows[i], rows[k])) return i;
  }
  return std::nullopt;
}

// Where the logged row behind k that begins elsewhere is met, looked for from `from`; the end of
// the points where there is none.
std::size_t next_logged_met(const std::vector<Waypoint>& points, const std::vector<Waypoint>& rows,
                            std::size_t k, std::size_t from) {
  for (std::size_t next = k + 1; next < rows.size(); ++next) {
    if (!begins_logged(rows[next]) || near(rows[next], rows[k])) continue;
    return met_at(points, from, points.size(), rows[next].position).value_or(points.size());
  }
  return points.size();
}

}  // namespace

Route leg_table(const Route& route) {
  Route table;
  for (const Leg& leg : legs(route)) {
    for (std::size_t i = leg.first; i < leg.last; ++i) {
      const Waypoint& w = route.waypoints[i];
      const bool begins = i == leg.first || w.speed_mps != route.waypoints[i - 1].speed_mps;
      if (begins) table.waypoints.push_back(w);
    }
  }
  if (!route.waypoints.empty()) table.waypoints.push_back(route.waypoints.back());
  return table;
}

Route with_leg_table(const Route& route, const Route& table) {
  Route result = route;
  std::vector<Waypoint>& points = result.waypoints;
  if (points.empty()) return result;
  // Where each row is met. Rows of logged legs come first: they bound the others.
  std::vector<std::optional<std::size_t>> met(table.waypoints.size());
  std::size_t at = 0;
  for (std::size_t k = 0; k < met.size(); ++k) {
    const Waypoint& row = table.waypoints[k];
    if (!begins_logged(row)) continue;
    met[k] = met_at(points, at, points.size(), row.position);
    if (!met[k]) {
      throw InvalidInput(fmt::format(
          "row {} of the leg table begins a logged leg at {:.2f},{:.2f} (metres from the "
          "seafloor's "
          "origin), where the route has no waypoint: give the table that was written with this "
          "route",
          k + 1, row.position.x(), row.position.y()));
    }
    // A loop begins where it ends: of the two places, the logged row is the second.
    const std::optional<std::size_t> loop = loop_before(table.waypoints, k);
    if (loop) {
      const std::size_t bound = next_logged_met(points, table.waypoints, k, *met[k]);
      if (const auto back = come_back(points, *met[k], bound)) {
        met[*loop] = met[k];
        met[k] = back;
      }
    }
    at = *met[k];
  }
  at = 0;
  for (std::size_t k = 0; k < met.size(); ++k) {
    if (!met[k]) {
      std::size_t end = points.size();
      for (std::size_t next = k + 1; next < met.size(); ++next) {
        if (!met[next]) continue;
        end = *met[next] + 1;
        break;
      }
      met[k] = met_at(points, at, end, table.waypoints[k].position);
    }
    if (met[k]) at = *met[k];
  }
  for (Waypoint& w : points) w.log = false;
  const Waypoint* row = nullptr;
  std::size_t k = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    // Of rows met at one place the last one counts.
    for (; k < met.size() && (!met[k] || *met[k] <= i); ++k) {
      if (met[k] && table.waypoints[k].kind != LegKind::end) row = &table.waypoints[k];
    }
    if (row == nullptr) continue;
    const Vec2 position = points[i].position;
    points[i] = *row;
    points[i].position = position;
  }
  return result;
}

}  // namespace swathplan
