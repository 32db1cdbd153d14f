#pragma once

#include <optional>
#include <string>
#include <vector>

#include "coverage/route/pings.h"
#include "coverage/route/route.h"
#include "coverage/route/sonar.h"
#include "coverage/route/vehicle.h"
#include "coverage/tracing/ray_scene.h"
#include "mesh/planar/depth_regions.h"
#include "mesh/planar/gates.h"
#include "mesh/planar/planar_mesh.h"
#include "mesh/plane/polygons.h"
#include "mesh/seafloor.h"
#include "planners/pareto.h"
#include "planners/smoothing/smooth.h"

namespace swathplan {

/// Hypotenuse of a mesh face as a share of W where none is given: of 0.85 to 1.2, the one that
/// brings the synthetic harbour at 0.10 m to 96.9 % at 3.4 ideal lengths; larger saves path and
/// coverage.
inline constexpr double kFaceSize = 0.93;
/// Side of a quad as a share of W where none is given: of 0.6 to 1.2, the one with the most
/// coverage for its path on saddle, shaft and harbour at 0.10 m. The path's spacing is half a side.
inline constexpr double kQuadSize = 0.75;

/// What every planner plans on. The seafloor and its query must outlive it.
struct PlanningGround {
  const Seafloor* seafloor = nullptr;
  const DepthQuery* depths = nullptr;
  Area survey_area;  ///< to be covered
  Area water;        ///< where the boat may be: deep enough, clear of walls and no-go
  /// For planners that try candidates on the simulator before they choose; without one they take
  /// their first candidate.
  const RayScene* scene = nullptr;
};

/// How the fan opens along the way.
enum class Opening {
  region,  ///< one opening angle per depth region (or one for the whole route)
  ping     ///< from the depth below the boat
};

/// What the planning mesh is made of.
enum class FaceShape {
  triangle,  ///< near right isosceles
  quad       ///< right-angled, what the outline leaves of them along the boundary
};

/// Where fitted lines come from.
enum class LineSource {
  straight,  ///< parallel, spaced by the depth
  field,     ///< level sets of a front that advances one swath at a time
  automatic  ///< the simulator picks
};

struct PlanOptions {
  Sonar sonar;
  Vehicle vehicle;
  double resolution_m = 0.10;
  FaceShape faces = FaceShape::triangle;  ///< of the mesh that NUC and MDNUC walk
  /// Hypotenuse of a triangle or side of a quad as a share of W, > 0. Empty: kFaceSize or
  /// kQuadSize, and where the area holds few faces the best of several meshes (mesh_choice.h).
  std::optional<double> face_size;
  double ping_spacing_m = 0.10;  ///< that candidates are judged with, > 0
  TrackNoise noise;              ///< that candidates are judged with
  int threads = 0;               ///< 0: all cores; no result depends on it
  DepthBands bands;
  /// Regions under this join a neighbour, m^2; empty: 0.3 of a hypotenuse squared, a little over a
  /// regular triangle; of quads 0.3 of a side squared.
  std::optional<double> smallest_region_m2;
  Opening opening = Opening::region;
  /// Joins between lines, and the skeleton of NUC and MDNUC, are smoothed; empty: arcs.
  std::optional<SmoothOptions> smooth;
  double run_in_m = 0.0;   ///< sailed straight before each line, not logged; < 0 shortens the line
  double run_out_m = 0.0;  ///< and behind it
  std::optional<Vec2> start;     ///< begin as near to this as the planner can
  std::optional<Angle> heading;  ///< azimuth of straight lines; empty: the planner's choice
  LineSource lines = LineSource::automatic;  ///< of fitted lines
  PlanGoal goal;                             ///< of fitted lines
  /// What fitted and edge-following lines are laid for and judged by. Footprints meet out to the
  /// sonar's largest opening, so lines for them lie farther apart than lines for hits.
  Cover cover = Cover::hit;
  /// Fitted and edge-following lines count on no more of either side of a swath than this leaves of
  /// it, [0, kMostMargin]: neighbours overlap by that share of W, and plans are judged by the rest.
  double lines_margin = 0.0;
};

/// A route and the evidence of how it came about.
struct Plan {
  Route route;
  PlanarMesh mesh;  ///< empty for planners without one
  std::vector<SharedEdge> edges;
  DepthRegions regions;  ///< empty without
  Gates gates;
  std::vector<Angle> openings;     ///< full opening angle per region, or one
  std::vector<std::string> notes;  ///< one sentence each, for people
  /// Fitted lines: the plans that no other beats (pareto.h), shortest first, and
  /// which of them the route is. Empty for other planners.
  std::vector<Outcome> choices;
  std::size_t chosen = 0;
  std::string chosen_why;  ///< half a sentence
};

inline constexpr double kMostMargin = 0.4;
/// Of either side of a swath, from nadir out, what lines count on: 1 - lines_margin.
[[nodiscard]] double counted_share(const PlanOptions& options);

/// W = beams x resolution, metres.
[[nodiscard]] double footprint_width_m(const PlanOptions& options);

/// The part of the survey area that the boat may sail in: lines and meshes are laid in it.
/// @throws InvalidInput if there is none.
[[nodiscard]] Area reachable_area(const PlanningGround& ground);

/// @throws UsageError that names the option, its value and the rule.
void check(const PlanOptions& options);

/// Hypotenuse of the mesh's triangles or side of its quads, metres, unless a planner looks for a
/// better one.
[[nodiscard]] double face_size_m(const PlanOptions& options);
/// Depth regions under this join a neighbour, square metres.
[[nodiscard]] double smallest_region_m2(const PlanOptions& options);

/// `area` in faces of the options' shape, `size_m` large, their lattice turned by `turn` against
/// the area's main direction.
[[nodiscard]] PlanarMesh mesh_of(const Area& area, const PlanOptions& options, double size_m,
                                 Angle turn = {});

/// The mesh that planners walk unless they look for a better one: the reachable area in faces of
/// face_size_m().
[[nodiscard]] PlanarMesh planning_mesh(const PlanningGround& ground, const PlanOptions& options);

/// Depth regions of the planning mesh with the options' bands and sliver size.
[[nodiscard]] DepthRegions planning_regions(const PlanarMesh& mesh,
                                            const std::vector<SharedEdge>& edges,
                                            const PlanningGround& ground,
                                            const PlanOptions& options);

/// Plan-area-weighted mean depth of the survey area's seafloor, metres.
[[nodiscard]] double mean_depth_m(const DepthRegions& regions);

/// Symmetric fan that sweeps W at `depth_m`: 2 atan(W/2 / depth below the sonar) in all, capped by
/// the sonar. The sonar hangs at the draft; measured from the water line the fan would fall short.
[[nodiscard]] FanAngles fan_for_depth(const PlanOptions& options, double depth_m);

/// Opens the fan anew each `step_m` of path from the depth below, so that it sweeps W everywhere.
[[nodiscard]] Route opened_per_ping(const Route& route, const PlanningGround& ground,
                                    const PlanOptions& options, double step_m = 1.0);

}  // namespace swathplan
