#pragma once

#include <map>
#include <optional>
#include <string>

#include "coverage/route/cross_figures.h"
#include "coverage/route/route.h"
#include "coverage/route/vehicle.h"
#include "mesh/plane/polygons.h"
#include "mesh/seafloor.h"

namespace swathplan {

/// The leg of a route with the least water under the keel.
struct LeastWater {
  std::size_t leg = 0;  ///< from 1, in sailing order
  LegKind kind = LegKind::line;
  std::optional<int> line;
  double under_keel_m = 0.0;
  double start_s = 0.0;  ///< since the start of the route
};

/// What can be said of a route without a sonar. A waypoint nearer than kCoincident to the one
/// before does not count as a bend.
struct RouteFigures {
  double length_m = 0.0;
  std::map<std::string, double> length_by_kind_m;  ///< kind name -> metres
  double logged_length_m = 0.0;
  double length_ratio = 0.0;  ///< length / (area / W)
  /// Manoeuvres that change the course by at least kTurnDeg: a curve of however many waypoints is
  /// one, and so is a turn between lines that swings out first.
  std::size_t turns = 0;
  std::size_t sharp_turns = 0;     ///< of them, by at least kSharpTurnDeg
  double total_turning_deg = 0.0;  ///< sum of all changes of course
  /// Smallest radius of all bends, as bends.h defines it: 0 at a corner. Infinite for a straight
  /// route: bends wider than kStraightRadiusM come from rounding.
  double min_turn_radius_m = 0.0;
  std::size_t sharp_corners = 0;     ///< corners (bends.h) that cannot be sailed as drawn
  std::size_t self_crossings = 0;    ///< places, see mesh/path_meetings.h
  std::size_t shared_stretches = 0;  ///< places where the path runs along itself
  double shared_m = 0.0;             ///< metres sailed along earlier stretches
  double outside_water_m = 0.0;      ///< path outside the water or inside no-go
  double over_land_m = 0.0;          ///< of that, over known land or inside no-go
  double over_unknown_m = 0.0;       ///< of that, over ground that the data do not tell of
  /// Least depth below the path, less the draft. Infinite where it cannot be known: without any
  /// depth below the path, or where over_land_m or over_unknown_m is above 0.
  double min_under_keel_m = 0.0;
  /// Legs of which the water is known, at the tide of the time (coverage/water/leg_water.h).
  std::optional<LeastWater> least_water;
  std::map<int, double> under_keel_by_line_m;  ///< line number -> metres
  double duration_s = 0.0;                     ///< length over each leg's speed
  std::map<std::string, double> duration_by_kind_s;
  std::map<int, double> duration_by_line_s;  ///< line number -> seconds
  double contingency_s = 0.0;                ///< allowance: the vehicle's share of the duration
  std::optional<double> energy_wh;  ///< of the duration, where the vehicle's power is known
  bool beyond_endurance = false;    ///< duration and contingency exceed the vehicle's endurance
  double tight_turn_m = 0.0;        ///< path that bends tighter than the vehicle's turn radius
  std::size_t infeasible_legs = 0;  ///< legs that the planner marked
  double infeasible_m = 0.0;
  CrossFigures cross;  ///< its cross-lines
};

/// A bend counts as tight when its radius falls short of the vehicle's by more than this share.
/// The slack is for points that are rounded to millimetres.
inline constexpr double kTightShare = 0.01;
inline constexpr double kStraightRadiusM = 1e5;
inline constexpr double kTurnDeg = 30.0;
inline constexpr double kSharpTurnDeg = 90.0;
/// Bends to the same side (between lines: to any side) are one manoeuvre if they lie no farther
/// apart than this or than the turn's diameter, metres of path.
inline constexpr double kCurveGapM = 3.0;
/// The depth below the path is looked up at each waypoint and at least this often between, metres.
inline constexpr double kDepthStepM = 1.0;

/// `water`: where the boat may be (outline of the data deep enough, less no-go). `land`: known land
/// and no-go.
/// `footprint_width_m`: W, for the length ratio over `survey_area_m2`.
[[nodiscard]] RouteFigures route_figures(const Route& route, const Vehicle& vehicle,
                                         const Area& water, const DepthQuery& depths,
                                         double survey_area_m2, double footprint_width_m,
                                         const Area& land = {});

/// What to say of a mission that does not fit into the vehicle's endurance, contingency included.
/// One sentence without a full stop; empty if the mission fits.
[[nodiscard]] std::string endurance_note(const RouteFigures& figures, const Vehicle& vehicle);

/// What to say of a route with corners that cannot be sailed as drawn. One sentence without a full
/// stop; empty for a route without.
[[nodiscard]] std::string corners_note(const RouteFigures& figures, const Vehicle& vehicle);

/// Waypoints nearer than this are one place, metres.
inline constexpr double kCoincident = 1e-6;
/// Metres of a segment that rounding may put outside the water.
inline constexpr double kLengthDust = 1e-9;

}  // namespace swathplan
