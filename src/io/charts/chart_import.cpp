#include "io/charts/chart_import.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <map>

#include "io/charts/chart_file_internal.h"
#include "io/charts/chart_mesh_internal.h"
#include "io/charts/chart_shapes_internal.h"
#include "io/charts/hazard_buffers.h"
#include "io/files/crs.h"
#include "io/files/file_hash.h"
#include "io/files/gdal_at_home.h"
#include "io/files/quiet_gdal.h"
#include "io/files/text.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

namespace fs = std::filesystem;

/// A chart's depths in its own coordinates, and what was found on the way.
class DepthsReader {
 public:
  DepthsReader(GDALDataset& file, const fs::path& path) : file_(file), path_(path) {}

  ChartDepths read(SurfaceData& data) {
    for (const char* name : {"DEPARE", "DRGARE"}) read_areas(name);
    if (chart_.areas.empty()) {
      throw InvalidInput(
          fmt::format("'{}' holds no depth area (DEPARE) with a depth: no ground of it is known",
                      path_.string()));
    }
    const std::size_t outline = chart_.places.size();
    read_contours();
    read_soundings();
    (void)outline;
    say(data);
    return std::move(chart_);
  }
  [[nodiscard]] const std::string& crs_wkt() const { return crs_wkt_; }

 private:
  std::uint32_t place_of(const Vec2& at) {
    const auto [found, is_new] =
        index_.try_emplace({at.x(), at.y()}, static_cast<std::uint32_t>(chart_.places.size()));
    if (is_new) {
      chart_.places.push_back(at);
      chart_.soundings.emplace_back();
      chart_.contours.emplace_back();
    }
    return found->second;
  }

  void take_crs(OGRLayer& layer) {
    const OGRSpatialReference* crs = layer.GetSpatialRef();
    char* text = nullptr;
    if (!crs_wkt_.empty() || crs == nullptr) return;
    if (crs->exportToWkt(&text) == OGRERR_NONE) crs_wkt_ = parse_crs(text);
    CPLFree(text);
  }

  template <class Use>
  void for_each_feature(const char* name, Use use) {
    OGRLayer* layer = layer_named(file_, name);
    if (layer == nullptr) return;
    take_crs(*layer);
    layer->ResetReading();
    for (const OGRFeatureUniquePtr& feature : *layer) {
      use(*feature, shapes_of(feature->GetGeometryRef()));
    }
  }

  void read_areas(const char* name) {
    for_each_feature(name, [&](const OGRFeature& feature, const ChartShapes& shapes) {
      const std::optional<double> shoal = number_in(feature, "DRVAL1");
      if (!shoal) {
        without_range_ += shapes.polygons.size();
        return;
      }
      const std::optional<double> deep = number_in(feature, "DRVAL2");
      for (const std::vector<Ring>& rings : shapes.polygons) {
        DepthArea& area = chart_.areas.emplace_back();
        area.shoal_m = *shoal;
        if (deep) area.deep_m = std::max(*deep, *shoal);
        for (const Ring& ring : rings) {
          auto& places = area.rings.emplace_back();
          for (const Vec2& p : ring) places.push_back(place_of(p));
        }
      }
    });
  }

  void read_contours() {
    for_each_feature("DEPCNT", [&](const OGRFeature& feature, const ChartShapes& shapes) {
      const std::optional<double> depth = number_in(feature, "VALDCO");
      if (!depth) return;
      contours_ += shapes.lines.size();
      for (const std::vector<Vec2>& line : shapes.lines) {
        for (const Vec2& p : line) {
          std::optional<double>& at = chart_.contours[place_of(p)];
          at = at ? std::min(*at, *depth) : *depth;
        }
      }
    });
  }

  void read_soundings() {
    for_each_feature("SOUNDG", [&](const OGRFeature& feature, const ChartShapes& shapes) {
      const std::optional<double> depth = number_in(feature, "DEPTH");
      for (const Vec3& p : shapes.points) {
        std::optional<double>& at = chart_.soundings[place_of(p.head<2>())];
        const double here = depth.value_or(p.z());
        at = at ? std::min(*at, here) : here;
        ++soundings_;
      }
    });
  }

  void say(SurfaceData& data) const {
    data.notes.push_back(fmt::format(
        "from {} soundings, {} contours and {} depth areas; land and unsurveyed areas are no "
        "seafloor",
        soundings_, contours_, chart_.areas.size()));
    if (without_range_ > 0) {
      data.warnings.push_back(fmt::format(
          "{} depth areas do not say how deep they are: taken as unknown ground", without_range_));
    }
  }

  GDALDataset& file_;
  const fs::path& path_;
  ChartDepths chart_;
  std::map<std::pair<double, double>, std::uint32_t> index_;
  std::string crs_wkt_;
  std::size_t soundings_ = 0, contours_ = 0, without_range_ = 0;
};

