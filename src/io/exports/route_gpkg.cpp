#include "io/exports/route_gpkg.h"

#include <cpl_conv.h>
#include <cpl_string.h>
#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include "io/files/atomic_file.h"
#include "io/files/gdal_at_home.h"
#include "io/files/quiet_gdal.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

/// GeoPackages hold the time when they were written. A fixed one keeps the bytes the same.
constexpr const char* kNoDate = "2000-01-01T00:00:00.000Z";

class FixedDate {
 public:
  FixedDate() { CPLSetThreadLocalConfigOption("OGR_CURRENT_DATE", kNoDate); }
  ~FixedDate() { CPLSetThreadLocalConfigOption("OGR_CURRENT_DATE", nullptr); }
  FixedDate(const FixedDate&) = delete;
  FixedDate& operator=(const FixedDate&) = delete;
};

bool add_fields(OGRLayer& layer) {
  const std::pair<const char*, OGRFieldType> fields[] = {
      {"seq", OFTInteger},    {"line", OFTInteger},   {"kind", OFTString},
      {"log", OFTInteger},    {"port_deg", OFTReal},  {"stbd_deg", OFTReal},
      {"speed_mps", OFTReal}, {"region", OFTInteger}, {"status", OFTString}};
  for (const auto& [name, type] : fields) {
    OGRFieldDefn field(name, type);
    if (layer.CreateField(&field) != OGRERR_NONE) return false;
  }
  return true;
}

void fill(OGRFeature& feature, std::size_t seq, const Waypoint& w) {
  feature.SetField("seq", static_cast<int>(seq));
  if (w.line) feature.SetField("line", *w.line);
  feature.SetField("kind", std::string(name(w.kind)).c_str());
  feature.SetField("log", w.log ? 1 : 0);
  if (w.fan) {
    feature.SetField("port_deg", w.fan->port.deg());
    feature.SetField("stbd_deg", w.fan->starboard.deg());
  }
  feature.SetField("speed_mps", w.speed_mps);
  if (w.region) feature.SetField("region", *w.region);
  if (!w.feasible) feature.SetField("status", "infeasible");
}

bool add_legs(OGRLayer& layer, const Route& route, const Frame& frame) {
  std::size_t number = 0;
  for (const Leg& leg : legs(route)) {
    OGRLineString line;
    for (std::size_t i = leg.first; i <= leg.last; ++i) {
      const Vec2 p = frame.to_file(route.waypoints[i].position);
      line.addPoint(p.x(), p.y());
    }
    const OGRFeatureUniquePtr feature(OGRFeature::CreateFeature(layer.GetLayerDefn()));
    fill(*feature, number++, route.waypoints[leg.first]);
    feature->SetGeometry(&line);
    if (layer.CreateFeature(feature.get()) != OGRERR_NONE) return false;
  }
  return true;
}

bool add_waypoints(OGRLayer& layer, const Route& route, const Frame& frame) {
  for (std::size_t i = 0; i < route.waypoints.size(); ++i) {
    const Vec2 p = frame.to_file(route.waypoints[i].position);
    OGRPoint point(p.x(), p.y());
    const OGRFeatureUniquePtr feature(OGRFeature::CreateFeature(layer.GetLayerDefn()));
    fill(*feature, i, route.waypoints[i]);
    feature->SetGeometry(&point);
    if (layer.CreateFeature(feature.get()) != OGRERR_NONE) return false;
  }
  return true;
}

bool write_package(const std::string& path, const Route& route, const Frame& frame) {
  register_gdal();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GPKG");
  if (driver == nullptr) return false;
  const GDALDatasetUniquePtr data(driver->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  if (!data) return false;
  OGRSpatialReference crs;
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const bool placed =
      !frame.crs_wkt.empty() && crs.importFromWkt(frame.crs_wkt.c_str()) == OGRERR_NONE;
  OGRLayer* lines = data->CreateLayer("legs", placed ? &crs : nullptr, wkbLineString);
  OGRLayer* points = data->CreateLayer("waypoints", placed ? &crs : nullptr, wkbPoint);
  return lines != nullptr && points != nullptr && add_fields(*lines) && add_fields(*points) &&
         data->StartTransaction() == OGRERR_NONE && add_legs(*lines, route, frame) &&
         add_waypoints(*points, route, frame) && data->CommitTransaction() == OGRERR_NONE;
}

}  // namespace

void write_route_gpkg(const std::filesystem::path& path, const Route& route, const Frame& frame) {
  const FixedDate date;
  write_through_memory(path, [&](const std::string& package) {
    const QuietGdal quiet;
    if (!write_package(package, route, frame)) {
      throw InvalidInput(fmt::format("cannot write '{}'{}", path.string(), QuietGdal::why()));
    }
  });
}

}  // namespace swathplan
