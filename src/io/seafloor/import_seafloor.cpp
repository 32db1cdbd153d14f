#include "io/seafloor/import_seafloor.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>

#include "io/charts/chart_import.h"
#include "io/files/crs.h"
#include "io/files/file_hash.h"
#include "io/files/known_kinds.h"
#include "io/files/layer_choice.h"
#include "io/files/text.h"
#include "io/files/unpacked.h"
#include "io/grids/grid_import.h"
#include "io/grids/las_import.h"
#include "io/grids/point_layers.h"
#include "io/seafloor/mesh_import.h"
#include "io/seafloor/true_scale.h"
#include "io/soundings/geographic_points.h"
#include "io/soundings/lattice.h"
#include "io/soundings/sounding_columns.h"
#include "io/soundings/soundings_import.h"
#include "mesh/base/error.h"
#include "mesh/survey_area.h"
#include "mesh/water_level.h"

namespace swathplan {
namespace {

namespace fs = std::filesystem;

/// A local file keeps its origin if its coordinates are below this. 32-bit floats still resolve a
/// millimetre there.
constexpr double kLargestLocalCoordinate = 1e4;
/// Coordinates are degrees if nodes lie closer than this (units) and the depth exceeds the width of
/// the whole extent.
constexpr double kFinestSpacing = 0.02;
constexpr double kMetresPerDegree = 111'320.0;
constexpr double kLossyStep = 1e-3;

void check_options(const ImportOptions& options) {
  (void)parse_columns(options.columns);
  const auto positive = [](const char* name, double value) {
    if (!(value > 0.0) || !std::isfinite(value)) {
      throw UsageError(name, fmt::format("{}", value), "must be a finite number above 0");
    }
  };
  if (options.z_unit_m) positive("z unit", *options.z_unit_m);
  if (options.xy_unit_m) positive("xy unit", *options.xy_unit_m);
  if (options.longest_edge_m) positive("longest edge", *options.longest_edge_m);
  if (!std::isfinite(options.water_level_m)) {
    throw UsageError("water level", fmt::format("{}", options.water_level_m),
                     "must be a finite number");
  }
}

void check_file(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) {
    throw InvalidInput(
        fmt::format("'{}' does not exist; check the name and the folder", path.string()));
  }
  if (fs::is_directory(status)) {
    throw InvalidInput(
        fmt::format("'{}' is a folder; name the seafloor file in it", path.string()));
  }
  if (fs::is_character_file(status) || fs::is_block_file(status)) {
    throw InvalidInput(
        fmt::format("'{}' is a device; name a file that holds a seafloor", path.string()));
  }
  if (fs::file_size(path, error) == 0 && !error) {
    throw InvalidInput(fmt::format("'{}' is empty", path.string()));
  }
}

/// Text that readers of plain text would take for something else.
void refuse_other_encodings(const fs::path& path) {
  std::array<char, 512> head{};
  std::ifstream in(path, std::ios::binary);
  in.read(head.data(), head.size());
  const std::string_view text(head.data(), static_cast<std::size_t>(in.gcount()));
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
    throw InvalidInput(
        fmt::format("'{}' is text in UTF-16; save it as plain text (UTF-8)", path.string()));
  }
}

bool starts_like_text(const fs::path& path, std::string_view word) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  std::array<char, 512> head{};
  std::ifstream in(path, std::ios::binary);
  in.read(head.data(), head.size());
  std::string_view text(head.data(), static_cast<std::size_t>(in.gcount()));
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  if (!word.empty()) return lower(trim(text)).starts_with(word);
  return std::none_of(text.begin(), text.end(), [](char c) {
    return (c >= 0 && c < ' ' && c != '\n' && c != '\r' && c != '\t' && c != '\f') || c == 127;
  });
}