/// Metres of the UTM zone at the middle of the chart, where triangles keep their shape.
std::vector<Vec2> in_metres(const std::vector<Vec2>& places, const std::string& crs) {
  if (!is_geographic(crs)) return places;
  Box2 box;
  for (const Vec2& p : places) box.extend(p);
  const Vec2 middle = CrsTransform(crs, wgs84_crs())(0.5 * (box.min + box.max));
  return CrsTransform(crs, utm_crs(middle.x(), middle.y()))(places);
}

/// The mesh's new places in the chart's coordinates: where its corners' mean lies. New places stand
/// within one triangle or on one edge, so a mean of coordinates is exact enough there.
std::vector<Vec2> in_degrees(const ChartMesh& mesh, const std::vector<Vec2>& known,
                             const std::string& crs) {
  if (!is_geographic(crs)) return mesh.places;
  std::vector<Vec2> places = known;
  if (mesh.places.size() == known.size()) return places;
  Box2 box;
  for (const Vec2& p : known) box.extend(p);
  const Vec2 middle = CrsTransform(crs, wgs84_crs())(0.5 * (box.min + box.max));
  const std::vector<Vec2> added(mesh.places.begin() + static_cast<std::ptrdiff_t>(known.size()),
                                mesh.places.end());
  const std::vector<Vec2> back = CrsTransform(utm_crs(middle.x(), middle.y()), crs)(added);
  places.insert(places.end(), back.begin(), back.end());
  return places;
}

void keep_used(const ChartMesh& mesh, const std::vector<Vec2>& places, SurfaceData& data) {
  constexpr std::uint32_t kUnused = 0xffffffffU;
  std::vector<std::uint32_t> index(places.size(), kUnused);
  data.faces = mesh.faces;
  for (auto& face : data.faces) {
    for (std::uint32_t& v : face) {
      if (index[v] == kUnused) {
        index[v] = static_cast<std::uint32_t>(data.vertices.size());
        data.vertices.emplace_back(places[v].x(), places[v].y(), mesh.depths[v]);
      }
      v = index[v];
    }
  }
}

/// What of the hazards a plan would keep off, counted a class.
void note_hazards(GDALDataset& file, SurfaceData& data) {
  std::vector<std::string> found;
  for (const HazardClass& c : kHazardClasses) {
    OGRLayer* layer = layer_named(file, c.layer);
    const auto count = layer == nullptr ? 0 : layer->GetFeatureCount();
    if (count > 0) found.push_back(fmt::format("{} {}", count, c.layer));
  }
  if (!found.empty()) data.notes.push_back(fmt::format("hazards: {}", fmt::join(found, ", ")));
}

}  // namespace

std::string chart_hash(const fs::path& path) {
  std::string hash = file_hash(path);
  if (path.extension() != ".000") return hash;
  for (const int number : updates_beside(path)) {
    fs::path update = path;
    hash += "+" + file_hash(update.replace_extension(fmt::format("{:03}", number)));
  }
  return hash;
}

bool is_chart(const fs::path& path) {
  constexpr std::array kMayBe = {".gpkg", ".sqlite", ".gdb", ".gml"};
  const std::string extension = lower(path.extension().string());
  if (extension == ".000") return true;
  if (std::find(kMayBe.begin(), kMayBe.end(), extension) == kMayBe.end()) return false;
  const QuietGdal quiet;
  register_gdal();
  const GDALDatasetUniquePtr file(
      GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY));
  return file && layer_named(*file, "DEPARE") != nullptr &&
         (layer_named(*file, "SOUNDG") != nullptr || layer_named(*file, "DEPCNT") != nullptr);
}

SurfaceData read_chart(const fs::path& path) {
  const QuietGdal quiet;
  ChartCell cell;
  const GDALDatasetUniquePtr file = open_chart(path, cell);
  SurfaceData data;
  data.format = file->GetDriverName();
  data.notes.push_back(fmt::format("chart {}; depths are below its {}", title_of(cell),
                                   datum_name(cell.sounding_datum)));
  DepthsReader reader(*file, path);
  ChartDepths chart = reader.read(data);
  data.crs_wkt = reader.crs_wkt();
  const std::vector<Vec2> places = chart.places;
  chart.places = in_metres(places, data.crs_wkt);
  const ChartMesh mesh = chart_mesh(chart);
  if (mesh.faces.empty()) {
    throw InvalidInput(fmt::format("the depth areas of '{}' have no area", path.string()));
  }
  keep_used(mesh, in_degrees(mesh, places, data.crs_wkt), data);
  if (mesh.areas_without_soundings > 0) {
    data.notes.push_back(fmt::format(
        "{} depth areas hold no sounding; where their contours say no more they are taken as shoal "
        "as they may be",
        mesh.areas_without_soundings));
  }
  note_hazards(*file, data);
  data.z_is_depth = true;
  data.is_clean = true;
  return data;
}

}  // namespace swathplan
