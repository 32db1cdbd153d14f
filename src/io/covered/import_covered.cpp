#include "io/covered/import_covered.h"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <fstream>

#include "io/covered/covered_raster_internal.h"
#include "io/files/crs.h"
#include "io/files/gdal_at_home.h"
#include "io/files/quiet_gdal.h"
#include "io/files/text.h"
#include "io/grids/las_import.h"
#include "io/route/read_route.h"
#include "io/route/route_gpkg_read.h"
#include "io/seafloor/area_import.h"
#include "io/seafloor/import_seafloor.h"
#include "io/seafloor/mesh_import.h"
#include "mesh/base/error.h"
#include "mesh/survey_area.h"

namespace swathplan {
namespace {

namespace fs = std::filesystem;

/// Whatever an earlier survey is in, its heights are below this, metres: none of it is land.
constexpr double kAboveAllWater = 1e5;

enum class CoveredKind { raster, polygons, track, surface };

/// The first bytes of a file; empty where they are no text.
std::string head_of(const fs::path& path) {
  std::array<char, 2000> bytes{};
  std::ifstream in(path, std::ios::binary);
  in.read(bytes.data(), bytes.size());
  std::string head(bytes.data(), static_cast<std::size_t>(in.gcount()));
  return head.find('\0') == std::string::npos ? head : std::string();
}

/// What the first row of a text names: columns of depths are those of soundings, and so are rows of
/// numbers. Any other header is that of a track.
bool is_track_table(const std::string& head) {
  const std::string first = lower(head.substr(0, head.find('\n')));
  if (first.find("port_deg") != std::string::npos) return true;
  if (first.find_first_of("abcdefghijklmnopqrstuvwxyz") == std::string::npos) return false;
  constexpr std::array kDepths = {"depth", "height", "elev", "sounding", "tiefe"};
  const bool depths = std::any_of(kDepths.begin(), kDepths.end(), [&](const char* word) {
    return first.find(word) != std::string::npos;
  });
  for (const char separator : {',', ';', '\t'}) {
    const auto fields = split(first, separator);
    if (fields.size() < 2) continue;
    return !depths && std::find(fields.begin(), fields.end(), "z") == fields.end() &&
           std::find(fields.begin(), fields.end(), "z_m") == fields.end();
  }
  return false;
}

struct VectorContent {
  bool opened = false, polygons = false, lines = false, points = false;
};

void look_into(const OGRGeometry& geometry, VectorContent& found) {
  const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
  if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection) != 0) {
    for (const OGRGeometry* part : *geometry.toGeometryCollection()) look_into(*part, found);
  } else if (OGR_GT_IsSurface(type) != 0) {
    found.polygons = true;
  } else if (OGR_GT_IsCurve(type) != 0) {
    found.lines = true;
  } else if (type == wkbPoint) {
    found.points = true;
  }
}

VectorContent content_of(const fs::path& path) {
  VectorContent found;
  register_gdal();
  check_sources_stay_beside(path);
  const GDALDatasetUniquePtr data(
      GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY));
  if (!data) return found;
  found.opened = true;
  for (OGRLayer* layer : data->GetLayers()) {
    for (const OGRFeatureUniquePtr& feature : *layer) {
      if (feature->GetGeometryRef() != nullptr) look_into(*feature->GetGeometryRef(), found);
      if (found.polygons) return found;
    }
  }
  return found;
}

/// Text that only routes are written in.
bool is_route_text(const std::string& head) {
  if (head.empty()) return false;
  const RouteFormat format = route_format(head);
  if (format == RouteFormat::xml) {
    return head.find("<gpx") != std::string::npos || head.find("<route") != std::string::npos;
  }
  return format == RouteFormat::plan || format == RouteFormat::waypoints ||
         format == RouteFormat::lnw || format == RouteFormat::rln ||
         format == RouteFormat::asciiplan || format == RouteFormat::yaml;
}

/// Lines in a file that read_route takes.
bool is_readable_route(const std::string& head) {
  if (head.empty()) return false;
  const RouteFormat format = route_format(head);
  return format == RouteFormat::geojson || format == RouteFormat::xml || format == RouteFormat::dxf;
}

