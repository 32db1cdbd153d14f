#pragma once

#include <optional>
#include <string>
#include <vector>

#include "coverage/ground.h"
#include "coverage/route/pings.h"
#include "coverage/route/route.h"
#include "coverage/route/sonar.h"
#include "coverage/route/vehicle.h"
#include "mesh/base/watch.h"
#include "mesh/planar/depth_regions.h"
#include "mesh/planar/gates.h"
#include "mesh/planar/planar_mesh.h"
#include "mesh/plane/polygons.h"
#include "planners/pareto.h"
#include "planners/smoothing/smooth.h"

namespace swathplan {

struct Criterion;
class UncertaintyModel;

/// Hypotenuse of a mesh face as a share of W where none is given. Of the shares 0.85 to 1.2 this
/// one brings the synthetic harbour at 0.10 m to 96.9 % at 3.4 ideal lengths. With larger faces
/// path and coverage are both less.
inline constexpr double kFaceSize = 0.93;
/// Side of a quad as a share of W where none is given. Of the shares 0.6 to 1.2 this one has the
/// most coverage for its path on saddle, shaft and harbour at 0.10 m. Passes lie half a side apart.
inline constexpr double kQuadSize = 0.75;

/// How the fan opens along the way.
enum class Opening {
  region,  ///< one opening angle per depth region (or one for the whole route)
  ping     ///< from the depth below the boat
};

/// What the planning mesh is made of.
enum class FaceShape {
  triangle,  ///< near right isosceles
  quad       ///< rectangles, cut off where they meet the outline
};

/// Where fitted lines come from.
enum class LineSource {
  straight,  ///< parallel, spaced by the depth
  field,     ///< level sets of a front that advances one swath at a time
  automatic  ///< the simulator picks
};

/// Which soundings plans are judged by.
enum class Counted {
  all,    ///< of every ping, those of turns too
  logged  ///< of logged legs
};

/// How long a pair of half-angles holds.
enum class Angles {
  ping,  ///< from one waypoint to the next
  line   ///< the whole line; in whole degrees
};

/// What a line's swath is, where lines are laid by it.
enum class SwathBy {
  footprint,  ///< W, as in the papers
  fan         ///< what the fan sweeps at the depth below
};

/// The depth that stands for a block of lines.
struct BlockDepth {
  bool mean = false;
  double share = 0.0;  ///< else: of the block's area that is shoaler, [0, 1); 0: the shoalest
};

/// How far apart the rows of back-and-forth and multi-depth lie.
struct RowSpacing {
  SwathBy swath_by = SwathBy::footprint;  ///< footprint: they lie W apart
  std::optional<double> spacing_m = {};   ///< > 0; empty: by the block's depth, fan and overlap
  double overlap = 0.1;                   ///< share of a swath that its neighbour repeats, [0, 1)
  BlockDepth depth = {};
};

struct PlanOptions {
  Sonar sonar;
  Vehicle vehicle;
  double resolution_m = 0.10;
  FaceShape faces = FaceShape::triangle;  ///< of the mesh that NUC and MDNUC walk
  /// Hypotenuse of a triangle or side of a quad as a share of a lane, > 0. Empty: kFaceSize or
  /// kQuadSize, and where the area holds few faces the best of several meshes (mesh_choice.h).
  std::optional<double> face_size;
  PingTiming pings;  ///< for judging candidates
  TrackNoise noise;  ///< for judging candidates
  int threads = 0;   ///< 0: all cores; no result depends on it
  DepthBands bands;
  /// A region smaller than this joins a neighbour, m^2. Empty: 0.3 of a hypotenuse squared, a
  /// little more than a regular triangle; with quads 0.3 of a side squared.
  std::optional<double> smallest_region_m2;
  Opening opening = Opening::region;
  /// The full fan of every line, in (0, the sonar's largest]. Empty: it follows from the depth.
  std::optional<Angle> opening_angle;
  RowSpacing rows;
  /// How far apart neighbouring lines lie by and large: what meshes, turns and joins are sized by.
  /// Empty: W, as in the papers.
  std::optional<double> lane_width_m;
  /// How joins between lines, and the skeleton of NUC and MDNUC, are smoothed. Empty: plain arcs.
  std::optional<SmoothOptions> smooth;
  double run_in_m = 0.0;   ///< sailed straight before each line, not logged; < 0 shortens the line
  double run_out_m = 0.0;  ///< the same behind each line
  std::optional<Vec2> start;  ///< begin as near to this as the planner can
  /// Azimuth of straight lines in the frame, as its grid counts it; empty: the planner's choice.
  std::optional<Angle> heading;
  Angle grid_north;  ///< true azimuth of the frame's north, for what is said of azimuths
  LineSource lines = LineSource::automatic;  ///< of fitted lines
  PlanGoal goal;                             ///< of fitted lines
  /// What fitted and edge-following lines are laid for and judged by. Footprints meet out to the
  /// sonar's largest opening, so lines for them lie farther apart than lines for hits.
  Cover cover = Cover::hit;
  /// The outer share of either side of a swath that fitted and edge-following lines do not count
  /// on, [0, kMostMargin]. Neighbours overlap by this share of W. Plans are judged by the rest.
  double lines_margin = 0.0;
  Counted counted = Counted::all;
  Angles angles = Angles::ping;
  double least_line_m = 0.0;     ///< no line or infill pass is shorter
  double least_speed_mps = 0.5;  ///< lines are sailed no slower, (0, the vehicle's speed]
  double soundings = 1.0;        ///< wanted a cell, >= 1
  /// Told how the search gets on. If it ends the search, the best plan finished by then is kept,
  /// and a note says so. A planner goes on until it has one.
  Watch watch = {};
  /// Where logged lines count: swaths are as wide as this criterion lets them be (criterion_fan.h),
  /// half as wide where each place must be seen by two lines. Both or neither.
  const Criterion* criterion = nullptr;
  const UncertaintyModel* uncertainty = nullptr;
};

/// The shortest line that is worth its turns: the larger of 20 m and four turn radii.
[[nodiscard]] double practical_least_line_m(const Vehicle& vehicle);

/// A route, and what it was made from.
struct Plan {
  Route route;
  PlanarMesh mesh;  ///< empty for planners without one
  std::vector<SharedEdge> edges;
  DepthRegions regions;  ///< empty without
  Gates gates;
  std::optional<Angle> heading;    ///< of its straight lines in the frame, where all share one
  std::vector<Angle> openings;     ///< full opening angle per region, or one
  std::vector<std::string> notes;  ///< one sentence each, for people
  /// Of fitted lines: the plans that no other beats (pareto.h), shortest first. The route is the
  /// one at `chosen`. Empty for other planners.
  std::vector<Outcome> choices;
  std::size_t chosen = 0;
  std::string chosen_why;  ///< why, as half a sentence
};

inline constexpr double kMostMargin = 0.4;
/// The share of either side of a swath, from nadir outwards, that lines count on: 1 - lines_margin.
[[nodiscard]] double counted_share(const PlanOptions& options);

/// W = beams x resolution, metres.
[[nodiscard]] double footprint_width_m(const PlanOptions& options);

/// The options' lane width, metres; W where they give none.
[[nodiscard]] double lane_m(const PlanOptions& options);

/// Metres between pings at survey speed over level ground `depth_m` deep, with the fan of
/// fan_for_depth.
[[nodiscard]] double ping_spacing_m(const PlanOptions& options, double depth_m);

/// The part of the survey area that the boat may sail in: lines and meshes are laid in it.
/// @throws InvalidInput if there is none.
[[nodiscard]] Area reachable_area(const Ground& ground);

/// @throws UsageError that names the option, its value and the rule.
void check(const PlanOptions& options);

/// Hypotenuse of the mesh's triangles or side of its quads, metres. A planner may look for a better
/// one.
[[nodiscard]] double face_size_m(const PlanOptions& options);
/// Depth regions under this join a neighbour, square metres.
[[nodiscard]] double smallest_region_m2(const PlanOptions& options);

/// `area` in faces of the options' shape, `size_m` large, their lattice turned by `turn` against
/// the area's main direction.
[[nodiscard]] PlanarMesh mesh_of(const Area& area, const PlanOptions& options, double size_m,
                                 Angle turn = {});

/// The plain mesh of the reachable area, in faces of face_size_m(). A planner may look for a better
/// one.
[[nodiscard]] PlanarMesh planning_mesh(const Ground& ground, const PlanOptions& options);

/// Depth regions of the planning mesh with the options' bands and sliver size.
[[nodiscard]] DepthRegions planning_regions(const PlanarMesh& mesh,
                                            const std::vector<SharedEdge>& edges,
                                            const Ground& ground, const PlanOptions& options);

/// Plan-area-weighted mean depth of the survey area's seafloor, metres.
[[nodiscard]] double mean_depth_m(const DepthRegions& regions);

/// The symmetric fan that sweeps a lane (W in the papers) at `depth_m`: its full angle is
/// 2 atan(W/2 / depth below the sonar), capped by the sonar; or `opening_angle`. The sonar hangs at
/// the draft, so the depth below it is less than `depth_m`, and the fan must open wider.
[[nodiscard]] FanAngles fan_for_depth(const PlanOptions& options, double depth_m);

/// Opens the fan anew each `step_m` of path from the depth below, so that it sweeps a lane
/// everywhere. `lanes_m`: that of each region, where they differ from the options'; a way between
/// regions keeps the lane of the region before.
[[nodiscard]] Route opened_per_ping(const Route& route, const Ground& ground,
                                    const PlanOptions& options,
                                    const std::vector<double>& lanes_m = {}, double step_m = 1.0);

}  // namespace swathplan
