#pragma once

#include <vector>

#include "coverage/route/sonar.h"

namespace swathplan {

/// A fan's beams in its own plane: sine and cosine of each beam's angle from nadir (starboard
/// positive), and the angles to its neighbours. Arrays are padded to whole packets of rays.
class FanTable {
 public:
  /// The beams that reach no farther to either side than `swath_share` of the fan does on level
  /// ground.
  FanTable(const Sonar& sonar, const FanAngles& fan, double swath_share = 1.0);

  FanAngles fan;
  std::size_t beams = 0, padded = 0;
  std::vector<float> sine, cosine;
  std::vector<float> step;       ///< radians between beams i - 1 and i; at the ends as beside them
  std::vector<float> reach;      ///< slant range beyond which a beam gives no sounding, metres
  std::vector<float> next_step;  ///< radians between beams i and i + 1
};

/// The tables of the last fans used. A route has few fans: about one a depth region.
class FanTableCache {
 public:
  explicit FanTableCache(const Sonar& sonar, double swath_share = 1.0)
      : sonar_(&sonar), swath_share_(swath_share) {}
  /// Valid until the next call.
  const FanTable& get(const FanAngles& fan);

 private:
  static constexpr std::size_t kKept = 8;
  const Sonar* sonar_;
  double swath_share_;
  std::vector<FanTable> tables_;
  std::size_t last_ = 0, oldest_ = 0;
};

}  // namespace swathplan
