#include "io/water/legs_csv.h"

#include <fmt/format.h>

#include "io/files/text.h"
#include "io/water/times.h"

namespace swathplan {

std::string legs_csv(const Route& route, const std::vector<LegWater>& legs,
                     const std::optional<double>& departure_s) {
  std::string text =
      "leg,line,kind,start_s,end_s,start_time,end_time,least_depth_m,under_keel_m,short_of_water,"
      "water_windows\r\n";
  const auto metres = [](const std::optional<double>& value) {
    return value ? decimal(*value, 3) : std::string();
  };
  const auto time = [&](double seconds) {
    return departure_s ? time_text(*departure_s + seconds) : std::string();
  };
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const LegWater& leg = legs[i];
    const Waypoint& w = route.waypoints[leg.leg.first];
    std::string windows;
    for (const TimeSpan& span : leg.windows) {
      windows += fmt::format("{}{}/{}", windows.empty() ? "" : " ", time_text(span.from_s),
                             time_text(span.to_s));
    }
    const std::string shoal = leg.short_of_water ? (*leg.short_of_water ? "1" : "0") : "";
    text += fmt::format("{},{},{},{:.1f},{:.1f},{},{},{},{},{},{}\r\n", i + 1,
                        w.line ? std::to_string(*w.line) : "", name(w.kind), leg.start_s, leg.end_s,
                        time(leg.start_s), time(leg.end_s), metres(leg.least_depth_m),
                        metres(leg.under_keel_m), shoal, windows);
  }
  return text;
}

}  // namespace swathplan
