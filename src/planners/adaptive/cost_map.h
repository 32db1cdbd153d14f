#pragma once

#include "coverage/side_scan.h"
#include "planners/adaptive/accordion.h"

namespace swathplan {

/// How a side-scan image becomes a cost map.
struct CostMapOptions {
  double window_m = 1.5;      ///< side of the square over which intensity is compared, > 0
  double smallest_m2 = 0.15;  ///< smallest patch above the threshold that counts, >= 0
  double threshold = 0.5;     ///< the accordion's, by which such patches are found, > 0
  double row_m = 5.0;         ///< along-track length of a row of the cost map, > 0
};

/// Makes cost maps of both sides from a side-scan image. First each side is levelled to the mean
/// return of its range, so that range and grazing angle leave no trend. Then the local variation of
/// the intensity is taken: standard deviation over mean in a window (OpenCV box filters). Facets,
/// ripples and speckle vary everywhere, so a cost compares the variation with its surroundings (12
/// m around): 0 is no more than usual, 1 is five times as much. Patches too small for an object are
/// wiped out. A row of the cost map holds the largest cost of the pixels in it. Columns are the
/// image's across-track pixels; those without data cost 0. `back` is the side that looks back, see
/// port_looks_back(). The image's nadir gap is blind until fill_nadir() looks into it.
/// @throws InvalidInput if the image has no pixels or its sizes do not fit.
[[nodiscard]] AccordionObservation cost_maps(const SideScanImage& image, bool port_looks_back,
                                             const CostMapOptions& options);

/// Fills the nadir gap of the cost maps from a multibeam sonar's heights. The cost is the height
/// above the bottom's local mean; 0.35 m cost 1. Where a map has a larger cost, it stays. The maps
/// are blind no longer as far as the heights reach.
/// @throws InvalidInput if the heights have no even number of columns, other sizes than they say,
/// or another number of rows than the track's cost maps stand for.
void fill_nadir(AccordionObservation& observation, const NadirHeights& heights,
                bool port_looks_back, const CostMapOptions& options);

/// The cost map of one side before pixels are gathered into rows: the size of the image.
[[nodiscard]] std::vector<float> pixel_costs(const SideScanImage& image, bool port,
                                             const CostMapOptions& options);

}  // namespace swathplan
