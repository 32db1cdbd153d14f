#pragma once

#include <vector>

#include "coverage/judging/traced_pings.h"
#include "coverage/standards/criteria.h"
#include "coverage/standards/uncertainty.h"
#include "coverage/tracing/fan_table.h"

namespace swathplan {

/// Where a beam met the seafloor, and what is known of it.
struct JudgedSounding {
  Vec2 position = Vec2::Zero();  ///< local metres
  float depth_m = 0.0F;          ///< below still water
  float tvu_m = 0.0F, thu_m = 0.0F;
  float tvu_share = 0.0F;                            ///< of its limit
  float feature_pings = 0.0F, feature_beams = 0.0F;  ///< on a cube there; 0 where none is asked for
  float path_m = 0.0F;                               ///< of the route, to its ping
  std::uint32_t line = 0;
  bool accepted = false;
};

/// Makes soundings of what beams met; one per thread, for it keeps its tables.
class SoundingMaker {
 public:
  SoundingMaker(const Sonar& sonar, double draft_m, double swath_share, const Criterion& criterion,
                const UncertaintyModel& model);
  /// Appends the soundings of the logged pings, beam by beam from port.
  void append(const TracedPings& block, std::vector<JudgedSounding>& soundings);

 private:
  void append_fan(const TracedPings& block, std::size_t ping,
                  std::vector<JudgedSounding>& soundings);

  double draft_;
  const Criterion* criterion_;
  const UncertaintyModel* model_;
  FanTableCache tables_;
};

}  // namespace swathplan
