#include "io/exports/exportable_route.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/files/csv.h"
#include "io/files/lonlat.h"
#include "io/files/text.h"
#include "io/route/read_route.h"
#include "io/route/route_csv.h"
#include "io/route/route_gpkg_read.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

/// Coordinates that differ by less (1 m) are the same place. The rounding of files explains them.
constexpr double kSamePlaceDeg = 1e-5;

/// Exports hold no fans. So any fan will do where a file has none.
const RouteDefaults kDefaults{
    .fan = FanAngles{.port = Angle::degrees(60), .starboard = Angle::degrees(60)}};

Frame frame_of(const std::string& crs_wkt) {
  return {.origin = Vec2::Zero(), .metres_per_unit = metres_per_unit(crs_wkt), .crs_wkt = crs_wkt};
}

Frame utm_frame(const Vec2& lonlat) { return frame_of(utm_crs(lonlat.x(), lonlat.y())); }

/// The columns lon_deg,lat_deg of a CSV file; empty if they are missing or a cell is not a number.
std::vector<Vec2> lonlat_columns(std::string_view text) {
  const CsvTable table = parse_csv(text);
  const auto column = [&](const char* name) {
    return static_cast<std::size_t>(std::find(table.header.begin(), table.header.end(), name) -
                                    table.header.begin());
  };
  const std::size_t lon = column("lon_deg");
  const std::size_t lat = column("lat_deg");
  std::vector<Vec2> result;
  for (const auto& row : table.rows) {
    if (std::max(lon, lat) >= std::min(row.fields.size(), table.header.size())) return {};
    const auto x = to_finite_number(row.fields[lon]);
    const auto y = to_finite_number(row.fields[lat]);
    if (!x || !y) return {};
    result.emplace_back(*x, *y);
  }
  return result;
}

void check_same_place(const PlacedRoute& placed, const std::vector<Vec2>& lonlat,
                      const std::string& file) {
  if (lonlat.empty()) return;
  const auto converted = LonLat(placed.frame).from_local(positions(placed.route.waypoints));
  for (std::size_t i = 0; i < lonlat.size(); ++i) {
    if ((converted[i] - lonlat[i]).norm() < kSamePlaceDeg) continue;
    throw InvalidInput(fmt::format(
        "'{}', waypoint {}: x_m,y_m in {} lie at ({:.6f}, {:.6f}), but lon_deg,lat_deg say "
        "({:.6f}, {:.6f}): leave out <CRS>, or give that of the seafloor's file",
        file, i, crs_name(placed.frame.crs_wkt), converted[i].x(), converted[i].y(), lonlat[i].x(),
        lonlat[i].y()));
  }
}

/// Reads the route of a file into a frame.
class FrameReader {
 public:
  FrameReader(const std::filesystem::path& path, std::vector<std::string>& notes)
      : path_(path), notes_(notes) {}

  [[nodiscard]] PlacedRoute read(const Frame& frame) const {
    ImportedRoute imported = read_route(path_, frame, kDefaults);
    notes_ = std::move(imported.leg_notes);  // without the note on fans: exports hold none
    notes_.insert(notes_.end(), imported.notes.begin(), imported.notes.end());
    return {std::move(imported.route), frame, nullptr};
  }

 private:
  const std::filesystem::path& path_;
  std::vector<std::string>& notes_;
};

/// True if the file says nothing but longitude and latitude, or a CRS of its own.
bool says_its_place(RouteFormat format, std::string_view text) {
  return is_always_lonlat(format) ||
         (format == RouteFormat::geojson && text.find("\"local_frame\"") == std::string_view::npos);
}

}  // namespace

ExportableRoute read_exportable_route(const std::filesystem::path& path,
                                      const std::string& crs_wkt) {
  if (is_geographic(crs_wkt)) {
    throw UsageError(fmt::format("<CRS> {} is in degrees; must be the projected one of x_m,y_m",
                                 crs_name(crs_wkt)));
  }
  ExportableRoute result;
  const FrameReader reader(path, result.notes);
  if (is_route_package(path)) {
    std::string crs = crs_wkt.empty() ? package_crs(path) : crs_wkt;
    if (is_geographic(crs)) {
      const PlacedRoute degrees = reader.read(frame_of(wgs84_crs()));
      crs = utm_crs(degrees.route.waypoints.front().position.x(),
                    degrees.route.waypoints.front().position.y());
    }
    result.planar = reader.read(frame_of(crs));
    result.geographic = result.planar;
    return result;
  }
  const std::string text = read_text(path);
  const RouteFormat format = route_format(text);
  if (!crs_wkt.empty() || says_its_place(format, text)) {
    Frame frame = frame_of(crs_wkt);
    if (crs_wkt.empty()) {
      const PlacedRoute degrees = reader.read(frame_of(wgs84_crs()));
      frame = utm_frame(degrees.route.waypoints.front().position);
    }
    result.planar = reader.read(frame);
    if (crs_wkt.empty()) {
      result.notes.push_back(
          fmt::format("eastings and northings are those of {}: give another "
                      "with <CRS> EPSG:n",
                      crs_name(frame.crs_wkt)));
    } else if (format == RouteFormat::csv) {
      check_same_place(result.planar, lonlat_columns(text), path.string());
    }
    result.geographic = result.planar;
    return result;
  }
  Frame plain;
  if (format == RouteFormat::csv) plain.metres_per_unit = route_csv_unit_m(text);
  result.planar = reader.read(plain);
  result.geographic = result.planar;
  const std::vector<Vec2> lonlat =
      format == RouteFormat::csv ? lonlat_columns(text) : std::vector<Vec2>();
  if (lonlat.empty()) return result;
  result.geographic.frame = utm_frame(lonlat.front());
  const std::vector<Vec2> local = LonLat(result.geographic.frame).to_local(lonlat);
  for (std::size_t i = 0; i < local.size(); ++i) {
    result.geographic.route.waypoints[i].position = local[i];
  }
  return result;
}

}  // namespace swathplan
