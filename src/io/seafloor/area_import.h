#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mesh/plane/polygons.h"

namespace swathplan {

/// On which side an area with fewer corners than the file's may differ from it.
enum class Rounding {
  within,  ///< lies in the file's area
  around   ///< contains the file's area
};

struct AreaImportOptions {
  std::optional<Box2> data_extent = {};  ///< of the seafloor, local metres; the area must meet it
  /// Everything within this distance of a line or a point counts, metres. 0: they do not count.
  double buffer_m = 0.0;
  /// Names of layers. If several layers of a file hold something, one of them must be among these.
  std::vector<std::string> layers = {};
  /// A polygon of more than kManyCorners is replaced by one whose outline lies within this of its
  /// own, metres. 0: every corner counts, whatever it costs.
  double tolerance_m = 0.0;
  /// Where that leaves more than kFewEnough corners, the tolerance is doubled up to this, metres.
  double most_tolerance_m = 0.0;
  Rounding rounding = Rounding::within;
};

/// Outlines of up to this many corners are taken as they are.
inline constexpr std::size_t kManyCorners = 1000;
/// What is simplified should have no more corners than this.
inline constexpr std::size_t kFewEnough = 3000;

/// A polygon as the file names it; without a name it is empty.
struct AreaPart {
  std::string name;
  Area area;  ///< local metres
};

/// Polygons of a file, united, and what of the file is not in them.
struct ImportedArea {
  Area area;                       ///< local metres
  std::vector<AreaPart> parts;     ///< one by one
  std::vector<std::string> notes;  ///< one sentence each, for people
};

/// Reads all polygons of a vector file (GeoJSON, GeoPackage, Shapefile, KML, ...) in any CRS and
/// unites them, in the local metres of `frame`. A file without a CRS is taken to be in that of the
/// seafloor. If the seafloor has no CRS, every file is taken to be in its coordinates.
/// The notes name what does not count: lines and points without a buffer, and polygons that lie off
/// the data. They also name the tolerance if polygons were simplified.
/// @throws InvalidInput if the file cannot be read, has several layers and none is chosen, holds
///   nothing that counts, a polygon crosses itself, or if none of it meets the data.
[[nodiscard]] ImportedArea import_area(const std::filesystem::path& path, const Frame& frame,
                                       const AreaImportOptions& options = {});

/// What a vector file holds, as it is; local metres.
struct ImportedShapes {
  std::vector<std::vector<Vec2>> lines;  ///< of at least two places each
  std::vector<Vec2> points;
  Area polygons;
};

/// Reads lines, points and polygons of such a file, in any CRS, as import_area does.
/// @throws InvalidInput if the file cannot be read, has several layers and none is chosen, or holds
///   none of them.
[[nodiscard]] ImportedShapes import_shapes(const std::filesystem::path& path, const Frame& frame,
                                           const std::vector<std::string>& layers = {});

}  // namespace swathplan
