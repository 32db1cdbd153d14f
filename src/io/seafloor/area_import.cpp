#include "io/seafloor/area_import.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gdal_priv.h>
#include <ogr_geometry.h>
#include <ogr_spatialref.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <string>

#include "io/files/child_process.h"
#include "io/files/crs.h"
#include "io/files/gdal_at_home.h"
#include "io/files/lonlat.h"
#include "io/files/quiet_gdal.h"
#include "io/files/text.h"
#include "mesh/base/error.h"
#include "mesh/plane/few_corners.h"

namespace swathplan {
namespace {

namespace fs = std::filesystem;

/// What a layer holds, in file coordinates, and its CRS.
struct LayerShapes {
  std::vector<std::vector<Ring>> polygons;  ///< each as its rings
  std::vector<std::string> names;           ///< of the polygons
  std::vector<std::vector<Vec2>> lines;     ///< a point is a line of one place
  std::size_t points = 0;                   ///< of `lines`
  std::string crs_wkt;
};

bool has_index(fs::path path) {
  std::error_code error;
  return fs::exists(path.replace_extension(".shx"), error) ||
         fs::exists(path.replace_extension(".SHX"), error);
}

/// GDAL's reader of drawings breaks down over some that are damaged. Such a file is read in a
/// process of its own first, where that does no harm.
void check_drawing(const fs::path& path) {
  GDALDriverH driver = GDALIdentifyDriver(path.c_str(), nullptr);
  if (driver == nullptr || std::string_view(GDALGetDriverShortName(driver)) != "DXF") return;
  const ChildResult child = run_in_child([&] {
    const GDALDatasetUniquePtr drawing(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR));
    for (int i = 0; drawing && i < drawing->GetLayerCount(); ++i) {
      for (const OGRFeatureUniquePtr& feature : *drawing->GetLayer(i)) {
        if (feature->GetGeometryRef() == nullptr) continue;
        const std::unique_ptr<OGRGeometry> straight(feature->GetGeometryRef()->getLinearGeometry());
      }
    }
    return std::string();
  });
  if (child.end == ChildEnd::done || child.end == ChildEnd::failed) return;
  throw InvalidInput(
      fmt::format("'{}' cannot be read as a drawing: its reader breaks down over it; save it as "
                  "DXF (ASCII) with plain polylines",
                  path.string()));
}

GDALDatasetUniquePtr open_vectors(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error)) {
    throw InvalidInput(
        fmt::format("'{}' does not exist; check the name and the folder", path.string()));
  }
  // Some formats are folders. Any other folder was named by mistake.
  const bool folder = fs::is_directory(path, error);
  register_gdal();
  if (!folder) check_sources_stay_beside(path);
  if (!folder) check_drawing(path);
  GDALDatasetUniquePtr data(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY));
  if (!data && folder) {
    throw InvalidInput(fmt::format("'{}' is a folder; name the file in it", path.string()));
  }
  if (!data && lower(path.extension().string()) == ".shp" && !has_index(path)) {
    throw InvalidInput(fmt::format(
        "'{}' is one file of a shapefile; its .shx is not beside it: copy all files of that name "
        "(.shp, .shx, .dbf, .prj)",
        path.string()));
  }
  if (!data) {
    throw InvalidInput(
        fmt::format("'{}' cannot be read as polygons{}; use GeoJSON, GeoPackage, Shapefile or KML",
                    path.string(), QuietGdal::why()));
  }
  return data;
}

std::vector<Vec2> positions_of(const OGRSimpleCurve& line) {
  std::vector<Vec2> positions;
  for (int i = 0; i < line.getNumPoints(); ++i) positions.emplace_back(line.getX(i), line.getY(i));
  return positions;
}

Ring ring_of(const OGRLinearRing& line) {
  Ring ring = positions_of(line);
  if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  return ring;
}

/// The polygon with its rings closed, as viewers take them.
std::unique_ptr<OGRPolygon> closed(const OGRPolygon& polygon) {
  std::unique_ptr<OGRPolygon> copy(polygon.clone());
  copy->closeRings();
  return copy;
}

bool is_a_line_at_most(const OGRLinearRing& ring) {
  std::vector<Vec2> corners = positions_of(ring);
  std::sort(corners.begin(), corners.end(), [](const Vec2& a, const Vec2& b) {
    return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
  });
  return std::unique(corners.begin(), corners.end()) - corners.begin() < 3;
}

