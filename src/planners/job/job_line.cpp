#include "planners/job/job_line.h"

#include <algorithm>
#include <cmath>

#include "coverage/route/bends.h"
#include "planners/rows/route_stretches.h"

namespace swathplan {
namespace {

/// Points nearer than this are one place, metres.
constexpr double kOnePlace = 1e-6;

LegKind turned_round(LegKind kind) {
  if (kind == LegKind::run_in) return LegKind::run_out;
  if (kind == LegKind::run_out) return LegKind::run_in;
  return kind;
}

/// The same path from its end to its beginning. What a waypoint says holds from it on, so each
/// takes over what the one after it said.
std::vector<Waypoint> reversed(const std::vector<Waypoint>& points) {
  std::vector<Waypoint> back;
  back.reserve(points.size());
  for (std::size_t i = points.size(); i-- > 0;) {
    Waypoint w = points[i > 0 ? i - 1 : 0];
    w.position = points[i].position;
    w.kind = turned_round(w.kind);
    if (w.fan) std::swap(w.fan->port, w.fan->starboard);
    back.push_back(w);
  }
  return back;
}

/// The join that leads from `from` back to the line before it, sailed the other way.
std::vector<Waypoint> reversed_join(const JobLine& from) {
  if (from.join_before.empty()) return {};
  std::vector<Waypoint> path = from.join_before;
  path.push_back(path.back());
  path.back().position = from.points.front().position;
  path = reversed(path);
  path.pop_back();
  return path;
}

Vec2 course_between(const std::vector<Waypoint>& points, bool at_end) {
  const Vec2 end = at_end ? points.back().position : points.front().position;
  for (std::size_t k = 1; k < points.size(); ++k) {
    const Vec2& other = points[at_end ? points.size() - 1 - k : k].position;
    const Vec2 way = at_end ? Vec2(end - other) : Vec2(other - end);
    if (way.norm() > kOnePlace) return way.normalized();
  }
  return Vec2::UnitY();
}

/// Whether a join can be sailed as drawn, from the line before it to the one behind it.
bool is_sailed(const std::vector<Waypoint>& before, const std::vector<Waypoint>& join,
               const std::vector<Waypoint>& after, double turn_radius_m) {
  std::vector<Vec2> path;
  const auto add = [&](const Waypoint& w) {
    if (path.empty() || (path.back() - w.position).norm() > kOnePlace) path.push_back(w.position);
  };
  add(before[before.size() - 2]);
  add(before.back());
  for (const Waypoint& w : join) add(w);
  add(after[0]);
  add(after[1]);
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    if (is_corner(course_change(path[i - 1], path[i], path[i + 1]), turn_radius_m)) return false;
  }
  return true;
}

}  // namespace

std::vector<JobLine> job_lines(const Route& route, double turn_radius_m) {
  std::vector<JobLine> lines;
  std::vector<Waypoint> join;
  bool after_line = false;
  for (RouteStretch& s : stretches(route)) {
    if (s.join) {
      join = std::move(s.points);
      after_line = false;
      continue;
    }
    if (after_line) {
      std::vector<Waypoint>& points = lines.back().points;
      points.pop_back();
      points.insert(points.end(), s.points.begin(), s.points.end());
    } else {
      // Files of lines alone have straight ways between them, which no boat can turn into.
      const bool kept =
          !lines.empty() && is_sailed(lines.back().points, join, s.points, turn_radius_m);
      if (!kept) join.clear();
      lines.push_back({std::move(s.points), std::move(join)});
      join.clear();
    }
    after_line = true;
  }
  return lines;
}

LegKind purpose(const JobLine& line) {
  std::optional<LegKind> found;
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
    const LegKind kind = line.points[i].kind;
    if (kind == LegKind::run_in || kind == LegKind::run_out) continue;
    if (kind != LegKind::patch && kind != LegKind::cross) return LegKind::line;
    if (found && *found != kind) return LegKind::line;
    found = kind;
  }
  return found.value_or(LegKind::line);
}

JobLine backwards(const JobLine& line) { return {reversed(line.points)}; }

std::vector<JobLine> backwards(const std::vector<JobLine>& lines) {
  std::vector<JobLine> back;
  for (std::size_t i = lines.size(); i-- > 0;) {
    back.push_back(backwards(lines[i]));
    if (i + 1 < lines.size()) back.back().join_before = reversed_join(lines[i + 1]);
  }
  return back;
}

double sailing_s(const std::vector<Waypoint>& points) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    sum += (points[i + 1].position - points[i].position).norm() / points[i].speed_mps;
  }
  return sum;
}

std::vector<JobLine> divided(const JobLine& line, int pieces) {
  const double whole = sailing_s(line.points);
  std::vector<JobLine> result(1);
  result[0].join_before = line.join_before;
  double sailed = 0.0;
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
    const Waypoint& from = line.points[i];
    const Vec2 way = line.points[i + 1].position - from.position;
    const double seconds = way.norm() / from.speed_mps;
    result.back().points.push_back(from);
    for (int cut = static_cast<int>(result.size()); cut < pieces; ++cut) {
      const double at = whole * cut / pieces;
      if (at >= sailed + seconds) break;
      Waypoint here = from;
      here.position += way * ((at - sailed) / seconds);
      result.back().points.push_back(here);
      result.push_back({{here}, {}});
    }
    sailed += seconds;
  }
  result.back().points.push_back(line.points.back());
  return result;
}

LineEnds ends_of_line(const JobLine& line) {
  return {line.points.front().position, line.points.back().position,
          course_between(line.points, false), course_between(line.points, true)};
}

std::vector<JobLine> arranged(const std::vector<JobLine>& lines,
                              const std::vector<OrderedLine>& order) {
  std::vector<JobLine> result;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const OrderedLine& now = order[k];
    JobLine line = now.backwards ? backwards(lines[now.line]) : lines[now.line];
    line.join_before.clear();
    if (k > 0 && order[k - 1].backwards == now.backwards) {
      const std::size_t before = order[k - 1].line;
      if (!now.backwards && before + 1 == now.line) {
        line.join_before = lines[now.line].join_before;
      } else if (now.backwards && before == now.line + 1) {
        line.join_before = reversed_join(lines[before]);
      }
    }
    result.push_back(std::move(line));
  }
  return result;
}

}  // namespace swathplan
