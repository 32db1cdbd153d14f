#pragma once

#include <cstdint>
#include <vector>

#include "coverage/score.h"
#include "coverage/tracing/ping_tracer.h"

namespace swathplan {

/// Some pings of a route in order, what their beams met, and what else a sounding's strikes hang
/// on.
struct TracedPings {
  std::vector<Ping> pings;
  BlockHits hits;
  std::vector<double> spacing_m;    ///< of each ping: path to the next one
  std::vector<std::uint32_t> line;  ///< > 0; the same for pings of the same survey line
};

/// Walks along a route and traces its pings, one after the other, for by the clock each hangs on
/// the one before. Keeps references to all that it is given.
class TracedPingReader {
 public:
  /// `grid` is any grid: soundings are not sorted into it here.
  TracedPingReader(const Route& route, const RayScene& scene, const Sonar& sonar, double draft_m,
                   const ScoreOptions& scoring, const CoverageGrid& grid);
  /// The next pings; false when none is left.
  bool next(std::size_t count, TracedPings& block);
  [[nodiscard]] double progress() const { return walker_.progress(); }

 private:
  const Sonar* sonar_;
  PingTiming timing_;
  PingTracer tracer_;
  PingWalker walker_;
  std::vector<std::uint32_t> line_of_leg_;
  double range_ = 0.0;  // of the last ping that had a sounding
};

}  // namespace swathplan
