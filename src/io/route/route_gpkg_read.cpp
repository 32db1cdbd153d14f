#include "io/route/route_gpkg_read.h"

#include <cpl_conv.h>
#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <array>
#include <cmath>
#include <fstream>

#include "io/files/crs.h"
#include "io/files/gdal_at_home.h"
#include "io/files/quiet_gdal.h"
#include "io/route/foreign_route.h"
#include "io/route/route_csv.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

/// The columns of route.csv that a layer of waypoints has.
constexpr std::array kWaypointColumns = {"seq",      "line",      "kind",   "log",   "port_deg",
                                         "stbd_deg", "speed_mps", "region", "status"};

GDALDatasetUniquePtr open_package(const std::filesystem::path& path) {
  register_gdal();
  const char* const drivers[] = {"GPKG", nullptr};
  GDALDatasetUniquePtr data(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY,
                                              drivers, nullptr, nullptr));
  if (!data) {
    throw InvalidInput(fmt::format("'{}' cannot be read as a GeoPackage with a route{}",
                                   path.string(), QuietGdal::why()));
  }
  return data;
}

OGRLayer* waypoints_of(GDALDataset& data) {
  OGRLayer* layer = data.GetLayerByName("waypoints");
  if (layer == nullptr || wkbFlatten(layer->GetGeomType()) != wkbPoint) return nullptr;
  for (const char* name : {"kind", "log", "port_deg", "stbd_deg", "speed_mps"}) {
    if (layer->GetLayerDefn()->GetFieldIndex(name) < 0) return nullptr;
  }
  return layer;
}

std::string wkt_of(const OGRLayer& layer) {
  const OGRSpatialReference* crs = const_cast<OGRLayer&>(layer).GetSpatialRef();
  if (crs == nullptr || crs->IsLocal() || (!crs->IsProjected() && !crs->IsGeographic())) return {};
  char* text = nullptr;
  std::string wkt;
  if (crs->exportToWkt(&text) == OGRERR_NONE) wkt = parse_crs(text);
  CPLFree(text);
  return wkt;
}

/// Brings places of a layer to the coordinates of the seafloor's file.
class PackagePlaces {
 public:
  PackagePlaces(const OGRLayer& layer, const Frame& frame) {
    const std::string wkt = wkt_of(layer);
    if (!wkt.empty() && !frame.crs_wkt.empty() && wkt != frame.crs_wkt) {
      to_file_.emplace(wkt, frame.crs_wkt);
    }
  }
  [[nodiscard]] Vec2 operator()(double x, double y) const {
    return to_file_ ? (*to_file_)(Vec2(x, y)) : Vec2(x, y);
  }

 private:
  std::optional<CrsTransform> to_file_;
};

/// The layer as the text of a route.csv, whose reader checks it.
std::string as_csv(OGRLayer& layer, const Frame& frame) {
  const PackagePlaces places(layer, frame);
  std::string text = "x_m,y_m";
  std::vector<int> fields;
  for (const char* name : kWaypointColumns) {
    const int field = layer.GetLayerDefn()->GetFieldIndex(name);
    if (field < 0) continue;
    fields.push_back(field);
    text += std::string(",") + name;
  }
  text += "\n";
  for (const OGRFeatureUniquePtr& feature : layer) {
    const OGRGeometry* geometry = feature->GetGeometryRef();
    const bool point = geometry != nullptr && wkbFlatten(geometry->getGeometryType()) == wkbPoint;
    const Vec2 p = point ? places(geometry->toPoint()->getX(), geometry->toPoint()->getY())
                         : Vec2::Constant(std::nan(""));
    text += fmt::format("{},{}", p.x(), p.y());
    for (const int field : fields) {
      const bool set = feature->IsFieldSetAndNotNull(field) != 0;
      const bool real = layer.GetLayerDefn()->GetFieldDefn(field)->GetType() == OFTReal;
      text += !set   ? ","
              : real ? fmt::format(",{}", feature->GetFieldAsDouble(field))
                     : fmt::format(",{}", feature->GetFieldAsString(field));
    }
    text += "\n";
  }
  return text;
}

void add_package_lines(const OGRGeometry& geometry, const PackagePlaces& places,
                       ForeignRoute& route) {
  const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
  if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection) != 0) {
    for (const OGRGeometry* part : *geometry.toGeometryCollection()) {
      add_package_lines(*part, places, route);
    }
  } else if (type == wkbLineString) {
    route.parts.emplace_back();
    for (const OGRPoint& p : *geometry.toLineString()) {
      route.parts.back().push_back(
          {.place = places(p.getX(), p.getY()), .line = std::nullopt, .speed_mps = std::nullopt});
    }
  }
}

}  // namespace

bool is_route_package(const std::filesystem::path& path) {
  constexpr std::string_view kMagic = "SQLite format 3";
  std::array<char, kMagic.size()> head{};
  std::ifstream in(path, std::ios::binary);
  in.read(head.data(), head.size());
  return std::string_view(head.data(), head.size()) == kMagic;
}

std::string package_crs(const std::filesystem::path& path) {
  const QuietGdal quiet;
  const GDALDatasetUniquePtr data = open_package(path);
  if (const OGRLayer* layer = waypoints_of(*data)) return wkt_of(*layer);
  return data->GetLayerCount() > 0 ? wkt_of(*data->GetLayer(0)) : std::string();
}

ImportedRoute read_route_gpkg(const std::filesystem::path& path, const Frame& frame,
                              const RouteDefaults& defaults) {
  const QuietGdal quiet;
  const GDALDatasetUniquePtr data = open_package(path);
  if (OGRLayer* layer = waypoints_of(*data)) {
    return parse_route_csv(as_csv(*layer, frame), path.string(), frame, defaults);
  }
  ForeignRoute route{.in_degrees = false, .parts = {}, .notes = {}};
  for (OGRLayer* layer : data->GetLayers()) {
    const PackagePlaces places(*layer, frame);
    for (const OGRFeatureUniquePtr& feature : *layer) {
      if (feature->GetGeometryRef() == nullptr) continue;
      const std::unique_ptr<OGRGeometry> straight(feature->GetGeometryRef()->getLinearGeometry());
      if (straight) add_package_lines(*straight, places, route);
    }
  }
  if (route.parts.empty()) {
    throw InvalidInput(fmt::format(
        "'{}' holds no line: a route is a layer of lines, or the layer 'waypoints' of this program",
        path.string()));
  }
  return placed(std::move(route), path.string(), frame, defaults);
}

}  // namespace swathplan
