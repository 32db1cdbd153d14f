#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mesh/plane/polygons.h"
#include "mesh/repair/mesh_repair.h"
#include "mesh/seafloor.h"

namespace swathplan {

/// How to read a seafloor file where the file does not say, or says it wrongly.
struct ImportOptions {
  std::string crs = {};        ///< 'EPSG:n' or WKT, overrides the file's own; empty: the file's own
  double water_level_m = 0.0;  ///< height of still water in the file's vertical datum, z up
  enum class ZPositive { up, down } z_positive = ZPositive::up;
  /// Which axis of a mesh points up. ask: z, and a mesh that looks y up is refused.
  enum class Up { ask, y, z } up = Up::ask;
  /// Metres in one vertical unit, > 0; empty: the file's own unit where it names one, else metres.
  std::optional<double> z_unit_m = {};
  std::optional<double> xy_unit_m = {};  ///< metres in one horizontal unit, > 0; empty: the CRS's
  std::optional<double> longest_edge_m =
      {};                             ///< soundings: triangles with a longer edge are left out
  std::optional<double> nodata = {};  ///< a further z value (file units) that means 'no data'
  /// Names, separated by commas: which variable, band, layer or packed file to read where there are
  /// several. A name that the file does not hold is no error.
  std::string layer = {};
  /// Soundings in text files: which columns are x, y and z, by number (from 1) or by name, as in
  /// 'x=3,y=2,z=5'. Empty: by their names.
  std::string columns = {};
};

/// A seafloor in its local frame and what was found on the way.
struct ImportedSeafloor {
  Seafloor seafloor;
  MeshHealth health;
  std::string file;          ///< as it was given
  std::string kind;          ///< 'mesh', 'grid', 'soundings' or 'chart'
  std::string format;        ///< 'OBJ', 'GTiff', 'CSV', ...
  std::string crs_name;      ///< 'EPSG:32633 (WGS 84 / UTM zone 33N)'; 'none'
  std::string file_crs_wkt;  ///< of the file's own coordinates, where `seafloor.frame` has another
  /// The true azimuth of the frame's north at the middle of the data, degrees; 0 without a CRS.
  double convergence_deg = 0.0;
  std::string input_hash;  ///< 'sha1:...' of the file's bytes; of a chart of its updates' too
  std::size_t nodes = 0;   ///< vertices, valid cells or distinct soundings of the file
  Vec2 raw_min = Vec2::Zero(), raw_max = Vec2::Zero();  ///< extent in the file's own units
  double raw_z_min = 0.0, raw_z_max = 0.0;              ///< in the file's own units and sense
  double spacing_m = 0.0;       ///< typical distance between neighbouring nodes
  Area land;                    ///< what lies above the water, clipped; local metres
  double land_share = 0.0;      ///< share of the plan area above the water, clipped; [0, 1]
  double longest_edge_m = 0.0;  ///< soundings: the limit that was used; else 0
  std::vector<std::string> notes, warnings;  ///< one sentence each
};

/// Places between the coordinates of the file and local metres, also where the file's are degrees
/// or were brought to another CRS. @throws InvalidInput for a place that has no counterpart.
[[nodiscard]] Vec2 local_of(const ImportedSeafloor& data, const Vec2& in_file);
[[nodiscard]] Vec2 in_file_of(const ImportedSeafloor& data, const Vec2& local);

/// Reads a triangle mesh (OBJ, PLY, OFF, STL, glTF, COLLADA, ...), a grid (Esri ASCII, GeoTIFF,
/// BAG, netCDF, S-102, ...), soundings (XYZ, CSV, LAS, points of a vector file) or a chart (S-57)
/// into the local frame, clipped at the water level. Files packed as .zip, .tar or .gz are read as
/// they are. Guarantees: (1) the invariants of `Seafloor`; (2) where the file holds doubles and
/// nothing is reprojected or scaled, `frame.to_file` of a kept vertex gives the file's coordinates
/// exactly; (3) the local origin is whole file units, and 0 where all coordinates are under 10,000.
/// @throws InvalidInput naming the file and what is wrong; UsageError for an option out of range.
[[nodiscard]] ImportedSeafloor import_seafloor(const std::filesystem::path& path,
                                               const ImportOptions& options = {});

}  // namespace swathplan
