#include <fmt/format.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "io/files/crs.h"
#include "io/files/text.h"
#include "io/files/units.h"
#include "io/grids/value_meaning_internal.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

/// A CRS that PROJ cannot place is as good as none; inspect says 'none'.
std::string placed(const std::string& text) {
  try {
    return parse_crs(text);
  } catch (const UsageError&) {
    return {};
  }
}

/// True if an axis of the file has longitudes by its unit, as CF wants them.
bool has_longitudes(GDALDataset& file) {
  constexpr std::string_view kUnits = "#units=degree";
  for (char** item = file.GetMetadata(); item != nullptr && *item != nullptr; ++item) {
    const std::string text = lower(*item);
    const std::size_t at = text.find(kUnits);
    if (at == std::string::npos) continue;
    const std::string unit = text.substr(at + 7);
    if (unit == "degrees_east" || unit == "degree_east" || unit == "degrees_e" ||
        unit == "degree_e" || unit == "degreese" || unit == "degreee") {
      return true;
    }
  }
  return false;
}

/// The first code of a reference system in the metadata of a BAG: a bare number is one of EPSG's.
std::string code_in_bag(GDALDataset& file) {
  char** list = file.GetMetadata("xml:BAG");
  if (list == nullptr || *list == nullptr) return {};
  const std::string xml = *list;
  std::size_t at = xml.find("eferenceSystemI");
  at = at == std::string::npos ? at : xml.find("RS_Identifier", at);
  at = at == std::string::npos ? at : xml.find("CharacterString", at);
  at = at == std::string::npos ? at : xml.find('>', at);
  if (at == std::string::npos) return {};
  std::string code(trim(std::string_view(xml).substr(at + 1, xml.find('<', at) - at - 1)));
  const std::size_t colon = code.find_last_of(':');
  if (colon != std::string::npos) code.erase(0, colon + 1);
  const bool number = !code.empty() && std::all_of(code.begin(), code.end(),
                                                   [](char c) { return c >= '0' && c <= '9'; });
  return number ? "EPSG:" + code : std::string();
}

std::string attribute(GDALRasterBand& band, const char* name) {
  const char* value = band.GetMetadataItem(name);
  return value == nullptr ? std::string() : lower(trim(value));
}

/// No ocean is as deep, metres.
constexpr double kDeeperThanAny = 12'000.0;

/// True if values in units of `metres` reach deeper than any ocean, and in metres they do not: the
/// file names the unit of its other axes.
bool is_no_unit_of_depths(const SurfaceData& data, double metres) {
  double largest = 0.0;
  for (const Vec3& v : data.vertices) largest = std::max(largest, std::abs(v.z()));
  return largest <= kDeeperThanAny && largest * metres > kDeeperThanAny;
}

/// What says that z is positive down; empty if nothing does.
std::string word_of_down(GDALDataset& file, GDALRasterBand& band) {
  if (attribute(band, "positive") == "down") return "'positive: down'";
  if (attribute(band, "positive") == "up") return {};
  const std::string name = attribute(band, "standard_name");
  if (name == "depth" || name.starts_with("sea_floor_depth")) return "'" + name + "'";
  const OGRSpatialReference* crs = file.GetSpatialRef();
  if (crs == nullptr || crs->IsVertical() == 0) return {};
  OGRAxisOrientation sense = OAO_Other;
  const bool has_axis = crs->GetAxis("VERT_CS", 0, &sense) != nullptr;
  const char* vertical = crs->GetAttrValue("VERT_CS");
  if (!has_axis || sense != OAO_Down) return {};
  return fmt::format("the vertical reference system '{}'", vertical == nullptr ? "" : vertical);
}

/// Metres in the unit of the vertical reference system.
std::optional<double> unit_of_vertical_crs(GDALDataset& file) {
  const OGRSpatialReference* crs = file.GetSpatialRef();
  if (crs == nullptr || crs->IsVertical() == 0) return {};
  const double unit = crs->GetTargetLinearUnits("VERT_CS");
  if (!(unit > 0.0)) return {};
  return unit;
}

}  // namespace

std::string crs_of_grid(GDALDataset& file, SurfaceData& data) {
  const OGRSpatialReference* crs = file.GetSpatialRef();
  char* text = nullptr;
  std::string wkt;
  if (crs != nullptr && crs->exportToWkt(&text) == OGRERR_NONE) wkt = placed(text);
  CPLFree(text);
  if (!wkt.empty()) return wkt;
  if (has_longitudes(file)) {
    data.notes.emplace_back(
        "the axes are in degrees_east and degrees_north: taken as WGS 84 longitude and latitude");
    return wgs84_crs();
  }
  if (std::string_view(file.GetDriverName()) == "BAG") {
    const std::string code = code_in_bag(file);
    if (!code.empty()) return placed(code);
  }
  return {};
}

void find_meaning_of_z(GDALDataset& file, GDALRasterBand& band, SurfaceData& data) {
  const std::string unit = band.GetUnitType() != nullptr ? band.GetUnitType() : "";
  std::optional<double> metres = metres_in(unit);
  if (unit.empty()) {
    metres = unit_of_vertical_crs(file);
  } else if (!metres) {
    data.warnings.push_back(
        fmt::format("the file says its values are in '{}'; if so, set <z unit>", unit));
  }
  const std::string named = unit.empty() ? "the unit of its vertical system" : unit;
  if (metres && is_no_unit_of_depths(data, *metres)) {
    data.warnings.push_back(
        fmt::format("the file says its values are in {} ({:.7g} m), which no ocean is deep enough "
                    "for: taken as metres; if they are not, set <z unit>",
                    named, *metres));
  } else if (metres && *metres != 1.0) {
    data.z_unit_m = metres;
    data.notes.push_back(fmt::format("z is in {}, as the file says: {:.7g} m", named, *metres));
  }
  // A BAG holds elevations by its standard, whatever the axis in its metadata says.
  if (std::string_view(file.GetDriverName()) == "BAG") return;
  const std::string word = word_of_down(file, band);
  if (word.empty()) return;
  const auto above = std::count_if(data.vertices.begin(), data.vertices.end(),
                                   [](const Vec3& v) { return v.z() > 0.0; });
  if (2 * static_cast<std::size_t>(above) > data.vertices.size()) {
    data.z_is_depth = true;
    data.notes.push_back(fmt::format("z is positive down, as {} of the file says", word));
  } else {
    data.warnings.push_back(fmt::format(
        "{} of the file says that z is positive down, but most values are not above 0: taken as "
        "heights, positive up; if they are depths and most of the area is land, add <z positive> "
        "down",
        word));
  }
}

}  // namespace swathplan
