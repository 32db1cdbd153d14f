#pragma once

#include <functional>
#include <vector>

#include "coverage/dropped_objects.h"
#include "coverage/side_scan.h"
#include "planners/adaptive/accordion.h"
#include "planners/adaptive/cost_map.h"

namespace swathplan {

/// Puts `count` objects at random places of the box, at least `margin_m` off its edges. Spheres of
/// 1 m, cylinders of 0.6 x 2 m and boxes of 0.8 x 1.2 x 0.8 m follow in turn, each with a random
/// heading. A place without a depth is drawn again. @throws InvalidInput if 1000 draws in a row
/// find no seafloor.
[[nodiscard]] std::vector<DroppedObject> dropped_objects(const SurveyBox& box, int count,
                                                         double margin_m, const DepthQuery& depths,
                                                         std::uint64_t seed);

/// What a simulated accordion mission sails over: a traced seafloor, and the sonar of the vehicle.
/// References must outlive the mission.
struct ScanWorld {
  const RayScene* scene = nullptr;
  std::function<double(const Vec2&)> depth_below;  ///< of the bottom without objects
  SideScanSonar sonar;                             ///< range and nadir gap are set by the mission
  CostMapOptions cost;
  bool fill_nadir = true;  ///< a multibeam sonar fills the nadir gap, as the paper assumes
  SurveyBox box;
};

/// One track of a mission. `image` is passed to the callback and not kept.
struct ScannedTrack {
  SurveyTrack track;
  SideScanImage image;
  AccordionObservation observation;
};
[[nodiscard]] AccordionState sail(const AccordionOptions& options, const ScanWorld& world,
                                  const std::function<void(const ScannedTrack&)>& each);

/// From which sides an object was seen. A track sees an object whose top is in free sight of the
/// sonar, outside the nadir gap and within range.
struct ObjectSights {
  bool from_below = false, from_above = false;
};
[[nodiscard]] std::vector<ObjectSights> sights(const std::vector<DroppedObject>& objects,
                                               const std::vector<SurveyTrack>& tracks,
                                               const AccordionOptions& options,
                                               const ScanWorld& world);

}  // namespace swathplan
