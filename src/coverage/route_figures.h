#pragma once

#include <map>
#include <string>

#include "coverage/route.h"
#include "coverage/vehicle.h"
#include "mesh/polygons.h"
#include "mesh/seafloor.h"

namespace swathplan {

/// What can be said of a route without a sonar.
struct RouteFigures {
  double length_m = 0.0;
  std::map<std::string, double> length_by_kind_m;  ///< kind name -> metres
  double logged_length_m = 0.0;
  double length_ratio = 0.0;            ///< length / (area / W)
  std::size_t turns = 0;                ///< changes of course of at least kTurnDeg, curves counted once
  std::size_t sharp_turns = 0;          ///< of them, of at least 90 degrees
  double total_turning_deg = 0.0;       ///< sum of all changes of course
  double min_turn_radius_m = 0.0;       ///< smallest radius through three consecutive waypoints
  std::size_t self_crossings = 0;       ///< proper crossings of two segments
  double outside_water_m = 0.0;         ///< path outside the water or inside no-go
  double min_under_keel_m = 0.0;        ///< least depth below the path less the draft
  double duration_s = 0.0;              ///< length over each leg's speed
};

inline constexpr double kTurnDeg = 30.0;

/// `water`: where the boat may be (outline of the data deep enough, less no-go).
/// `footprint_width_m`: W, for the length ratio over `survey_area_m2`.
[[nodiscard]] RouteFigures route_figures(const Route& route, const Vehicle& vehicle,
                                         const Area& water, const DepthQuery& depths,
                                         double survey_area_m2, double footprint_width_m);

}  // namespace swathplan
