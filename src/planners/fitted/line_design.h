#pragma once

#include <optional>
#include <string>

#include "mesh/base/watch.h"
#include "planners/fronts/swept_lines.h"

namespace swathplan {

enum class LineMethod {
  back_and_forth,  ///< straight, evenly spaced along the area's long side
  straight,        ///< straight, closer where W is less
  field,           ///< level sets of fronts, with closing passes where fronts meet
  edge_following,  ///< each along the edge of the swath before it
  automatic        ///< the shortest of straight and field lines
};

struct LineDesignOptions {
  LineMethod method = LineMethod::automatic;
  double overlap = 0.0;       ///< share of a swath that overlaps the next one, [0, 0.4]
  double most_missed = 5e-4;  ///< share of the area, (0, 1)
  /// Of straight lines in the frame, as its grid counts it; empty: searched.
  std::optional<Angle> heading = {};
  Angle grid_north = {};  ///< true azimuth of the frame's north, for what is said of azimuths
  Watch watch = {};       ///< if it ends the search, the best lines tried so far are taken
};

/// A seafloor with cells of one size, and the swaths of one opening angle over it.
struct DesignGround {
  /// `opening`: full fan, (0, 180) degrees; the sonar hangs at `draft_m`.
  DesignGround(const Ground& planning, Angle opening, double draft_m, double most_cells);
  DesignGround(const DesignGround&) = delete;
  DesignGround& operator=(const DesignGround&) = delete;

  WaterRaster raster;
  std::vector<float> width;
  SweptGround swaths;
};
inline constexpr double kSearchCells = 4e5, kJudgeCells = 1.6e6;

/// @throws UsageError that names the option, its value and the rule.
void check(const LineDesignOptions& options);

struct DesignedLines {
  std::vector<SweptLine> lines;
  LinesFigures figures;
  std::size_t passes = 0;    ///< how many of the lines are short ones that close gaps
  std::string what;          ///< how the lines were made, for people
  bool ended_early = false;  ///< the watch ended the search
};

/// The shortest lines found that miss no more than `most_missed` of the survey area. Turns do not
/// count, so it is for open water, where turns are few. Swaths are estimated without rays.
/// Candidates are compared on `search`. The best ones are laid anew and judged on `judge`, whose
/// cells are smaller. Lines may run on beyond the survey area, where that sweeps more of it. If the
/// method finds no lines that miss so little, those that miss least are returned.
/// @throws UsageError for options out of range; InvalidInput where no line fits.
[[nodiscard]] DesignedLines design_lines(const Ground& planning, const DesignGround& search,
                                         const DesignGround& judge,
                                         const LineDesignOptions& options);

/// The lines in an order that keeps the ways between them short (line_order.h), joined by transits
/// with the sonar off. A transit is straight, or leads around what is no safe water (water_path.h).
/// It is infeasible if no way leads to the next line. Corners are sharp: nothing is steered.
[[nodiscard]] Route route_of(const DesignedLines& designed, const Area& water, Angle opening,
                             const Vehicle& vehicle);

}  // namespace swathplan