std::string kind_of(const fs::path& path, const std::string& layer) {
  const std::string extension = lower(path.extension().string());
  if (is_mesh_extension(extension)) return "mesh";
  refuse_foreign(path);
  refuse_other_encodings(path);
  if (is_las(path)) return "lidar";
  // A chart whose soundings alone are asked for by name is a file of points.
  if (!chosen_layer(layer, {"SOUNDG"}) && is_chart(path)) return "chart";
  if (is_point_file(path)) return "points";
  constexpr std::array kSoundings = {".xyz", ".csv", ".txt", ".pts", ".dat"};
  const bool rows = std::find(kSoundings.begin(), kSoundings.end(), extension) != kSoundings.end();
  const bool is_text = starts_like_text(path, "");
  const bool esri_grid = starts_like_text(path, "ncols");
  if (rows && is_text && !esri_grid) return "soundings";
  if (esri_grid || is_grid(path)) return "grid";
  if (is_text) return "soundings";
  throw InvalidInput(fmt::format(
      "'{}' is neither a mesh (OBJ, PLY, OFF, STL, glTF, COLLADA), a grid that GDAL reads (Esri "
      "ASCII, GeoTIFF, BAG) nor soundings (XYZ, CSV); it may be truncated or garbled",
      path.string()));
}

SurfaceData read(const fs::path& path, const std::string& kind, const ImportOptions& options) {
  if (kind == "mesh") return read_mesh(path);
  const bool down = options.z_positive == ImportOptions::ZPositive::down;
  if (kind == "grid") return read_grid(path, options.nodata, options.layer);
  if (kind == "chart") return read_chart(path);
  if (kind == "points") {
    SurfaceData data = read_point_file(path, down, options.nodata, options.layer);
    join_lattice(data);
    return data;
  }
  if (kind == "lidar") return read_las(path, down);
  return read_soundings(path, {.z_positive_down = down,
                               .nodata = options.nodata,
                               .columns = options.columns,
                               .z_unit_is_given = options.z_unit_m.has_value()});
}

