#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "coverage/water/tide.h"

namespace swathplan {

/// A tide as it was read: heights above chart datum.
struct ImportedTide {
  Tide tide;
  std::vector<std::string> notes;  ///< one sentence each, for people
};

/// Reads a table of times and heights (CSV with commas, semicolons or tabs, with a header or
/// without): the first column, or one that is called time or date, holds times (times.h); the next
/// one, or one called height, level, water or tide, holds metres. Rows that begin with # are left
/// out. @throws InvalidInput that names the row for a time or height that cannot be read, for times
/// that do not ascend, and for a gap: rows kWidestGap times as far apart as most.
[[nodiscard]] ImportedTide import_tide(const std::filesystem::path& path);

inline constexpr double kWidestGap = 2.5;

}  // namespace swathplan