void check_polygon(const OGRPolygon& polygon, const fs::path& path, long long feature) {
  for (const OGRLinearRing* ring : polygon) {
    for (int i = 0; i < ring->getNumPoints(); ++i) {
      if (std::isfinite(ring->getX(i)) && std::isfinite(ring->getY(i))) continue;
      throw InvalidInput(
          fmt::format("'{}', feature {}: a corner is not a finite number; remove or mend it",
                      path.string(), feature));
    }
  }
  if (is_a_line_at_most(*polygon.getExteriorRing())) {
    throw InvalidInput(fmt::format(
        "'{}', feature {}: the polygon has fewer than three corners; draw it anew, or remove it",
        path.string(), feature));
  }
  CPLErrorReset();
  if (polygon.IsValid() == 0) {
    throw InvalidInput(fmt::format(
        "'{}', feature {}: the polygon crosses or touches itself{}; mend it in a GIS ('fix "
        "geometries')",
        path.string(), feature, QuietGdal::why()));
  }
}

void collect(const OGRGeometry& geometry, const fs::path& path, long long feature,
             LayerShapes& found) {
  const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
  if (type == wkbPolygon) {
    if (geometry.IsEmpty() != 0) return;
    const auto polygon = closed(*geometry.toPolygon());
    check_polygon(*polygon, path, feature);
    std::vector<Ring> rings;
    for (const OGRLinearRing* ring : *polygon) rings.push_back(ring_of(*ring));
    found.polygons.push_back(std::move(rings));
  } else if (type == wkbPoint && geometry.IsEmpty() == 0) {
    const OGRPoint& point = *geometry.toPoint();
    found.lines.push_back({{point.getX(), point.getY()}});
    ++found.points;
  } else if (type == wkbLineString && geometry.IsEmpty() == 0) {
    found.lines.push_back(positions_of(*geometry.toLineString()));
  } else if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection) != 0) {
    for (const OGRGeometry* part : *geometry.toGeometryCollection()) {
      collect(*part, path, feature, found);
    }
  }
}

/// What the feature calls itself; empty if it does not.
std::string name_of(const OGRFeature& feature) {
  for (const char* field : {"name", "title", "label", "id"}) {
    const int at = feature.GetFieldIndex(field);  // in any case
    if (at >= 0 && feature.IsFieldSetAndNotNull(at) != 0) {
      std::string text = feature.GetFieldAsString(at);
      if (!text.empty()) return text;
    }
  }
  return {};
}

LayerShapes read_layer(OGRLayer& layer, const fs::path& path) {
  LayerShapes found;
  if (const OGRSpatialReference* crs = layer.GetSpatialRef(); crs != nullptr) {
    char* text = nullptr;
    if (crs->exportToWkt(&text) == OGRERR_NONE) found.crs_wkt = parse_crs(text);
    CPLFree(text);
  }
  for (const OGRFeatureUniquePtr& feature : layer) {
    const OGRGeometry* geometry = feature->GetGeometryRef();
    if (geometry == nullptr) continue;
    // Arcs become short chords; flat geometries come back as they are.
    const std::unique_ptr<OGRGeometry> straight(geometry->getLinearGeometry());
    if (straight) collect(*straight, path, static_cast<long long>(feature->GetFID()), found);
    found.names.resize(found.polygons.size(), name_of(*feature));
  }
  return found;
}

bool all_degrees(const LayerShapes& layer) {
  const auto in_degrees = [](const std::vector<Vec2>& points) {
    return std::all_of(points.begin(), points.end(), [](const Vec2& p) {
      return std::abs(p.x()) <= 360.0 && std::abs(p.y()) <= 90.0;
    });
  };
  return std::all_of(layer.polygons.begin(), layer.polygons.end(),
                     [&](const auto& rings) {
                       return std::all_of(rings.begin(), rings.end(), in_degrees);
                     }) &&
         std::all_of(layer.lines.begin(), layer.lines.end(), in_degrees);
}

/// GeoJSON without a CRS counts as WGS 84; one that holds eastings and northings is the seafloor's.
void to_local(LayerShapes& layer, const Frame& frame) {
  const bool same = layer.crs_wkt.empty() || frame.crs_wkt.empty() ||
                    (is_geographic(layer.crs_wkt) && !all_degrees(layer));
  std::optional<CrsTransform> to_frame;
  if (!same) to_frame.emplace(layer.crs_wkt, frame.crs_wkt);
  const auto turn = [&](std::vector<Vec2>& points) {
    if (to_frame) points = (*to_frame)(points);
    for (Vec2& p : points) p = frame.to_local(p);
  };
  for (auto& polygon : layer.polygons) std::for_each(polygon.begin(), polygon.end(), turn);
  std::for_each(layer.lines.begin(), layer.lines.end(), turn);
}

