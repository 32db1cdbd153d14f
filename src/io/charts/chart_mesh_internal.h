#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "mesh/base/frame.h"

namespace swathplan {

/// A depth area of a chart: its depths lie between two bounds, metres, positive down.
struct DepthArea {
  std::vector<std::vector<std::uint32_t>> rings;  ///< places, without the first one repeated
  double shoal_m = 0.0;
  double deep_m = std::numeric_limits<double>::infinity();
};

/// What a chart tells of depths. Places are shared, so that neighbouring areas meet.
struct ChartDepths {
  std::vector<Vec2> places;                      ///< metres
  std::vector<std::optional<double>> soundings;  ///< of the places, metres, positive down
  std::vector<std::optional<double>> contours;
  std::vector<DepthArea> areas;
};

/// The surface between them, z positive down.
struct ChartMesh {
  std::vector<Vec2> places;  ///< those of ChartDepths, then new ones
  std::vector<double> depths;
  std::vector<std::array<std::uint32_t, 3>> faces;  ///< counter-clockwise
  std::size_t used_soundings = 0;                   ///< within a depth area
  std::size_t areas_without_soundings = 0;
};

/// Triangulates depth areas, soundings and contours (constrained Delaunay: no triangle crosses the
/// outline of an area). A place has the depth of its sounding, else that of its contour, else, on
/// the outline of areas, the deepest of their shoal bounds, but nothing deeper than one of them
/// allows. A triangle in an area without soundings whose corners all lie at its deep bound takes
/// the shoal bound at its middle: what the chart leaves open is taken as shoal. O(n log n).
[[nodiscard]] ChartMesh chart_mesh(const ChartDepths& chart);

}  // namespace swathplan