void check_there(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error)) {
    throw InvalidInput(
        fmt::format("'{}' does not exist; check the name and the folder", path.string()));
  }
  if (fs::is_regular_file(path, error) && fs::file_size(path, error) == 0) {
    throw InvalidInput(fmt::format("'{}' is empty", path.string()));
  }
}

CoveredKind kind_of_covered(const fs::path& path, const std::string& head) {
  if (is_mesh_extension(lower(path.extension().string())) || is_las(path)) {
    return CoveredKind::surface;
  }
  if (is_route_text(head)) return CoveredKind::track;
  if (is_route_package(path)) {
    const VectorContent content = content_of(path);
    return content.polygons ? CoveredKind::polygons
           : content.lines  ? CoveredKind::track
                            : CoveredKind::surface;
  }
  const bool structured = head.starts_with('{') || head.starts_with('<');
  if (!structured && is_grid(path)) return CoveredKind::raster;
  const bool table = !head.empty() && !structured && route_format(head) == RouteFormat::csv;
  if (table) return is_track_table(head) ? CoveredKind::track : CoveredKind::surface;
  const VectorContent content = content_of(path);
  if (content.polygons) return CoveredKind::polygons;
  if (content.lines) return is_readable_route(head) ? CoveredKind::track : CoveredKind::polygons;
  return CoveredKind::surface;
}

/// Adds one file to cells of its own.
class CoveredFile {
 public:
  CoveredFile(const fs::path& path, const Frame& frame, const CoveredOptions& options,
              CoveredBefore& before, std::vector<std::string>& notes)
      : path_(path), frame_(frame), options_(options), before_(before), notes_(notes) {}

  /// How the file was read, for people.
  std::string add() {
    check_there(path_);
    const std::string head = head_of(path_);
    switch (kind_of_covered(path_, head)) {
      case CoveredKind::raster:
        return add_cells();
      case CoveredKind::polygons:
        return add_polygons();
      case CoveredKind::track:
        return add_track();
      case CoveredKind::surface:
        break;
    }
    return add_surface();
  }

  [[nodiscard]] const Box2& where() const { return where_; }

 private:
  [[nodiscard]] std::string layers() const {
    std::string all;
    for (const std::string& layer : options_.layers) all += (all.empty() ? "" : ",") + layer;
    return all;
  }

  void note(const std::vector<std::string>& more) {
    for (const std::string& text : more) notes_.push_back(text);
  }

  std::string add_cells() {
    const auto cells = read_cells(path_, layers());
    if (!cells) return add_surface();
    for (const std::string& warning : cells->warnings) {
      notes_.push_back(fmt::format("'{}': {}", path_.filename().string(), warning));
    }
    return add_raster(*cells, frame_, before_, where_);
  }

  std::string add_polygons() {
    AreaImportOptions how;
    how.data_extent = extent(*options_.whole.seafloor);
    how.layers = options_.layers;
    how.buffer_m = 0.5 * options_.track_swath_m.value_or(0.0);
    const ImportedArea read = import_area(path_, frame_, how);
    note(read.notes);
    add(read.area);
    return how.buffer_m > 0.0 ? "polygons, and lines with their swath" : "polygons";
  }

  /// The ground between soundings, or a surface.
  std::string add_surface() {
    ImportOptions how;
    how.water_level_m = kAboveAllWater;
    how.layer = layers();
    const ImportedSeafloor read = import_seafloor(path_, how);
    Area ground = outline(read.seafloor);
    in_our_frame(ground, read.seafloor.frame);
    add(ground);
    if (read.kind == "soundings" && !(read.longest_edge_m > 0.0)) {
      return "the ground between soundings on a lattice";
    }
    return read.kind == "soundings"
               ? fmt::format("the ground between soundings that lie up to {:.4g} m apart",
                             read.longest_edge_m)
           : read.kind == "mesh" ? std::string("the ground of a mesh")
                                 : std::string("cells with a value");
  }

  void in_our_frame(Area& area, const Frame& theirs) const {
    std::optional<CrsTransform> to_frame;
    if (!theirs.crs_wkt.empty() && !frame_.crs_wkt.empty() && theirs.crs_wkt != frame_.crs_wkt) {
      to_frame.emplace(theirs.crs_wkt, frame_.crs_wkt);
    }
    const auto turn = [&](Ring& ring) {
      for (Vec2& p : ring) p = theirs.to_file(p);
      if (to_frame) ring = (*to_frame)(ring);
      for (Vec2& p : ring) p = frame_.to_local(p);
    };
    for (Polygon& polygon : area) {
      turn(polygon.outer);
      for (Ring& hole : polygon.holes) turn(hole);
    }
  }