std::string text_of(const Box2& box) {
  return fmt::format("x {:.1f} to {:.1f}, y {:.1f} to {:.1f}", box.min.x(), box.max.x(),
                     box.min.y(), box.max.y());
}

/// True if the middle of the area would lie in the data with longitude and latitude exchanged.
bool meets_if_swapped(const Area& area, const Box2& data, const Frame& frame) {
  if (frame.crs_wkt.empty()) return false;
  const LonLat degrees(frame);
  try {
    const Box2 box = extent(area);
    const std::vector<Vec2> middle{0.5 * (box.min + box.max)};
    const Vec2 lonlat = degrees.from_local(middle).front();
    const Vec2 there = degrees.to_local(std::vector<Vec2>{Vec2(lonlat.y(), lonlat.x())}).front();
    return (there.array() >= data.min.array()).all() && (there.array() <= data.max.array()).all();
  } catch (const InvalidInput&) {
    return false;  // no such place
  }
}

void check_meets(const Area& area, const Box2& data, const Frame& frame, const fs::path& path) {
  const Box2 box = extent(area);
  const bool apart =
      (box.min.array() > data.max.array()).any() || (box.max.array() < data.min.array()).any();
  if (!apart) return;
  const auto in_file = [&](const Box2& b) {
    return Box2{frame.to_file(b.min), frame.to_file(b.max)};
  };
  throw InvalidInput(fmt::format(
      "the polygons of '{}' ({}) do not meet the seafloor ({}); {}", path.string(),
      text_of(in_file(box)), text_of(in_file(data)),
      meets_if_swapped(area, data, frame)
          ? "with latitude and longitude exchanged they would: the file has them in the wrong order"
          : "check their coordinate reference system"));
}

/// A degree is 111 km. Coordinates that span less than this as metres were meant as degrees.
constexpr double kLeastExtentM = 0.5;

void check_not_degrees(const Area& area, const Frame& frame, const fs::path& path) {
  if (!frame.crs_wkt.empty() || extent(area).size().maxCoeff() >= kLeastExtentM) return;
  throw InvalidInput(fmt::format(
      "the polygons of '{}' span {:.2g} m: they look like degrees, but the seafloor has no "
      "coordinate reference system to bring them to; give the seafloor's, or draw them in its "
      "coordinates",
      path.string(), extent(area).size().maxCoeff()));
}

std::vector<std::string> layers_with_shapes(GDALDataset& data) {
  std::vector<std::string> names;
  for (int i = 0; i < data.GetLayerCount(); ++i) {
    OGRLayer& layer = *data.GetLayer(i);
    layer.ResetReading();
    const OGRFeatureUniquePtr first(layer.GetNextFeature());
    layer.ResetReading();
    if (first) names.emplace_back(layer.GetName());
  }
  return names;
}

/// The layer that is meant, or all of a file that has only one.
std::vector<std::string> chosen_layers(GDALDataset& data, const std::vector<std::string>& wanted,
                                       const fs::path& path) {
  const std::vector<std::string> all = layers_with_shapes(data);
  std::vector<std::string> chosen;
  std::copy_if(all.begin(), all.end(), std::back_inserter(chosen), [&](const std::string& name) {
    return std::find(wanted.begin(), wanted.end(), name) != wanted.end();
  });
  if (!chosen.empty() || all.size() <= 1) return chosen.empty() ? all : chosen;
  throw InvalidInput(fmt::format("'{}' has several layers ({}); say which is meant with <layer>",
                                 path.string(), fmt::join(all, ", ")));
}

/// What lies within `buffer_m` of a line or a point.
Area around(const std::vector<Vec2>& line, double buffer_m) {
  constexpr int kChords = 16;  // a quarter circle
  OGRLineString path;
  for (const Vec2& p : line) path.addPoint(p.x(), p.y());
  OGRPoint point(line.front().x(), line.front().y());
  const OGRGeometry& shape =
      line.size() == 1 ? static_cast<const OGRGeometry&>(point) : static_cast<OGRGeometry&>(path);
  const std::unique_ptr<OGRGeometry> buffer(shape.Buffer(buffer_m, kChords));
  if (!buffer || wkbFlatten(buffer->getGeometryType()) != wkbPolygon) return {};
  std::vector<Ring> rings;
  for (const OGRLinearRing* ring : *buffer->toPolygon()) rings.push_back(ring_of(*ring));
  return from_rings(rings, false);
}

