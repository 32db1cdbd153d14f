#include "io/seafloor/inspection.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/files/crs.h"
#include "planners/wording.h"

namespace swathplan {
namespace {

/// The fan that the suggestions are for: 256 beams over 100 degrees.
constexpr double kBeams = 256.0;
constexpr Angle kHalfAngle = Angle::degrees(50.0);
constexpr std::array kCells = {0.05, 0.1, 0.2, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0};
/// Depths that are deeper than the data is wide hardly are metres.
constexpr double kDeepest = 1000.0;
constexpr double kFlat = 0.05;       ///< metres of relief
constexpr double kMostlyLand = 0.9;  ///< share
constexpr std::size_t kManyFaces = 5'000'000;
constexpr double kHugeExtent = 50'000.0;  ///< metres

}  // namespace

SuggestedSettings suggest_settings(const Seafloor& seafloor) {
  const DepthRange depths = depth_range(seafloor);
  const Vec2 size = extent(seafloor).size();
  const double area = plan_area_m2(seafloor);
  SuggestedSettings s;
  // Largest gap of an equiangular fan at the mean depth: 2 t sec^2(t) depth / beams.
  const double t = kHalfAngle.rad();
  const double gap = 2.0 * t / (std::cos(t) * std::cos(t)) * depths.mean / kBeams;
  s.resolution_m = *std::min_element(kCells.begin(), kCells.end(), [&](double a, double b) {
    return std::abs(std::log(a / gap)) < std::abs(std::log(b / gap));
  });
  s.swath_m = kBeams * s.resolution_m;
  const double ratio = depths.max / std::max(depths.min, 0.1 * depths.max);
  s.depth_bands = std::clamp(static_cast<int>(std::lround(std::log2(ratio))), 1, 4);
  s.safe_depth_m = std::min(1.0, std::floor(depths.mean * 5.0) / 10.0);
  s.lines = static_cast<std::size_t>(std::max(1.0, std::ceil(area / s.swath_m / size.maxCoeff())));
  s.line_km = area / s.swath_m / 1000.0;
  return s;
}

std::vector<std::string> warnings_of(const ImportedSeafloor& r) {
  std::vector<std::string> warnings = r.warnings;
  const DepthRange depths = depth_range(r.seafloor);
  const double width = extent(r.seafloor).size().norm();
  const auto warn_if = [&](bool condition, std::string text) {
    if (condition) warnings.push_back(std::move(text));
  };
  warn_if(r.land_share > kMostlyLand,
          fmt::format("{:.3g} % of the data lies above the water: this looks like depths, positive "
                      "down (--z-positive down), or another level (--water-level)",
                      100.0 * r.land_share));
  warn_if(
      depths.max > kDeepest && depths.max > width,
      fmt::format("{:.6g} m deep, but only {:.4g} m wide: depths may be in feet, centimetres or "
                  "millimetres (--z-unit), or x and y in kilometres or degrees",
                  depths.max, width));
  warn_if(depths.max - depths.min < kFlat,
          fmt::format("hardly any relief: depths from {:.3f} to {:.3f} m", depths.min, depths.max));
  warn_if(r.health.components > 1,
          fmt::format("the seafloor falls into {} separate parts", r.health.components));
  warn_if(r.health.non_manifold_edges > 0,
          fmt::format("{} edges had more than two faces", r.health.non_manifold_edges));
  warn_if(r.health.overhanging_faces > 0,
          "the mesh is a closed body: its underside and sides were left out");
  warn_if(r.health.faces > kManyFaces || width > kHugeExtent,
          fmt::format("very large: {} faces, {:.4g} km across; choose a part with --area",
                      r.health.faces, width / 1000.0));
  warn_if(r.crs_name == "none",
          "no coordinate reference system: results are in local metres; give one with --crs");
  return warnings;
}

nlohmann::json inspection_json(const ImportedSeafloor& r) {
  const DepthRange depths = depth_range(r.seafloor);
  const Box2 box = extent(r.seafloor);
  const SuggestedSettings s = suggest_settings(r.seafloor);
  const MeshHealth& h = r.health;
  const Vec2 low = r.seafloor.frame.to_file(box.min);
  const Vec2 high = r.seafloor.frame.to_file(box.max);
  return {
      {"file", r.file},
      {"input_hash", r.input_hash},
      {"kind", r.kind},
      {"format", r.format},
      {"crs", r.crs_name},
      {"file_extent",
       {{"x_min", r.raw_min.x()},
        {"x_max", r.raw_max.x()},
        {"y_min", r.raw_min.y()},
        {"y_max", r.raw_max.y()},
        {"z_min", r.raw_z_min},
        {"z_max", r.raw_z_max}}},
      {"extent",
       {{"x_min", low.x()}, {"x_max", high.x()}, {"y_min", low.y()}, {"y_max", high.y()}}},
      {"width_m", box.size().x()},
      {"height_m", box.size().y()},
      {"area_m2", plan_area_m2(r.seafloor)},
      {"land_share", r.land_share},
      {"depth_min_m", depths.min},
      {"depth_mean_m", depths.mean},
      {"depth_max_m", depths.max},
      {"nodes", r.nodes},
      {"spacing_m", r.spacing_m},
      {"longest_edge_m", r.longest_edge_m},
      {"health",
       {{"vertices", h.vertices},
        {"faces", h.faces},
        {"components", h.components},
        {"boundary_loops", h.boundary_loops},
        {"vertical_faces", h.vertical_faces},
        {"duplicate_vertices", h.duplicate_vertices},
        {"unused_vertices", h.unused_vertices},
        {"degenerate_faces", h.degenerate_faces},
        {"duplicate_faces", h.duplicate_faces},
        {"flipped_faces", h.flipped_faces},
        {"non_manifold_edges", h.non_manifold_edges},
        {"underside_faces", h.overhanging_faces}}},
      {"notes", r.notes},
      {"warnings", warnings_of(r)},
      {"suggested",
       {{"resolution_m", s.resolution_m},
        {"swath_m", s.swath_m},
        {"depth_bands", s.depth_bands},
        {"safe_depth_m", s.safe_depth_m},
        {"lines", s.lines},
        {"line_km", s.line_km}}},
  };
}

std::string inspection_text(const ImportedSeafloor& r) {
  const DepthRange depths = depth_range(r.seafloor);
  const Box2 box = extent(r.seafloor);
  const Vec2 low = r.seafloor.frame.to_file(box.min);
  const Vec2 high = r.seafloor.frame.to_file(box.max);
  const SuggestedSettings s = suggest_settings(r.seafloor);
  const MeshHealth& h = r.health;
  std::string text;
  const auto line = [&](const char* name, const std::string& value) {
    text += fmt::format("{:<11}{}\n", name, value);
  };
  line("file", r.file);
  line("holds", fmt::format("{} ({}), {} nodes, about {:.3g} m apart", r.kind, r.format, r.nodes,
                            r.spacing_m));
  line("CRS", r.crs_name);
  line("extent", fmt::format("x {:.3f} to {:.3f}, y {:.3f} to {:.3f} ({:.1f} x {:.1f} m)", low.x(),
                             high.x(), low.y(), high.y(), box.size().x(), box.size().y()));
  line("z in file", fmt::format("{:.3f} to {:.3f}", r.raw_z_min, r.raw_z_max));
  line("depths", fmt::format("{:.2f} to {:.2f} m, mean {:.2f} m", std::abs(depths.min), depths.max,
                             depths.mean));
  line("area", fmt::format("{:.0f} m2", plan_area_m2(r.seafloor)));
  line("mesh",
       fmt::format("{} vertices, {} faces ({} vertical), {} part{}, {} boundary loop{}", h.vertices,
                   h.faces, h.vertical_faces, h.components, h.components == 1 ? "" : "s",
                   h.boundary_loops, h.boundary_loops == 1 ? "" : "s"));
  for (const std::string& note : r.notes) line("note", note);
  for (const std::string& warning : warnings_of(r)) line("WARNING", warning);
  line("try", fmt::format("--resolution {} --depth-bands {}", s.resolution_m, s.depth_bands));
  line("", fmt::format("swaths of {:.4g} m, roughly {}, {:.3g} km (256 beams)", s.swath_m,
                       counted(s.lines, "line"), s.line_km));
  return text;
}

}  // namespace swathplan
