#pragma once

#include <filesystem>
#include <vector>

#include "io/seafloor/import_seafloor.h"

namespace swathplan {

/// Which file counts where several have data.
enum class MosaicPriority {
  finest,  ///< that with the least distance between its nodes
  newest,  ///< that with the latest date (file_date.h)
  order    ///< that which is named first
};

/// Reads several files of one seafloor, all by the same options (a CRS is that of the files that do
/// not say theirs), and joins them as zipped() does:
/// where two overlap, the one of higher priority counts. The result is in the frame of the first.
/// Notes say how much of the ground is from each, and how far the surfaces differ at the seams.
/// @throws InvalidInput as import_seafloor() does; if some files have a CRS and others none; or,
/// for
///   `newest`, if a file has no date.
[[nodiscard]] ImportedSeafloor import_mosaic(const std::vector<std::filesystem::path>& files,
                                             MosaicPriority priority, const ImportOptions& options);

}  // namespace swathplan
