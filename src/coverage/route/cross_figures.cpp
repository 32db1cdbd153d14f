#include "coverage/route/cross_figures.h"

#include <numbers>
#include <vector>

#include "mesh/plane/segments.h"

namespace swathplan {
namespace {

struct LoggedSegment {
  Vec2 a, b;
};

struct Logged {
  std::vector<LoggedSegment> main, cross;
};

Logged logged_segments(const Route& route, CrossFigures& figures) {
  Logged logged;
  const auto& w = route.waypoints;
  for (std::size_t i = 0; i + 1 < w.size(); ++i) {
    if (!w[i].log) continue;
    const double length = (w[i + 1].position - w[i].position).norm();
    if (w[i].kind == LegKind::cross) {
      logged.cross.push_back({w[i].position, w[i + 1].position});
      figures.length_m += length;
    } else if (w[i].kind == LegKind::line || w[i].kind == LegKind::infill) {
      logged.main.push_back({w[i].position, w[i + 1].position});
      figures.main_length_m += length;
    }
  }
  return logged;
}

}  // namespace

double crossing_angle_deg(const Vec2& a, const Vec2& b) {
  const double turn = std::abs(std::atan2(cross(a, b), a.dot(b))) * 180.0 / std::numbers::pi;
  return std::min(turn, 180.0 - turn);
}

CrossFigures cross_figures(const Route& route) {
  CrossFigures figures;
  const Logged logged = logged_segments(route, figures);
  for (const Leg& leg : legs(route)) {
    const Waypoint& first = route.waypoints[leg.first];
    if (first.kind == LegKind::cross && first.log) ++figures.lines;
  }
  for (const LoggedSegment& c : logged.cross) {
    for (const LoggedSegment& m : logged.main) {
      if (!crossing(c.a, c.b, m.a, m.b)) continue;
      ++figures.crossings;
      if (crossing_angle_deg(c.b - c.a, m.b - m.a) >= 90.0 - kRightAngleDeg) {
        ++figures.right_angled;
      }
    }
  }
  return figures;
}

}  // namespace swathplan
