#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "coverage/tracing/coverage_grid.h"

namespace swathplan {

/// Writes the coverage as a picture for people, with a legend and a scale bar. Covered cells are
/// blue: the darker, the more soundings. Cells without a sounding are red; with `logged_counts`,
/// those that no logged ping sounded. Land and the outside are blank. A grid larger than
/// kPictureSide is drawn smaller. A pixel then shows the share of its cells that are empty, so that
/// no holiday vanishes. `title` stands above (ASCII; other characters become '?').
/// @throws InvalidInput if the file cannot be written.
void write_coverage_png(const std::filesystem::path& path, const CoverageGrid& grid,
                        const std::string& title, bool logged_counts = false);
inline constexpr std::uint32_t kPictureSide = 2200;  ///< pixels, largest side of the map itself

}  // namespace swathplan
