#include "io/exports/planned_lines.h"

#include <fmt/format.h>

#include <iterator>

#include "io/exports/survey_runs.h"
#include "io/files/text.h"

namespace swathplan {
namespace {

constexpr const char* kNoTime = "19700101000000";

std::string settings_comment(const Waypoint& w) {
  const std::string fan =
      w.fan ? fmt::format(", port {} stbd {} degrees", decimal(w.fan->port.deg(), 2),
                          decimal(w.fan->starboard.deg(), 2))
            : "";
  return fmt::format("# {} m/s{}\r\n", decimal(w.speed_mps, 3), fan);
}

}  // namespace

std::string route_rln(const Route& route, const Frame& frame) {
  std::string text;
  for (const SurveyRun& run : survey_runs(route)) {
    text += settings_comment(route.waypoints[run.first]);
    text += fmt::format("\"{}\"\r\n", run.name);
    double metres = 0.0;
    for (std::size_t i = run.first; i <= run.last; ++i) {
      const Vec2& here = route.waypoints[i].position;
      if (i > run.first) metres += (here - route.waypoints[i - 1].position).norm();
      const Vec2 p = frame.to_file(here);
      fmt::format_to(std::back_inserter(text), "{:.3f}, {:.3f}, {:.6f}\r\n", p.x(), p.y(),
                     metres / 1000.0);
    }
  }
  return text;
}

std::string route_asciiplan(const GeographicRoute& route) {
  std::string text = "DEG\r\n\r\n0 0 0 0\r\n";
  std::size_t number = 0;
  for (const SurveyRun& run : survey_runs(route.route)) {
    fmt::format_to(std::back_inserter(text), "_LINE Line_{} {} {} 0", run.name, ++number, kNoTime);
    for (std::size_t i = run.first; i <= run.last; ++i) {
      fmt::format_to(std::back_inserter(text), " {:.8f} {:.8f}", route.lonlat[i].y(),
                     route.lonlat[i].x());
    }
    text += " \"\r\n";
  }
  return text;
}

}  // namespace swathplan