/// True if the faces look along y rather than up, and z runs farther than y.
bool looks_y_up(const SurfaceData& data) {
  if (data.vertices.empty()) return false;
  Vec3 low = data.vertices.front();
  Vec3 high = low;
  for (const Vec3& v : data.vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  if (high.z() - low.z() <= high.y() - low.y()) return false;
  Vec3 sum = Vec3::Zero();
  for (const auto& f : data.faces) {
    const Vec3& a = data.vertices[f[0]];
    sum += (data.vertices[f[1]] - a).cross(data.vertices[f[2]] - a).cwiseAbs();
  }
  return sum.y() > 2.0 * std::max(sum.x(), sum.z());
}

/// Turns a mesh z up, or asks which way it is up.
void turn_z_up(SurfaceData& data, const ImportedSeafloor& r, const ImportOptions& options) {
  if (r.kind != "mesh") {
    if (options.up == ImportOptions::Up::y) {
      data.warnings.emplace_back("<up> is for meshes; it was not used");
    }
    return;
  }
  if (options.up == ImportOptions::Up::ask && looks_y_up(data)) {
    throw InvalidInput(fmt::format(
        "the mesh '{}' looks y up: its faces look along y, and z runs farther than y; say which "
        "axis points up: <up> y turns it, <up> z takes it as it is",
        r.file));
  }
  if (options.up != ImportOptions::Up::y) return;
  for (Vec3& v : data.vertices) v = Vec3(v.x(), -v.z(), v.y());
  data.notes.emplace_back("the mesh was turned from y up to z up");
}

/// Soundings of which only the options say that they are in degrees.
void mend_degrees(SurfaceData& data, const ImportOptions& options, const std::string& kind) {
  if (kind != "soundings") return;
  const std::string crs = options.crs.empty() ? data.crs_wkt : parse_crs(options.crs);
  if (is_geographic(crs) && mend_geographic_points(data) && data.faces.empty()) join_lattice(data);
}

void note_extent(const SurfaceData& data, ImportedSeafloor& result) {
  Vec3 low = data.vertices.front();
  Vec3 high = low;
  for (const Vec3& v : data.vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  result.nodes = data.vertices.size();
  result.raw_min = low.head<2>();
  result.raw_max = high.head<2>();
  result.raw_z_min = low.z();
  result.raw_z_max = high.z();
}

bool fits_degrees(const ImportedSeafloor& r) {
  return r.raw_min.x() >= -360.0 && r.raw_max.x() <= 360.0 && r.raw_min.y() >= -90.0 &&
         r.raw_max.y() <= 90.0;
}

/// Degrees in either order.
bool may_be_degrees(const ImportedSeafloor& r) {
  return fits_degrees(r) || (r.raw_min.y() >= -360.0 && r.raw_max.y() <= 360.0 &&
                             r.raw_min.x() >= -90.0 && r.raw_max.x() <= 90.0);
}

/// Soundings far from the origin beside their extent, and far deeper than that extent. Local metres
/// begin near the origin.
bool is_steeper_than_metres(const ImportedSeafloor& r, double highest) {
  const double size = (r.raw_max - r.raw_min).norm();
  const Vec2 middle = 0.5 * (r.raw_min + r.raw_max);
  return r.kind == "soundings" && may_be_degrees(r) && highest > 2.0 * size &&
         middle.cwiseAbs().minCoeff() > 2.0 * size;
}

/// True if nodes lie a few hundredths of a unit apart: too fine for metres.
bool is_finer_than_metres(const SurfaceData& data, const ImportedSeafloor& r) {
  const Vec2 size = r.raw_max - r.raw_min;
  const double spacing =
      data.spacing > 0.0 ? data.spacing
                         : size.maxCoeff() / std::sqrt(static_cast<double>(data.vertices.size()));
  return spacing < kFinestSpacing;
}

/// The CRS to use. Refuses degrees in a CRS of metres, and metres in a CRS of degrees.
std::string choose_crs(const SurfaceData& data, const ImportOptions& options,
                       const ImportedSeafloor& r) {
  std::string crs = options.crs.empty() ? data.crs_wkt : parse_crs(options.crs);
  const double highest = std::max(std::abs(r.raw_z_min), std::abs(r.raw_z_max));
  const bool fine = may_be_degrees(r) && is_finer_than_metres(data, r) && !options.xy_unit_m;
  const std::string extent = fmt::format("x {:.7g} to {:.7g}, y {:.7g} to {:.7g}", r.raw_min.x(),
                                         r.raw_max.x(), r.raw_min.y(), r.raw_max.y());
  const bool deeper = fine && highest > (r.raw_max - r.raw_min).norm();
  if (crs.empty() && !options.xy_unit_m && (deeper || is_steeper_than_metres(r, highest))) {
    throw InvalidInput(fmt::format(
        "the coordinates of '{}' look like degrees ({}), but no coordinate reference system says "
        "so; add <CRS> EPSG:4326 (or <xy unit> 1 if they are metres){}",
        r.file, extent,
        r.kind == "soundings" ? "; where the latitude comes first, add <columns> x=2,y=1,z=3 too"
                              : ""));
  }
  if (is_projected(crs) && fine) {
    throw InvalidInput(fmt::format(
        "the coordinates of '{}' look like degrees ({}), but {} is in metres or feet; give "
        "<CRS> EPSG:4326",
        r.file, extent, crs_name(crs)));
  }
  if (is_geographic(crs) && !fits_degrees(r)) {
    throw InvalidInput(fmt::format(
        "the coordinates of '{}' ({}) are no degrees, but {} is in degrees; give the projected "
        "reference system with <CRS> EPSG:n",
        r.file, extent, crs_name(crs)));
  }
  if (is_geographic(crs) && options.xy_unit_m) {
    throw UsageError(
        fmt::format("<xy unit> does not go with {}, which is in degrees", crs_name(crs)));
  }
  return crs;
}

/// Coordinates of `crs` -> the UTM zone of the middle of the data.
std::string project(SurfaceData& data, const std::string& crs, const ImportedSeafloor& r) {
  const Vec2 middle = CrsTransform(crs, wgs84_crs())(0.5 * (r.raw_min + r.raw_max));
  std::string utm = utm_crs(middle.x(), middle.y());
  std::vector<Vec2> places;
  places.reserve(data.vertices.size());
  for (const Vec3& v : data.vertices) places.emplace_back(v.head<2>());
  places = CrsTransform(crs, utm)(places);
  for (std::size_t i = 0; i < places.size(); ++i) data.vertices[i].head<2>() = places[i];
  if (is_geographic(crs)) {
    data.spacing *= kMetresPerDegree * std::sqrt(std::cos(Angle::degrees(middle.y()).rad()));
    data.notes.push_back(
        fmt::format("degrees of {} were projected to {}", crs_name(crs), crs_name(utm)));
  }
  return utm;
}

/// Corrects lengths of the map that are not lengths on the ground. If one factor is true
/// everywhere, it is applied. Otherwise the data are moved to another projection. Returns the
/// metres in one unit; `crs` may become another one.
double true_scale(SurfaceData& data, std::string& crs, const ImportOptions& options,
                  const ImportedSeafloor& r) {
  if (options.xy_unit_m) return *options.xy_unit_m;
  if (crs.empty() && data.xy_unit_m) return *data.xy_unit_m;
  if (!is_projected(crs)) return metres_per_unit(crs);
  if (data.xy_unit_m && std::abs(*data.xy_unit_m / metres_per_unit(crs) - 1.0) > 1e-3) {
    data.warnings.push_back(fmt::format(
        "the names of x and y say units of {:.7g} m, but {} has units of {:.7g} m, which were "
        "used; check <CRS>",
        *data.xy_unit_m, crs_name(crs), metres_per_unit(crs)));
  }
  MapScaleAtData scale;
  try {
    scale = map_scale(crs, {r.raw_min, r.raw_max});
  } catch (const InvalidInput&) {
    data.warnings.push_back(fmt::format(
        "the coordinates have no longitude and latitude in {}; check <CRS>", crs_name(crs)));
    return metres_per_unit(crs);
  }
  const double ratio = metres_per_unit(crs) / scale.metres_per_unit;
  if (scale.kind == MapScale::even) {
    data.notes.push_back(fmt::format(
        "lengths in {} are {:.4f} times those on the ground here; all lengths of the survey are "
        "those on the ground",
        crs_name(crs), ratio));
  }
  if (scale.kind != MapScale::uneven) return scale.metres_per_unit;
  const std::string utm = project(data, crs, r);
  data.notes.push_back(fmt::format(
      "lengths in {} differ from those on the ground by place or direction; the data were "
      "brought to {}, and so are the coordinates of all results",
      crs_name(crs), crs_name(utm)));
  data.spacing *= scale.metres_per_unit;
  crs = utm;
  return metres_per_unit(crs);
}

Frame choose_frame(const SurfaceData& data, const std::string& crs, double metres_per_unit) {
  Frame frame;
  frame.crs_wkt = crs;
  frame.metres_per_unit = metres_per_unit;
  Vec2 low = data.vertices.front().head<2>();
  double largest = 0.0;
  for (const Vec3& v : data.vertices) {
    low = low.cwiseMin(v.head<2>());
    largest = std::max(largest, v.head<2>().cwiseAbs().maxCoeff());
  }
  if (largest >= kLargestLocalCoordinate) frame.origin = low.array().floor();
  return frame;
}

Seafloor place(SurfaceData& data, const Frame& frame, const ImportOptions& options) {
  const bool down = options.z_positive == ImportOptions::ZPositive::down || data.z_is_depth;
  const double unit_m = options.z_unit_m.value_or(data.z_unit_m.value_or(1.0));
  const double unit = down ? -unit_m : unit_m;
  Seafloor seafloor;
  seafloor.frame = frame;
  seafloor.vertices = std::move(data.vertices);
  for (Vec3& v : seafloor.vertices) {
    v.head<2>() = frame.to_local(v.head<2>()).eval();
    v.z() = v.z() * unit - options.water_level_m;
  }
  seafloor.faces = std::move(data.faces);
  return seafloor;
}

/// More land than water, and land that rises higher than the water is deep: those may be depths,
/// positive down, with land negative.
void warn_of_upside_down(double lowest, double highest, ImportedSeafloor& result) {
  constexpr double kMuchLand = 0.4;
  if (result.land_share < kMuchLand || highest < -lowest) return;
  result.warnings.push_back(fmt::format(
      "{:.3g} % of the area lies above the water, up to {:.4g} m, and only the rest, down to "
      "{:.4g} "
      "m, is taken as seafloor: this looks like depths, positive down, with land negative; if so, "
      "add <z positive> down",
      100.0 * result.land_share, highest, -lowest));
}

/// A mesh that runs far along x and z and little along y.
bool may_be_y_up(const ImportedSeafloor& r) {
  const Vec2 size = r.raw_max - r.raw_min;
  return r.kind == "mesh" && 3.0 * size.y() < std::min(size.x(), r.raw_z_max - r.raw_z_min);
}

void clip_land(Seafloor& seafloor, ImportedSeafloor& result) {
  const double whole = plan_area_m2(seafloor);
  double lowest = 0.0;
  double highest = 0.0;
  for (const Vec3& v : seafloor.vertices) {
    lowest = std::min(lowest, v.z());
    highest = std::max(highest, v.z());
  }
  if (highest > 0.0) result.land = above_level(seafloor, 0.0);
  seafloor = below_level(seafloor, 0.0);
  const bool any_water = std::any_of(seafloor.vertices.begin(), seafloor.vertices.end(),
                                     [](const Vec3& v) { return v.z() < 0.0; });
  if (!any_water) {
    throw InvalidInput(fmt::format(
        "everything in '{}' lies above the water level (z from {:.6g} to {:.6g}); if these are "
        "depths, positive down, add <z positive> down; else give the level with <water level>{}",
        result.file, result.raw_z_min, result.raw_z_max,
        may_be_y_up(result) ? ". Or the mesh is y up: add <up> y" : ""));
  }
  result.land_share =
      whole > 0.0 ? std::clamp(1.0 - plan_area_m2(seafloor) / whole, 0.0, 1.0) : 0.0;
  if (result.land_share > 1e-9) {
    result.notes.push_back(
        fmt::format("{:.3g} % of the area lies above the water level: land, "
                    "clipped away",
                    100.0 * result.land_share));
  }
  warn_of_upside_down(lowest, highest, result);
}

void mend(Seafloor& seafloor, bool is_clean, ImportedSeafloor& result) {
  if (is_clean) {
    clip_land(seafloor, result);
    result.health = assess(seafloor);
    return;
  }
  try {
    RepairedSeafloor repaired = repair(std::move(seafloor));
    seafloor = std::move(repaired.seafloor);
    result.health = std::move(repaired.health);
  } catch (const InvalidInput& error) {
    throw InvalidInput(fmt::format("'{}': {}", result.file, error.what()));
  }
  clip_land(seafloor, result);
  const MeshHealth after = assess(seafloor);
  result.health.vertices = after.vertices;
  result.health.faces = after.faces;
  result.health.components = after.components;
  result.health.boundary_loops = after.boundary_loops;
  result.health.vertical_faces = after.vertical_faces;
  result.notes.insert(result.notes.end(), result.health.notes.begin(), result.health.notes.end());
}

void join(SurfaceData& data, const Frame& frame, const ImportOptions& options,
          ImportedSeafloor& result) {
  std::optional<double> limit = options.longest_edge_m;
  if (limit) *limit /= frame.metres_per_unit;
  try {
    result.longest_edge_m = join_soundings(data, limit) * frame.metres_per_unit;
  } catch (const InvalidInput& error) {
    throw InvalidInput(fmt::format("'{}': {}", result.file, error.what()));
  }
  result.notes.push_back(fmt::format(
      "soundings joined to triangles with edges up to {:.4g} m{}", result.longest_edge_m,
      limit ? "" : " (from their spacing; set another with <longest edge>)"));
}

/// Grids of metres end near 10,000,000; grids of feet go on. Depths in feet are the shoaler
/// reading, so the safe one, and whoever maps in feet sounds in feet.
void take_as_feet(const std::string& crs, SurfaceData& data, const ImportOptions& options,
                  const ImportedSeafloor& result) {
  constexpr double kLargestNorthing = 10'050'000.0, kUsFoot = 1200.0 / 3937.0;
  if (result.kind != "soundings" || !crs.empty() || options.xy_unit_m || data.xy_unit_m) return;
  const double largest =
      std::max(result.raw_max.cwiseAbs().maxCoeff(), result.raw_min.cwiseAbs().maxCoeff());
  if (largest < kLargestNorthing) return;
  const bool z_too = !options.z_unit_m && !data.z_unit_m;
  data.xy_unit_m = kUsFoot;
  if (z_too) data.z_unit_m = kUsFoot;
  data.warnings.push_back(fmt::format(
      "coordinates up to {:.8g} are more than grids of metres have: they were taken as US survey "
      "feet{}; if that is wrong, give <CRS> (or <xy unit>) and <z unit>",
      largest, z_too ? ", and so was z" : ""));
}

void note_other_z_unit(SurfaceData& data, const ImportOptions& options) {
  if (!options.z_unit_m || !data.z_unit_m || *options.z_unit_m == *data.z_unit_m) return;
  data.notes.push_back(fmt::format("z is taken in units of {:.7g} m (<z unit>), not of {:.7g} m",
                                   *options.z_unit_m, *data.z_unit_m));
}

/// Water that is many times deeper than its data are across was hardly measured from a boat.
void warn_of_depths(const SurfaceData& data, const ImportOptions& options,
                    ImportedSeafloor& result) {
  constexpr double kDeepestSides = 8.0;
  if (options.z_unit_m || data.z_unit_m || result.seafloor.vertices.empty()) return;
  double shoalest = std::numeric_limits<double>::infinity();
  for (const Vec3& v : result.seafloor.vertices) shoalest = std::min(shoalest, -v.z());
  const double side = extent(result.seafloor).size().maxCoeff();
  if (shoalest <= kDeepestSides * side) return;
  result.warnings.push_back(fmt::format(
      "the water is {:.0f} m deep everywhere, but the data are only {:.0f} m across: if z is in "
      "centimetres or so, set <z unit> (0.01)",
      shoalest, side));
}

void add_unit_warnings(const SurfaceData& data, const Frame& frame, double unit_m,
                       const ImportOptions& options, ImportedSeafloor& result) {
  if (unit_m != 1.0 && !options.z_unit_m && !data.z_unit_m) {
    result.warnings.push_back(fmt::format(
        "horizontal units are {:.7g} m, but z is taken as metres; set <z unit> if depths are in "
        "feet",
        unit_m));
  }
  if (data.float_step * frame.metres_per_unit > kLossyStep) {
    result.notes.push_back(fmt::format(
        "{} holds 32-bit floats, which resolve only {:.2g} m at these coordinates; export local "
        "coordinates or a double-precision format",
        data.format, data.float_step * frame.metres_per_unit));
  }
}

/// 0 where the places have no longitude and latitude, of which true_scale warns.
double convergence_at_middle(const SurfaceData& data, const std::string& crs) {
  if (!is_projected(crs) || data.vertices.empty()) return 0.0;
  Vec2 low = data.vertices.front().head<2>();
  Vec2 high = low;
  for (const Vec3& v : data.vertices) {
    low = low.cwiseMin(v.head<2>());
    high = high.cwiseMax(v.head<2>());
  }
  try {
    return meridian_convergence_deg(crs, 0.5 * (low + high));
  } catch (const InvalidInput&) {
    return 0.0;
  }
}

/// Reads the file inside a packed one; all words name the packed one.
ImportedSeafloor import_packed(const fs::path& path, const ImportOptions& options) {
  const Unpacked unpacked(path, options.layer);
  if (is_packed(unpacked.file())) {
    throw InvalidInput(
        fmt::format("'{}' is packed more than once; unpack it first", path.string()));
  }
  try {
    ImportedSeafloor result = import_seafloor(unpacked.file(), options);
    result.notes.insert(result.notes.begin(),
                        "unpacked: " + unpacked.in_words(unpacked.file().string()));
    for (auto* texts : {&result.notes, &result.warnings}) {
      for (std::string& text : *texts) text = unpacked.in_words(text);
    }
    result.file = path.string();
    result.input_hash = file_hash(path);
    return result;
  } catch (const InvalidInput& error) {
    throw InvalidInput(unpacked.in_words(error.what()));
  }
}

}  // namespace

Vec2 local_of(const ImportedSeafloor& data, const Vec2& in_file) {
  const Frame& frame = data.seafloor.frame;
  if (data.file_crs_wkt.empty()) return frame.to_local(in_file);
  if (is_geographic(data.file_crs_wkt) &&
      (std::abs(in_file.x()) > 360.0 || std::abs(in_file.y()) > 90.0)) {
    throw InvalidInput(
        fmt::format("'{}' is in degrees, longitude before latitude: ({}, {}) is no place there",
                    data.file, in_file.x(), in_file.y()));
  }
  return frame.to_local(CrsTransform(data.file_crs_wkt, frame.crs_wkt)(in_file));
}

Vec2 in_file_of(const ImportedSeafloor& data, const Vec2& local) {
  const Frame& frame = data.seafloor.frame;
  const Vec2 place = frame.to_file(local);
  return data.file_crs_wkt.empty() ? place : CrsTransform(frame.crs_wkt, data.file_crs_wkt)(place);
}

ImportedSeafloor import_seafloor(const fs::path& path, const ImportOptions& options) {
  check_options(options);
  check_file(path);
  if (is_packed(path)) return import_packed(path, options);
  ImportedSeafloor result;
  result.file = path.string();
  result.kind = kind_of(path, options.layer);
  result.input_hash = result.kind == "chart" ? chart_hash(path) : file_hash(path);
  const bool has_columns = result.kind == "soundings";
  SurfaceData data = read(path, result.kind, options);
  if (result.kind == "points" || result.kind == "lidar") result.kind = "soundings";
  turn_z_up(data, result, options);
  result.format = data.format;
  if (!options.columns.empty() && !has_columns) {
    data.warnings.emplace_back("<columns> is for soundings in text files; it was not used");
  }
  mend_degrees(data, options, result.kind);
  note_extent(data, result);
  std::string crs = choose_crs(data, options, result);
  const std::string file_crs = crs;
  if (is_geographic(crs)) crs = project(data, crs, result);
  take_as_feet(crs, data, options, result);
  const double unit_m = true_scale(data, crs, options, result);
  const Frame frame = choose_frame(data, crs, unit_m);
  result.crs_name = crs_name(crs);
  if (crs != file_crs) result.file_crs_wkt = file_crs;
  if (data.faces.empty()) join(data, frame, options, result);
  result.spacing_m = data.spacing * frame.metres_per_unit;
  note_other_z_unit(data, options);
  const double own_unit_m = crs.empty() && data.xy_unit_m ? *data.xy_unit_m : metres_per_unit(crs);
  add_unit_warnings(data, frame, options.xy_unit_m.value_or(own_unit_m), options, result);
  result.notes.insert(result.notes.begin(), data.notes.begin(), data.notes.end());
  result.warnings.insert(result.warnings.begin(), data.warnings.begin(), data.warnings.end());
  result.convergence_deg = convergence_at_middle(data, crs);
  const bool is_clean = data.is_clean;
  result.seafloor = place(data, frame, options);
  mend(result.seafloor, is_clean, result);
  warn_of_depths(data, options, result);
  if (result.spacing_m == 0.0) {
    result.spacing_m = std::sqrt(2.0 * plan_area_m2(result.seafloor) /
                                 static_cast<double>(result.seafloor.faces.size()));
  }
  return result;
}

}  // namespace swathplan