  void add(const Area& area) {
    const Box2 box = extent(area);
    if (!area.empty()) {
      where_.extend(box.min);
      where_.extend(box.max);
    }
    before_.cover(area);
  }

  std::string add_track() {
    // A fan that stands for 'none': whether it was taken is told by the note.
    const FanAngles none{Angle::degrees(45), Angle::degrees(45)};
    RouteDefaults defaults{.fan = options_.track_fan.value_or(none),
                           .speed_mps = options_.vehicle.speed_mps};
    const ImportedRoute read = read_route(path_, frame_, defaults);
    note(read.leg_notes);
    note(read.notes);
    for (const Waypoint& w : read.route.waypoints) where_.extend(w.position);
    const bool has_angles = !read.fan_note;
    if (!has_angles && options_.track_swath_m) {
      add_strips(read.route, *options_.track_swath_m);
      return fmt::format("a track, {:g} m across", *options_.track_swath_m);
    }
    if (!has_angles && !options_.track_fan) {
      throw InvalidInput(fmt::format(
          "'{}' is a track without opening angles: say how wide it was surveyed with <covered "
          "swath>, or with which fan with <covered opening>",
          path_.string()));
    }
    ScoreOptions scoring = options_.scoring;
    scoring.footprint = false;
    Ground ground = options_.whole;
    ground.lattice = before_.grid().origin();
    const ScoredRoute sailed = score(read.route, ground, options_.sonar, options_.vehicle, scoring);
    before_.add(sailed.grid, options_.logged_only);
    return has_angles ? "a track with its angles, sailed by the simulator"
                      : "a track with the given fan, sailed by the simulator";
  }

  void add_strips(const Route& route, double swath_m) {
    std::vector<Vec2> path;
    const auto& w = route.waypoints;
    for (std::size_t i = 0; i < w.size(); ++i) {
      if (i + 1 < w.size() && w[i].log) {
        path.push_back(w[i].position);
        continue;
      }
      if (!path.empty()) {
        path.push_back(w[i].position);
        before_.cover(path, swath_m);
        path.clear();
      }
    }
  }

  const fs::path& path_;
  const Frame& frame_;
  const CoveredOptions& options_;
  CoveredBefore& before_;
  std::vector<std::string>& notes_;
  Box2 where_;
};

std::string text_of_extent(const Box2& box, const Frame& frame) {
  const Vec2 low = frame.to_file(box.min);
  const Vec2 high = frame.to_file(box.max);
  return fmt::format("x {:.1f} to {:.1f}, y {:.1f} to {:.1f}", low.x(), high.x(), low.y(),
                     high.y());
}

bool holds_soundings(const CoveredBefore& before) {
  const CoverageGrid& grid = before.grid();
  for (std::size_t i = 0; i < grid.words().size(); ++i) {
    if (grid.counts(i) && grid.soundings(i) > 0) return true;
  }
  return false;
}

}  // namespace

void add_covered(const fs::path& path, const Frame& frame, const CoveredOptions& options,
                 CoveredBefore& before, std::vector<std::string>& notes) {
  const QuietGdal quiet;
  CoveredBefore own = before.without_soundings();
  CoveredFile file(path, frame, options, own, notes);
  const std::string how = file.add();
  if (!holds_soundings(own)) {
    throw InvalidInput(fmt::format(
        "'{}' covers no cell of the survey area ({}); it reaches over {}: check its coordinate "
        "reference system, or leave it out",
        path.string(), text_of_extent(extent(options.whole.survey_area), frame),
        file.where().empty() ? "nothing" : text_of_extent(file.where(), frame)));
  }
  notes.push_back(fmt::format(
      "'{}' was read as {}: it covers {:.2f} % of the survey area", path.filename().string(), how,
      100.0 * static_cast<double>(own.covered_cells()) / static_cast<double>(own.cells())));
  before.add(own.grid(), false);
}

}  // namespace swathplan
