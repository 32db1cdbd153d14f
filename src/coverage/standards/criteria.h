#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace swathplan {

/// Limits of the uncertainty of a sounding at 95 %, down to a depth.
struct UncertaintyLimit {
  double to_depth_m;        ///< the last row: infinite
  double a_m, b;            ///< TVU: sqrt(a^2 + (b depth)^2)
  double thu_m, thu_share;  ///< THU: thu_m + thu_share x depth
};

/// Side of a cell, down to a depth.
struct CellRange {
  double to_depth_m;  ///< the last row: infinite
  double cell_m;
};

/// Cubes that a survey must find.
struct FeatureRule {
  double cube_m;            ///< side, down to shoal_m
  double shoal_m;           ///< infinite: at any depth
  double share_of_depth;    ///< side beyond that
  int pings, beams;         ///< wanted on each cube, along and across
  std::string_view source;  ///< of these two numbers
};

/// Soundings wanted in a share of the cells that hold any.
struct DensityRule {
  int soundings;
  double share_pct;
};

/// What counts as a gap in the coverage.
enum class GapRule {
  box,    ///< `gap_cells` x `gap_cells` empty cells
  row,    ///< `gap_cells` empty cells beside one another in a row or column
  spread  ///< ground farther from a sounding than soundings may lie apart
};

/// A standard that a survey is judged by, one row of data.
struct Criterion {
  std::string_view name;   ///< "s44-special"
  std::string_view title;  ///< "IHO S-44 Special Order"
  std::string_view source;
  std::vector<UncertaintyLimit> limits;  ///< by depth
  double within_pct;                     ///< of cells with soundings, that hold one within limits
  std::vector<CellRange> cells;          ///< by depth
  std::string_view cells_source;
  std::optional<FeatureRule> features;
  double coverage_pct;             ///< bathymetric coverage; 200: every place by two lines
  double search_pct;               ///< feature search; 0: none
  std::string_view coverage_text;  ///< what is asked, in the words of the standard
  GapRule gap;
  int gap_cells;
  std::optional<DensityRule> density;
};

[[nodiscard]] const std::vector<Criterion>& criteria();
/// @throws UsageError for a name that is none, with all names.
[[nodiscard]] const Criterion& criterion(std::string_view name);

[[nodiscard]] double tvu_limit_m(const Criterion& criterion, double depth_m);
[[nodiscard]] double thu_limit_m(const Criterion& criterion, double depth_m);
/// Side of the criterion's cell at a depth.
[[nodiscard]] double cell_m(const Criterion& criterion, double depth_m);
/// Side of the cube that must be found at a depth; empty where none is asked for.
[[nodiscard]] std::optional<double> feature_m(const Criterion& criterion, double depth_m);
/// Lines that must see each place: 2 where 200 % is asked.
[[nodiscard]] int lines_asked(const Criterion& criterion);
/// Share of the ground that a line, or two, must see, per cent, at most 100.
[[nodiscard]] double share_asked_pct(const Criterion& criterion);

}  // namespace swathplan