/// Unites all polygons at once. Outlines run one way and holes the other, so that a place is
/// covered if any polygon covers it.
Area united(const std::vector<Area>& parts) {
  if (parts.size() == 1) return unite({}, parts.front());
  std::vector<Ring> rings;
  for (const Area& part : parts) {
    for (const Polygon& polygon : part) {
      rings.push_back(polygon.outer);
      rings.insert(rings.end(), polygon.holes.begin(), polygon.holes.end());
    }
  }
  return from_rings(rings, true);
}

struct Shapes {
  std::vector<Area> parts;         ///< polygons, then buffers
  std::vector<std::string> names;  ///< of the parts
  double within_m = 0.0;           ///< the largest tolerance of those simplified
  std::size_t simplified = 0, corners_before = 0, corners_after = 0;
  std::size_t polygons = 0, lines = 0, points = 0, off_the_data = 0, closed_lines = 0;
};

/// The tolerance that leaves few enough corners, as far as the options allow.
double tolerance_of(const std::vector<Ring>& rings, const AreaImportOptions& options) {
  double tolerance = std::max(options.tolerance_m, kLeastTolerance);
  const auto corners_left = [&] {
    std::size_t corners = 0;
    // About the share of the tolerance that bracket() gives its chords.
    for (const Ring& ring : rings) corners += few_corners(ring, tolerance / 3.0).size();
    return corners;
  };
  while (2.0 * tolerance <= options.most_tolerance_m && corners_left() > kFewEnough) {
    tolerance *= 2.0;
  }
  return tolerance;
}

/// Drawings and tracks know no polygons: their closed lines are meant as such.
void take_closed_lines(std::vector<LayerShapes>& layers, const fs::path& path, Shapes& shapes) {
  for (LayerShapes& layer : layers) {
    std::vector<std::vector<Vec2>> open;
    for (std::vector<Vec2>& line : layer.lines) {
      if (line.size() < 4 || line.front() != line.back()) {
        open.push_back(std::move(line));
        continue;
      }
      OGRLinearRing ring;
      for (const Vec2& p : line) ring.addPoint(p.x(), p.y());
      OGRPolygon polygon;
      polygon.addRing(&ring);
      check_polygon(polygon, path, static_cast<long long>(shapes.closed_lines));
      layer.polygons.push_back({ring_of(ring)});
      layer.names.emplace_back();
      ++shapes.closed_lines;
    }
    layer.lines = std::move(open);
  }
}

/// A polygon as an area, with fewer corners if it has very many.
Area area_of(const std::vector<Ring>& rings, const AreaImportOptions& options, Shapes& shapes) {
  if (!(options.tolerance_m > 0.0) || corners_of(rings) <= kManyCorners) {
    return from_rings(rings, false);
  }
  const double tolerance = tolerance_of(rings, options);
  shapes.within_m = std::max(shapes.within_m, tolerance);
  Bracket both = bracket(rings, tolerance);
  Area area = std::move(options.rounding == Rounding::within ? both.within : both.around);
  ++shapes.simplified;
  shapes.corners_before += corners_of(rings);
  for (const Polygon& polygon : area) {
    shapes.corners_after += polygon.outer.size() + corners_of(polygon.holes);
  }
  return area;
}

void add_layer(LayerShapes layer, const Frame& frame, const AreaImportOptions& options,
               Shapes& shapes) {
  to_local(layer, frame);
  shapes.polygons += layer.polygons.size();
  shapes.points += layer.points;
  shapes.lines += layer.lines.size() - layer.points;
  for (const std::vector<Ring>& rings : layer.polygons) {
    shapes.parts.push_back(area_of(rings, options, shapes));
  }
  shapes.names.insert(shapes.names.end(), layer.names.begin(), layer.names.end());
  if (!(options.buffer_m > 0.0)) return;
  for (const auto& line : layer.lines) shapes.parts.push_back(around(line, options.buffer_m));
  shapes.names.resize(shapes.parts.size());
}

bool meets(const Area& area, const Box2& data) {
  const Box2 box = extent(area);
  return !area.empty() && !(box.min.array() > data.max.array()).any() &&
         !(box.max.array() < data.min.array()).any();
}

std::string some(std::size_t n, const char* what) {
  return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
}

