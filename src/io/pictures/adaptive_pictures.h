#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "coverage/side_scan.h"
#include "planners/adaptive/survey_track.h"

namespace swathplan {

/// A curve of a chart.
struct ChartCurve {
  std::string label;  ///< empty: in the colour of the curve before it, not in the legend
  std::vector<double> x, y;
  bool dashed = false;
};
struct Chart {
  std::string title, x_label, y_label;
  std::vector<ChartCurve> curves;
};
/// Draws a line chart as a small PNG. The axes fit the data. Texts are ASCII; other characters
/// become '?'.
/// @throws InvalidInput if the file cannot be written.
void write_chart_png(const std::filesystem::path& path, const Chart& chart);

/// Tracks over their box, in true proportions, with axes in metres. A box that is longer than wide
/// lies on its side. Colours from dark to light show the order of sailing.
struct TrackPicture {
  std::string title;
  double width_m = 0.0, length_m = 0.0;
  std::vector<SurveyTrack> tracks;
  std::vector<double> shade;  ///< columns from across 0 to width, each in [0, 1]; empty: none
  std::string shade_label;
  std::vector<Vec2> objects;  ///< across, along
};
/// Pictures below each other in one PNG. @throws InvalidInput if the file cannot be written.
void write_tracks_png(const std::filesystem::path& path, const std::vector<TrackPicture>& pictures);

/// The waterfall of one track: first ping at the bottom, port left, starboard right.
/// @throws InvalidInput if the file cannot be written.
void write_waterfall_png(const std::filesystem::path& path, const SideScanImage& image);

/// Reads such a waterfall (8-bit grey, an even number of columns). Intensities come back rounded
/// to 8 bits.
/// @throws InvalidInput if the file cannot be read or has an odd width.
[[nodiscard]] SideScanImage read_waterfall_png(const std::filesystem::path& path, double pixel_m,
                                               double row_m, double nadir_gap_m);

}  // namespace swathplan
