#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include "coverage/ground.h"
#include "coverage/holidays.h"
#include "coverage/route/pings.h"
#include "coverage/route/route_figures.h"
#include "coverage/route/sonar.h"
#include "coverage/tracing/coverage_grid.h"

namespace swathplan {

struct ScoreOptions {
  double resolution_m = 0.10;
  PingTiming pings;
  double holiday_m2 = 0.0;  ///< list holidays of at least this
  /// The coverage that counts is that of logged legs: holidays are the gaps of it.
  bool logged_counts = false;
  std::size_t outline_corners = 0;  ///< of holidays, see HolidayOptions
  /// Not read by `score`: callers that build the scene from these options build it with this.
  Nodata nodata = Nodata::wall;
  TrackNoise noise;
  bool footprint = true;  ///< also score beam footprints
  /// The share of each side of a swath, from nadir out, that counts, (0, 1]. Beams beyond it are
  /// not traced. Under 1 the score tells what is left if drift or a wrong map costs the outer part.
  double swath_share = 1.0;
  int threads = 0;  ///< 0: all cores; the result does not depend on it
  /// Called now and then with the share done [0, 1] and rays traced so far; may be empty.
  std::function<void(double, std::uint64_t)> progress;
  /// Called with the cells that soundings of logged legs fell in, some of a leg at a time, leg
  /// after leg and by one thread: a cell as often as it was sounded, cells outside the area too.
  /// The leg is an index into legs(route). May be empty.
  std::function<void(std::uint32_t leg, std::span<const std::uint32_t> cells)> logged_cells;
};

/// Coverage counted over one set of pings (all, or those of logged legs).
struct CoverageFigures {
  double hit_pct = 0.0;  ///< cells with at least one sounding
  double hit_2_pct = 0.0, hit_5_pct = 0.0;
  std::optional<double> footprint_pct;  ///< cells whose centre lies in a beam's footprint; empty
                                        ///< where footprints are not scored
};

/// Coverage of a survey area of which a part was surveyed before. A cell counts as covered if it
/// was so before, or if the earlier soundings and the route's are together as many as were wanted.
struct WholeFigures {
  std::uint64_t cells = 0;  ///< of the whole area
  double area_m2 = 0.0;
  double before_pct = 0.0;                 ///< covered before
  double all_pct = 0.0, logged_pct = 0.0;  ///< covered with the route: by all pings, by logged ones
  double left_out_m2 = 0.0;  ///< gaps of the earlier survey that are no part of the rest
};

/// What plans of a site are to cover, and what this one does.
struct CoverageGoal {
  double wanted_pct = 100.0;  ///< of the cells
  double covered_pct = 0.0;   ///< cells with as many soundings that count as are wanted
};

/// What a route covers. `logged` counts the pings of logged legs only. Overlap, several_legs_pct,
/// and the counts are of all pings.
struct Score {
  CoverageFigures all, logged;
  double overlap = 0.0;                              ///< mean soundings per covered cell, less 1
  double several_legs_pct = 0.0;                     ///< cells seen by two or more different legs
  std::uint64_t cells = 0;                           ///< of the grid that lie in the survey area
  std::uint64_t pings = 0, rays = 0, soundings = 0;  ///< soundings: hits inside the area
  PingFigures pinging;
  double survey_area_m2 = 0.0;
  double footprint_width_m = 0.0;  ///< W
  RouteFigures route;
  /// Hours that no plan of the area can go under (standards/area_rate.h). score() leaves it empty:
  /// who scores several routes of a site works it out once.
  std::optional<double> least_hours;
  /// score() leaves it empty: who scores several routes of a site fills it in.
  std::optional<CoverageGoal> goal;
  /// Of the whole area, where the score is of the rest that was not covered before. score() leaves
  /// it empty: who knows of earlier surveys fills it in (coverage/covered).
  std::optional<WholeFigures> whole;
  bool logged_counts = false;  ///< as the options said
  Holidays holidays;           ///< of logged pings where these count, else of all

  /// What counts: `logged` or `all`.
  [[nodiscard]] const CoverageFigures& counted() const { return logged_counts ? logged : all; }
};

struct ScoredRoute {
  Score score;
  CoverageGrid grid;
};

/// Traces every beam of every ping of the route against the ground's scene, and counts. The scene
/// must be there. A sounding counts in the cell that it falls in, as far as the sonar's range and
/// coverage curve reach.
/// Stretches of the route beyond the sonar's range of all data give no pings (beyond_data_m).
/// The footprint of a beam is a rectangle about its sounding, along and across the course.
/// Along, its length is 2 range tan(beam width / 2). Across, it reaches to either side by
/// range x stretch x half of the beam width or of the angle to the neighbouring beam, whichever is
/// more. `stretch` is n_z / |n . d|: how much the slope widens the beam, at most 5.76 (80 degrees
/// of incidence). Rectangles of neighbouring soundings that overlap meet half-way between the
/// soundings, or as far as both reach. So missing beams, shadows and jumps in range are not
/// bridged. A beam that climbs a wall, straight above the one before, adds no footprint.
/// Guarantees: (1) the same result for any number of threads: by the clock each ping depends on the
/// one before, so one thread alone follows the chain of pings, while the others count what it
/// traced before; (2) memory is 4 bytes a cell, plus a fixed number of pings in flight.
/// @throws InvalidInput for a route that is not valid; UsageError for an option out of range.
[[nodiscard]] ScoredRoute score(const Route& route, const Ground& ground, const Sonar& sonar,
                                const Vehicle& vehicle, const ScoreOptions& options);

}  // namespace swathplan