std::vector<std::string> notes_on(const Shapes& shapes, const AreaImportOptions& options,
                                  const fs::path& path) {
  std::vector<std::string> notes;
  const std::string file = path.filename().string();
  if (shapes.lines + shapes.points > 0) {
    const std::string what =
        shapes.points == 0  ? some(shapes.lines, "line")
        : shapes.lines == 0 ? some(shapes.points, "point")
                            : some(shapes.lines, "line") + " and " + some(shapes.points, "point");
    notes.push_back(
        options.buffer_m > 0.0
            ? fmt::format("'{}': {} with {:g} m of room around", file, what, options.buffer_m)
            : fmt::format("'{}': {} do not count, only polygons do; give them room "
                          "with <buffer>",
                          file, what));
  }
  if (shapes.closed_lines > 0) {
    notes.push_back(fmt::format("'{}' holds no polygon: its {} closed {} taken as such", file,
                                shapes.closed_lines,
                                shapes.closed_lines == 1 ? "line was" : "lines were"));
  }
  if (shapes.off_the_data > 0) {
    notes.push_back(fmt::format("'{}': {} of {} shapes lie off the seafloor's data", file,
                                shapes.off_the_data, shapes.parts.size()));
  }
  if (shapes.simplified > 0) {
    notes.push_back(fmt::format(
        "'{}': {} corners were simplified to {}, within {:g} m; the area used {} the file's", file,
        shapes.corners_before, shapes.corners_after, shapes.within_m,
        options.rounding == Rounding::within ? "lies inside" : "contains"));
  }
  return notes;
}

}  // namespace

ImportedArea import_area(const fs::path& path, const Frame& frame,
                         const AreaImportOptions& options) {
  const QuietGdal quiet;
  const GDALDatasetUniquePtr data = open_vectors(path);
  Shapes shapes;
  std::vector<LayerShapes> layers;
  for (const std::string& name : chosen_layers(*data, options.layers, path)) {
    layers.push_back(read_layer(*data->GetLayerByName(name.c_str()), path));
  }
  const bool no_polygon = std::all_of(layers.begin(), layers.end(), [](const LayerShapes& layer) {
    return layer.polygons.empty();
  });
  if (no_polygon && !(options.buffer_m > 0.0)) take_closed_lines(layers, path, shapes);
  for (LayerShapes& layer : layers) add_layer(std::move(layer), frame, options, shapes);
  if (shapes.parts.empty()) {
    throw InvalidInput(fmt::format(
        "'{}' holds no polygon; draw the area as a polygon (lines and points count with a <buffer> "
        "only)",
        path.string()));
  }
  ImportedArea result;
  result.area = united(shapes.parts);
  if (result.area.empty() && shapes.simplified > 0) {
    throw InvalidInput(fmt::format("no part of the polygons of '{}' is wider than {:g} m",
                                   path.string(), 2.0 * shapes.within_m));
  }
  if (result.area.empty()) {
    throw InvalidInput(fmt::format("the polygons of '{}' have no area", path.string()));
  }
  check_not_degrees(result.area, frame, path);
  if (options.data_extent && !options.data_extent->empty()) {
    check_meets(result.area, *options.data_extent, frame, path);
    shapes.off_the_data = static_cast<std::size_t>(
        std::count_if(shapes.parts.begin(), shapes.parts.end(),
                      [&](const Area& part) { return !meets(part, *options.data_extent); }));
  }
  result.notes = notes_on(shapes, options, path);
  for (std::size_t i = 0; i < shapes.parts.size(); ++i) {
    result.parts.push_back({shapes.names[i], std::move(shapes.parts[i])});
  }
  return result;
}

ImportedShapes import_shapes(const fs::path& path, const Frame& frame,
                             const std::vector<std::string>& wanted) {
  const QuietGdal quiet;
  const GDALDatasetUniquePtr data = open_vectors(path);
  ImportedShapes result;
  for (const std::string& name : chosen_layers(*data, wanted, path)) {
    LayerShapes layer = read_layer(*data->GetLayerByName(name.c_str()), path);
    to_local(layer, frame);
    for (std::vector<Vec2>& line : layer.lines) {
      for (const Vec2& p : line) {
        if (p.allFinite()) continue;
        throw InvalidInput(fmt::format("'{}': a place of it is not a finite number; mend it there",
                                       path.string()));
      }
      if (line.size() == 1) {
        result.points.push_back(line.front());
      } else {
        result.lines.push_back(std::move(line));
      }
    }
    std::vector<Area> parts;
    for (const std::vector<Ring>& polygon : layer.polygons) {
      parts.push_back(from_rings(polygon, false));
    }
    if (!parts.empty()) result.polygons = unite(result.polygons, united(parts));
  }
  if (result.lines.empty() && result.points.empty() && result.polygons.empty()) {
    throw InvalidInput(
        fmt::format("'{}' holds no line, point or polygon; draw one there", path.string()));
  }
  return result;
}

}  // namespace swathplan
