#include "io/exports/line_table.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "io/exports/survey_runs.h"
#include "io/files/lonlat.h"
#include "io/files/text.h"

namespace swathplan {
namespace {

constexpr const char* kTableHead =
    "line,kind,stretch,start_x_m,start_y_m,end_x_m,end_y_m,start_lon_deg,start_lat_deg,end_lon_deg,"
    "end_lat_deg,heading_deg,length_m,port_deg,stbd_deg,speed_mps\r\n";

bool one_setting(const Waypoint& a, const Waypoint& b) {
  return a.fan == b.fan && a.speed_mps == b.speed_mps;
}

double heading_deg(const Vec2& from, const Vec2& to) {
  const double deg = std::atan2(to.x() - from.x(), to.y() - from.y()) * 180.0 / std::numbers::pi;
  return deg < 0.0 ? deg + 360.0 : deg;
}

std::string table_row(const Route& route, const Frame& frame, const LonLat& degrees,
                      const SurveyRun& run, const Leg& stretch, int number) {
  const auto& w = route.waypoints;
  const Vec2& from = w[stretch.first].position;
  const Vec2& to = w[stretch.last].position;
  double length = 0.0;
  for (std::size_t i = stretch.first; i < stretch.last; ++i) {
    length += (w[i + 1].position - w[i].position).norm();
  }
  const Vec2 a = frame.to_file(from);
  const Vec2 b = frame.to_file(to);
  std::string lonlat = ",,,";
  if (degrees.known()) {
    const std::vector<Vec2> at = degrees.from_local({from, to});
    lonlat = fmt::format("{:.8f},{:.8f},{:.8f},{:.8f}", at[0].x(), at[0].y(), at[1].x(), at[1].y());
  }
  const auto& fan = w[stretch.first].fan;
  return fmt::format(
      "{},{},{},{:.3f},{:.3f},{:.3f},{:.3f},{},{},{:.3f},{},{},{}\r\n", run.name,
      name(w[run.first].kind), number, a.x(), a.y(), b.x(), b.y(), lonlat,
      decimal(heading_deg(from, to), 3), length, fan ? decimal(fan->port.deg(), 4) : "",
      fan ? decimal(fan->starboard.deg(), 4) : "", decimal(w[stretch.first].speed_mps, 4));
}

}  // namespace

std::string line_table(const Route& route, const Frame& frame) {
  const LonLat degrees(frame);
  std::string text = kTableHead;
  for (const SurveyRun& run : survey_runs(route)) {
    int number = 0;
    for (std::size_t first = run.first; first < run.last;) {
      std::size_t last = first + 1;
      while (last < run.last && one_setting(route.waypoints[first], route.waypoints[last])) ++last;
      text += table_row(route, frame, degrees, run, {first, last}, ++number);
      first = last;
    }
  }
  return text;
}

}  // namespace swathplan
