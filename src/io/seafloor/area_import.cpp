#include "io/seafloor/area_import.h"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogr_geometry.h>
#include <ogr_spatialref.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "io/files/crs.h"
#include "io/files/quiet_gdal.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

namespace fs = std::filesystem;

/// Polygons of a layer in file coordinates, each as its rings, and the layer's CRS.
struct LayerPolygons {
  std::vector<std::vector<Ring>> polygons;
  std::string crs_wkt;
};

GDALDatasetUniquePtr open_vectors(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error)) {
    throw InvalidInput(
        fmt::format("'{}' does not exist; check the name and the folder", path.string()));
  }
  // Some formats are folders; a folder of anything else is a slip of the finger.
  const bool folder = fs::is_directory(path, error);
  GDALAllRegister();
  GDALDatasetUniquePtr data(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY));
  if (!data && folder) {
    throw InvalidInput(fmt::format("'{}' is a folder; name the file in it", path.string()));
  }
  if (!data) {
    throw InvalidInput(
        fmt::format("'{}' cannot be read as polygons{}; use GeoJSON, GeoPackage, Shapefile or KML",
                    path.string(), QuietGdal::why()));
  }
  return data;
}

Ring ring_of(const OGRLinearRing& line) {
  Ring ring;
  for (int i = 0; i < line.getNumPoints(); ++i) ring.emplace_back(line.getX(i), line.getY(i));
  if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  return ring;
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
  CPLErrorReset();
  if (polygon.IsValid() == 0) {
    throw InvalidInput(fmt::format(
        "'{}', feature {}: the polygon crosses or touches itself{}; mend it in a GIS ('fix "
        "geometries')",
        path.string(), feature, QuietGdal::why()));
  }
}

void collect(const OGRGeometry& geometry, const fs::path& path, long long feature,
             LayerPolygons& found) {
  const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
  if (type == wkbPolygon) {
    const OGRPolygon& polygon = *geometry.toPolygon();
    if (polygon.IsEmpty() != 0) return;
    check_polygon(polygon, path, feature);
    std::vector<Ring> rings;
    for (const OGRLinearRing* ring : polygon) rings.push_back(ring_of(*ring));
    found.polygons.push_back(std::move(rings));
  } else if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection) != 0) {
    for (const OGRGeometry* part : *geometry.toGeometryCollection()) {
      collect(*part, path, feature, found);
    }
  }
}

LayerPolygons read_layer(OGRLayer& layer, const fs::path& path) {
  LayerPolygons found;
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
  }
  return found;
}

bool all_degrees(const LayerPolygons& layer) {
  for (const auto& polygon : layer.polygons) {
    for (const Ring& ring : polygon) {
      for (const Vec2& p : ring) {
        if (std::abs(p.x()) > 360.0 || std::abs(p.y()) > 90.0) return false;
      }
    }
  }
  return true;
}

/// GeoJSON without a CRS counts as WGS 84; one that holds eastings and northings is the seafloor's.
void to_local(LayerPolygons& layer, const Frame& frame) {
  const bool same = layer.crs_wkt.empty() || frame.crs_wkt.empty() ||
                    (is_geographic(layer.crs_wkt) && !all_degrees(layer));
  const CrsTransform* transform = nullptr;
  std::optional<CrsTransform> to_frame;
  if (!same) transform = &to_frame.emplace(layer.crs_wkt, frame.crs_wkt);
  for (auto& polygon : layer.polygons) {
    for (Ring& ring : polygon) {
      if (transform != nullptr) ring = (*transform)(ring);
      for (Vec2& p : ring) p = frame.to_local(p);
    }
  }
}

std::string text_of(const Box2& box) {
  return fmt::format("x {:.1f} to {:.1f}, y {:.1f} to {:.1f}", box.min.x(), box.max.x(),
                     box.min.y(), box.max.y());
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
      "the polygons of '{}' ({}) do not meet the seafloor ({}); check their coordinate reference "
      "system",
      path.string(), text_of(in_file(box)), text_of(in_file(data))));
}

}  // namespace

Area import_area(const fs::path& path, const Frame& frame, std::optional<Box2> data_extent) {
  const QuietGdal quiet;
  const GDALDatasetUniquePtr data = open_vectors(path);
  Area area;
  std::size_t count = 0;
  for (int i = 0; i < data->GetLayerCount(); ++i) {
    LayerPolygons layer = read_layer(*data->GetLayer(i), path);
    to_local(layer, frame);
    count += layer.polygons.size();
    for (const std::vector<Ring>& rings : layer.polygons) {
      area = unite(area, from_rings(rings, false));
    }
  }
  if (count == 0) {
    throw InvalidInput(fmt::format(
        "'{}' holds no polygon; draw the area as a polygon (lines and points do not count)",
        path.string()));
  }
  if (area.empty()) {
    throw InvalidInput(fmt::format("the polygons of '{}' have no area", path.string()));
  }
  if (data_extent && !data_extent->empty()) check_meets(area, *data_extent, frame, path);
  return area;
}

}  // namespace swathplan
