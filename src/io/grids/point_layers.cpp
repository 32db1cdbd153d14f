#include "io/grids/point_layers.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "io/files/crs.h"
#include "io/files/gdal_at_home.h"
#include "io/files/layer_choice.h"
#include "io/files/quiet_gdal.h"
#include "io/files/text.h"
#include "io/files/units.h"
#include "io/grids/shoalest_places.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

namespace fs = std::filesystem;

GDALDatasetUniquePtr open_vector(const fs::path& path) {
  register_gdal();
  check_sources_stay_beside(path);
  const char* const options[] = {"SPLIT_MULTIPOINT=ON", "ADD_SOUNDG_DEPTH=ON", nullptr};
  const bool is_s57 = lower(path.extension().string()) == ".000";
  return GDALDatasetUniquePtr(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY,
                                                nullptr, is_s57 ? options : nullptr, nullptr));
}

/// A column that holds depths or heights.
struct DepthColumn {
  int field = -1;
  std::string name;
  bool is_depth = false;
  double unit_m = 1.0;
};

/// 'depth_ft' -> 'depth' and feet.
DepthColumn as_depth_column(int field, const std::string& name) {
  constexpr std::array kDepths = {"depth", "sounding", "valsou", "depth_of_water", "tiefe"};
  constexpr std::array kHeights = {"z", "elevation", "elev", "height", "altitude", "z_value"};
  DepthColumn column{field, name, false, 1.0};
  std::string word = lower(name);
  const std::size_t bar = word.find_last_of("_ ");
  if (bar != std::string::npos) {
    if (const auto unit = metres_in(std::string_view(word).substr(bar + 1))) {
      column.unit_m = *unit;
      word.erase(bar);
    }
  }
  column.is_depth = std::find(kDepths.begin(), kDepths.end(), word) != kDepths.end();
  if (!column.is_depth && std::find(kHeights.begin(), kHeights.end(), word) == kHeights.end()) {
    column.field = -1;
  }
  return column;
}

std::optional<DepthColumn> depth_column(const OGRFeatureDefn& fields) {
  std::optional<DepthColumn> found;
  for (int i = 0; i < fields.GetFieldCount(); ++i) {
    const DepthColumn column = as_depth_column(i, fields.GetFieldDefn(i)->GetNameRef());
    if (column.field >= 0 && (!found || (column.is_depth && !found->is_depth))) found = column;
  }
  return found;
}

bool is_point(const OGRFeature& feature) {
  const OGRGeometry* shape = feature.GetGeometryRef();
  const OGRwkbGeometryType type =
      shape == nullptr ? wkbUnknown : wkbFlatten(shape->getGeometryType());
  return type == wkbPoint || type == wkbMultiPoint;
}

/// The layer's first features tell what it holds.
bool holds_points(OGRLayer& layer) {
  constexpr int kLook = 100;
  bool found = false;
  layer.ResetReading();
  for (int i = 0; i < kLook && !found; ++i) {
    const OGRFeatureUniquePtr feature(layer.GetNextFeature());
    if (!feature) break;
    found = is_point(*feature);
  }
  layer.ResetReading();
  return found;
}

OGRLayer& choose_points(GDALDataset& file, const std::string& wanted, const fs::path& path) {
  std::vector<std::string> names, others;
  std::vector<OGRLayer*> layers;
  for (OGRLayer* layer : file.GetLayers()) {
    others.emplace_back(quotable(layer->GetName()));
    if (!holds_points(*layer)) continue;
    names.emplace_back(layer->GetName());
    layers.push_back(layer);
  }
  if (layers.empty()) {
    throw InvalidInput(fmt::format(
        "'{}' holds no points (layers: {}): a seafloor needs soundings, a grid or a mesh",
        path.string(), fmt::join(others, ", ")));
  }
  if (const auto chosen = chosen_layer(wanted, names)) return *layers[*chosen];
  const auto soundings = std::find_if(names.begin(), names.end(), [](const std::string& name) {
    return lower(name) == "soundg" || lower(name) == "soundings";
  });
  if (soundings != names.end()) {
    return *layers[static_cast<std::size_t>(soundings - names.begin())];
  }
  if (layers.size() > 1) refuse_layers(path, names);
  return *layers.front();
}

/// The points of one layer, their z or the depth column's.
class PointReader {
 public:
  PointReader(OGRLayer& layer, const fs::path& path, std::optional<double> nodata)
      : layer_(layer), path_(path), nodata_(nodata), column_(depth_column(*layer.GetLayerDefn())) {}

  void read(SurfaceData& data, bool is_s57) {
    const bool has_z = any_height();
    if (!has_z && !column_) {
      throw InvalidInput(fmt::format(
          "'{}', layer '{}': the points have no z, and no column is named depth, z or elevation",
          path_.string(), quotable(layer_.GetName())));
    }
    for (const OGRFeatureUniquePtr& feature : layer_) {
      if (!is_point(*feature)) {
        ++skipped_;
        continue;
      }
      const std::optional<double> value = has_z ? std::nullopt : number(*feature);
      if (!has_z && !value) {
        ++skipped_;
        continue;
      }
      for_each_point(*feature, [&](const OGRPoint& p) {
        add(Vec3(p.getX(), p.getY(), has_z ? p.getZ() : *value), data);
      });
    }
    data.z_is_depth = has_z ? is_s57 : column_->is_depth;
    say(data, has_z);
  }

