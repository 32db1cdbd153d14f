#include "io/exports/route_dxf.h"

#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include "io/files/atomic_file.h"
#include "io/files/gdal_at_home.h"
#include "io/files/quiet_gdal.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

bool add_leg(OGRLayer& layer, const Route& route, const Leg& leg, const Frame& frame) {
  OGRLineString line;
  for (std::size_t i = leg.first; i <= leg.last; ++i) {
    const Vec2 p = frame.to_file(route.waypoints[i].position);
    line.addPoint(p.x(), p.y());
  }
  const OGRFeatureUniquePtr feature(OGRFeature::CreateFeature(layer.GetLayerDefn()));
  feature->SetField("Layer", std::string(name(route.waypoints[leg.first].kind)).c_str());
  feature->SetGeometry(&line);
  return layer.CreateFeature(feature.get()) == OGRERR_NONE;
}

bool write(const std::string& path, const Route& route, const Frame& frame) {
  register_gdal();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("DXF");
  if (driver == nullptr) return false;
  const GDALDatasetUniquePtr drawing(driver->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  OGRLayer* layer = drawing ? drawing->CreateLayer("entities") : nullptr;
  if (layer == nullptr) return false;
  for (const Leg& leg : legs(route)) {
    if (!add_leg(*layer, route, leg, frame)) return false;
  }
  return true;
}

}  // namespace

void write_route_dxf(const std::filesystem::path& path, const Route& route, const Frame& frame) {
  write_through_memory(path, [&](const std::string& drawing) {
    const QuietGdal quiet;
    if (!write(drawing, route, frame)) {
      throw InvalidInput(fmt::format("cannot write '{}'{}", path.string(), QuietGdal::why()));
    }
  });
}

}  // namespace swathplan
