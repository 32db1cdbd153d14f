#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "planners/fronts/swept_lines.h"

namespace swathplan {

/// Writes survey lines over the depths they are fitted to, as a picture for people. Deeper water is
/// darker. Ground that no line sweeps is red. The depth range and a scale bar stand below. North is
/// up. `title` stands above in one line or two (ASCII; other characters become '?').
/// @throws InvalidInput if the file cannot be written.
void write_lines_png(const std::filesystem::path& path, const SweptGround& ground,
                     const std::vector<SweptLine>& lines, const std::string& title);
inline constexpr int kLinesPictureSide = 1100;  ///< pixels, larger side of the map itself

}  // namespace swathplan
