#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "mesh/plane/area_query.h"
#include "planners/steering/connect.h"

namespace swathplan {

/// The largest change of curvature along a path, 1/m per m. It is measured between points at an
/// even spacing of about `step_m`. A jump of curvature counts as a change over one or two steps.
[[nodiscard]] double sharpest_change(const std::vector<Vec2>& path, double step_m);

/// A curve of a join after Ipopt. A bend that was not smoothed stays as it was given.
struct SmoothedCurve {
  std::vector<Vec2> points;
  std::size_t bends = 0, smoothed = 0;
  std::map<std::string, std::size_t> kept;  ///< reason why bends were kept -> number of bends
};

/// Whether a later candidate for a join takes the place of the best one before it: more of its
/// bends are smoothed, or none of either is. The plain join is the last candidate, so it stays
/// where nothing could be smoothed.
[[nodiscard]] bool takes_over(const SmoothedCurve& later, const SmoothedCurve& best);

/// Counts of the joins that have a bend.
struct JoinTally {
  std::size_t joins = 0;
  std::size_t whole = 0;  ///< joins of which every bend was smoothed
  std::size_t part = 0;   ///< joins of which some bends were smoothed, not all
  std::size_t bends = 0;
  std::map<std::string, std::size_t> kept;  ///< reason why bends were kept -> number of bends
  double change_before = 0.0, change_after = 0.0;  ///< sums of sharpest_change over `whole`
  double added_m = 0.0;                            ///< what smoothing adds to the route's length
};

/// Joins lines as a Connector does, but with smooth bends: the curvature changes gradually and does
/// not jump from straight to arc. docs/smoothing.md states the problem. Guarantees: each bend of a
/// join is (1) smoothed: it stays in the water, is no tighter than the radius, keeps its ends and
/// the courses there, and its sharpest change of curvature is less than before; or (2) the
/// Connector's bend, counted with the reason. Deterministic.
class JoinSmoother {
 public:
  /// `connector` must outlive it.
  JoinSmoother(const Area& safe_water, const Connector& connector, double radius_m);

  [[nodiscard]] Connection join(const std::vector<Vec2>& before, const std::vector<Vec2>& after);
  /// A curve from one pose to another with its bends smoothed.
  [[nodiscard]] SmoothedCurve smoothed(const Pose& from, const Pose& to,
                                       const std::vector<Vec2>& curve) const;
  [[nodiscard]] const JoinTally& tally() const { return tally_; }

 private:
  struct Bend {
    Pose from, to;
    std::vector<Vec2> points;
  };
  [[nodiscard]] std::string smooth(Bend& bend) const;
  [[nodiscard]] double change(const Bend& bend) const;
  [[nodiscard]] bool steerable(const Bend& bend) const;
  [[nodiscard]] std::vector<Connection> candidates(const Connection& plain,
                                                   const std::vector<Vec2>& before,
                                                   const std::vector<Vec2>& after) const;

  AreaQuery water_;
  const Connector& connector_;
  double radius_;
  JoinTally tally_;
};

/// The counts in a sentence.
[[nodiscard]] std::string note(const JoinTally& tally);

}  // namespace swathplan