 private:
  template <class Use>
  static void for_each_point(const OGRFeature& feature, Use use) {
    const OGRGeometry* shape = feature.GetGeometryRef();
    if (wkbFlatten(shape->getGeometryType()) == wkbPoint) {
      if (!shape->IsEmpty()) use(*shape->toPoint());
      return;
    }
    for (const OGRPoint* p : *shape->toMultiPoint()) use(*p);
  }

  /// A z that is 0 everywhere is none.
  bool any_height() {
    bool found = false;
    layer_.ResetReading();
    for (const OGRFeatureUniquePtr& feature : layer_) {
      if (!is_point(*feature)) continue;
      for_each_point(*feature,
                     [&](const OGRPoint& p) { found = found || (p.Is3D() && p.getZ() != 0.0); });
      if (found) break;
    }
    layer_.ResetReading();
    return found;
  }

  [[nodiscard]] std::optional<double> number(const OGRFeature& feature) const {
    if (!feature.IsFieldSetAndNotNull(column_->field)) return {};
    const OGRFieldType type = feature.GetFieldDefnRef(column_->field)->GetType();
    if (type == OFTString) return to_finite_number(feature.GetFieldAsString(column_->field));
    return feature.GetFieldAsDouble(column_->field);
  }

  void add(const Vec3& p, SurfaceData& data) {
    if (!p.allFinite() || (nodata_ && p.z() == *nodata_)) {
      ++skipped_;
      return;
    }
    data.vertices.push_back(p);
  }

  void say(SurfaceData& data, bool has_z) const {
    if (!has_z) {
      data.notes.push_back(fmt::format("depths are those of the column '{}', z positive {}",
                                       quotable(column_->name), column_->is_depth ? "down" : "up"));
      if (column_->unit_m != 1.0) data.z_unit_m = column_->unit_m;
    } else if (column_) {
      data.notes.push_back(fmt::format("depths are the z of the points, not the column '{}'",
                                       quotable(column_->name)));
    }
    if (skipped_ > 0) {
      data.warnings.push_back(
          fmt::format("{} features have no depth or are no points: left out", skipped_));
    }
  }

  OGRLayer& layer_;
  const fs::path& path_;
  std::optional<double> nodata_;
  std::optional<DepthColumn> column_;
  std::size_t skipped_ = 0;
};

std::string crs_of_layer(OGRLayer& layer) {
  const OGRSpatialReference* crs = layer.GetSpatialRef();
  char* text = nullptr;
  std::string wkt;
  if (crs != nullptr && crs->exportToWkt(&text) == OGRERR_NONE) wkt = text;
  CPLFree(text);
  try {
    return wkt.empty() ? wkt : parse_crs(wkt);
  } catch (const UsageError&) {
    return {};
  }
}

}  // namespace

bool is_point_file(const fs::path& path) {
  constexpr std::array kVector = {".shp", ".gpkg", ".geojson", ".json", ".geojsonl",
                                  ".fgb", ".gml",  ".kml",     ".kmz",  ".tab",
                                  ".mif", ".000",  ".sqlite",  ".gpx",  ".dxf"};
  const std::string extension = lower(path.extension().string());
  if (std::find(kVector.begin(), kVector.end(), extension) == kVector.end()) return false;
  const QuietGdal quiet;
  const GDALDatasetUniquePtr file = open_vector(path);
  return file && file->GetLayerCount() > 0;
}

SurfaceData read_point_file(const fs::path& path, bool z_positive_down,
                            std::optional<double> nodata, const std::string& layer) {
  const QuietGdal quiet;
  const GDALDatasetUniquePtr file = open_vector(path);
  if (!file) {
    throw InvalidInput(fmt::format("'{}' cannot be read{}", path.string(), QuietGdal::why()));
  }
  OGRLayer& points = choose_points(*file, layer, path);
  SurfaceData data;
  data.format = file->GetDriverName();
  data.crs_wkt = crs_of_layer(points);
  PointReader(points, path, nodata).read(data, std::string_view(file->GetDriverName()) == "S57");
  if (data.z_is_depth && std::all_of(data.vertices.begin(), data.vertices.end(),
                                     [](const Vec3& v) { return v.z() <= 0.0; })) {
    data.z_is_depth = false;
    data.notes.emplace_back("the depths hold no positive value: taken as heights, z up");
  }
  keep_shoalest_places(data, z_positive_down || data.z_is_depth);
  if (data.vertices.size() < 3) {
    throw InvalidInput(
        fmt::format("'{}' holds {} soundings at different places; a surface needs "
                    "at least three",
                    path.string(), data.vertices.size()));
  }
  return data;
}

}  // namespace swathplan
