#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace swathplan {

/// One '<hazards>' as it was typed: FILE, FILE:LAYER, FILE:LAYER=BUFFER, FILE=BUFFER, LAYER=BUFFER.
struct HazardChoice {
  std::filesystem::path file;      ///< empty: the chart that is the seafloor
  std::string layer;               ///< empty: all that the file holds
  std::optional<double> buffer_m;  ///< empty: from the stated accuracy
  bool off = false;                ///< BUFFER is 'off': the layer is not kept off
};

/// What is kept off: choices, and where they begin from.
struct HazardChoices {
  std::vector<HazardChoice> list;
  bool unasked = true;  ///< a chart that is the seafloor brings its hazards; 'none' says no
};

/// Reads the texts. What stands before a colon is a file if it exists, or if no other reading is
/// left.
/// @throws UsageError for a buffer that is no number of 0 or more, and for files that do not exist.
[[nodiscard]] HazardChoices parse_hazards(const std::vector<std::string>& texts);

}  // namespace swathplan
