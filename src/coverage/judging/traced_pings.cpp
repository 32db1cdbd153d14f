#include "coverage/judging/traced_pings.h"

namespace swathplan {

namespace {

// Legs of one survey line share its number; other legs stand for themselves.
std::vector<std::uint32_t> lines_of_legs(const Route& route) {
  std::vector<std::uint32_t> lines;
  for (const Leg& leg : legs(route)) {
    const std::optional<int> line = route.waypoints[leg.first].line;
    lines.push_back(line ? 2U * static_cast<std::uint32_t>(*line) + 2U
                         : 2U * static_cast<std::uint32_t>(lines.size()) + 1U);
  }
  return lines;
}

}  // namespace

TracedPingReader::TracedPingReader(const Route& route, const RayScene& scene, const Sonar& sonar,
                                   double draft_m, const ScoreOptions& scoring,
                                   const CoverageGrid& grid)
    : sonar_(&sonar),
      timing_(scoring.pings),
      tracer_(scene, sonar, draft_m, grid, Bands{}, false, scoring.swath_share),
      walker_(route, sonar, scoring.pings, scoring.noise),
      line_of_leg_(lines_of_legs(route)) {}

bool TracedPingReader::next(std::size_t count, TracedPings& block) {
  block.hits.floats.clear();
  block.hits.starts.clear();
  block.spacing_m.clear();
  block.line.clear();
  const auto trace = [&](const Ping& ping) {
    const auto farthest = static_cast<double>(tracer_.trace_rays(ping, block.hits));
    if (farthest > 0.0) range_ = farthest;
    block.spacing_m.push_back(timing_.spacing_m
                                  ? timing_.thinning * *timing_.spacing_m
                                  : ping.speed_mps * ping_interval_s(*sonar_, timing_, range_));
    return farthest;
  };
  if (!walker_.next(count, block.pings, trace)) return false;
  if (!walker_.by_the_clock()) {
    for (const Ping& ping : block.pings) trace(ping);
  }
  for (const Ping& ping : block.pings) block.line.push_back(line_of_leg_[ping.leg]);
  return true;
}

}  // namespace swathplan
