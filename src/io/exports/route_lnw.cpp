#include "io/exports/route_lnw.h"

#include <fmt/format.h>

#include <iterator>

#include "io/exports/survey_runs.h"

namespace swathplan {

std::string route_lnw(const Route& route, const Frame& frame) {
  const std::vector<SurveyRun> runs = survey_runs(route);
  std::string text = fmt::format("LNS {}\r\n", runs.size());
  for (const SurveyRun& run : runs) {
    text += fmt::format("LIN {}\r\n", run.last - run.first + 1);
    for (std::size_t i = run.first; i <= run.last; ++i) {
      const Vec2 p = frame.to_file(route.waypoints[i].position);
      fmt::format_to(std::back_inserter(text), "PTS {:.3f} {:.3f}\r\n", p.x(), p.y());
    }
    text += fmt::format("LNN {}\r\nEOL\r\n", run.name);
  }
  return text;
}

}  // namespace swathplan
