#include "io/seafloor/inspection.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "coverage/tracing/coverage_grid.h"
#include "io/files/crs.h"
#include "planners/wording.h"

namespace swathplan {
namespace {

/// The fan that the suggestions are for: 256 beams over 100 degrees.
constexpr double kBeams = 256.0;
constexpr Angle kHalfAngle = Angle::degrees(50.0);
constexpr double kOverlap = 0.1;  ///< of neighbouring swaths
constexpr std::array kCells = {0.05, 0.1, 0.2, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0};
const auto kCellsOfAPlan = static_cast<double>(CoverageGrid::kMaxCells);
/// Depths beyond this that also exceed the width of the data are hardly metres.
constexpr double kDeepest = 1000.0;
constexpr double kFlat = 0.05;       ///< metres of relief
constexpr double kMostlyLand = 0.9;  ///< share
constexpr std::size_t kManyFaces = 5'000'000;
constexpr double kHugeExtent = 50'000.0;  ///< metres

/// Which faces a sonar above sees: at their middle nothing lies over them. A wall is seen if its
/// corners are those of faces that are.
std::vector<bool> seen_faces(const Seafloor& s) {
  constexpr double kSameDepth = 1e-6;  ///< share of the depth
  constexpr double kLeastArea = 1e-9;
  const DepthQuery query(s);
  std::vector<bool> seen(s.faces.size(), false), wall(s.faces.size(), false);
  std::vector<bool> corner(s.vertices.size(), false);
  for (std::size_t f = 0; f < s.faces.size(); ++f) {
    const Vec3& a = s.vertices[s.faces[f][0]];
    const Vec3& b = s.vertices[s.faces[f][1]];
    const Vec3& c = s.vertices[s.faces[f][2]];
    const Vec3 normal = (b - a).cross(c - a);
    wall[f] = std::abs(normal.z()) <= kLeastArea * normal.norm();
    if (wall[f]) continue;
    const Vec3 middle = (a + b + c) / 3.0;
    const std::optional<double> shoalest = query.depth(middle.head<2>());
    seen[f] = !shoalest || -middle.z() <= *shoalest + kSameDepth * (1.0 - middle.z());
    if (seen[f]) {
      for (const std::uint32_t v : s.faces[f]) corner[v] = true;
    }
  }
  for (std::size_t f = 0; f < s.faces.size(); ++f) {
    if (!wall[f]) continue;
    seen[f] = std::all_of(s.faces[f].begin(), s.faces[f].end(),
                          [&](std::uint32_t v) { return corner[v]; });
  }
  return seen;
}

/// The seafloor without faces that lie below others: a second layer, the underside of a leaky body.
/// Empty if there are none.
std::optional<Seafloor> seen_from_above(const ImportedSeafloor& r) {
  if (r.kind != "mesh") return {};
  const std::vector<bool> seen = seen_faces(r.seafloor);
  if (std::find(seen.begin(), seen.end(), false) == seen.end()) return {};
  Seafloor top;
  top.frame = r.seafloor.frame;
  top.vertices = r.seafloor.vertices;
  for (std::size_t f = 0; f < seen.size(); ++f) {
    if (seen[f]) top.faces.push_back(r.seafloor.faces[f]);
  }
  if (!(plan_area_m2(top) > 0.0)) return {};
  return top;
}

std::string hidden_note(const Seafloor& top, const ImportedSeafloor& r) {
  const std::size_t hidden = r.seafloor.faces.size() - top.faces.size();
  if (hidden == 0) return {};
  return fmt::format("{} of {} faces lie below others: not counted in area and depths", hidden,
                     r.seafloor.faces.size());
}

}  // namespace

SuggestedSettings suggest_settings(const Seafloor& seafloor) {
  const DepthRange depths = depth_range(seafloor);
  const Vec2 size = extent(seafloor).size();
  const double area = plan_area_m2(seafloor);
  SuggestedSettings s;
  // Largest gap of an equiangular fan at the mean depth: 2 t sec^2(t) depth / beams.
  const double t = kHalfAngle.rad();
  const double gap = 2.0 * t / (std::cos(t) * std::cos(t)) * depths.mean / kBeams;
  const auto* cell = std::min_element(kCells.begin(), kCells.end(), [&](double a, double b) {
    return std::abs(std::log(a / gap)) < std::abs(std::log(b / gap));
  });
  // What a plan would refuse is no suggestion: more cells than fit, or one larger than the area.
  const auto too_many = [&](double side) {
    return (size.x() / side + 1.0) * (size.y() / side + 1.0) > kCellsOfAPlan;
  };
  while (cell + 1 != kCells.end() && too_many(*cell)) ++cell;
  while (cell != kCells.begin() && *cell > size.maxCoeff()) --cell;
  s.resolution_m = *cell;
  s.swath_m = 2.0 * depths.mean * std::tan(t);
  s.line_spacing_m = s.swath_m * (1.0 - kOverlap);
  const double ratio = depths.max / std::max(depths.min, 0.1 * depths.max);
  s.depth_bands = std::clamp(static_cast<int>(std::lround(std::log2(ratio))), 1, 4);
  s.safe_depth_m = std::min(1.0, std::floor(depths.mean * 5.0) / 10.0);
  s.lines =
      static_cast<std::size_t>(std::max(1.0, std::ceil(area / s.line_spacing_m / size.maxCoeff())));
  s.line_km = area / s.line_spacing_m / 1000.0;
  return s;
}

std::vector<std::string> warnings_of(const ImportedSeafloor& r) {
  std::vector<std::string> warnings = r.warnings;
  const DepthRange depths = depth_range(r.seafloor);
  const double width = extent(r.seafloor).size().norm();
  const auto warn_if = [&](bool condition, std::string text) {
    if (condition) warnings.push_back(std::move(text));
  };
  const bool is_said = std::any_of(warnings.begin(), warnings.end(), [](const std::string& w) {
    return w.find("looks like depths") != std::string::npos;
  });
  warn_if(r.land_share > kMostlyLand && !is_said,
          fmt::format("{:.3g} % of the data lies above the water: this looks like depths, positive "
                      "down (<z positive> down), or another level (<water level>)",
                      100.0 * r.land_share));
  warn_if(
      depths.max > kDeepest && depths.max > width,
      fmt::format("{:.6g} m deep, but only {:.4g} m wide: depths may be in feet, centimetres or "
                  "millimetres (<z unit>), or x and y in kilometres or degrees",
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
          fmt::format("very large: {} faces, {:.4g} km across; choose a part with <area>",
                      r.health.faces, width / 1000.0));
  warn_if(r.crs_name == "none",
          "no coordinate reference system: results are in local metres; give one with <CRS>");
  return warnings;
}

nlohmann::json inspection_json(const ImportedSeafloor& r) {
  const std::optional<Seafloor> cut = seen_from_above(r);
  const Seafloor& top = cut ? *cut : r.seafloor;
  const DepthRange depths = depth_range(top);
  const Box2 box = extent(r.seafloor);
  const SuggestedSettings s = suggest_settings(top);
  const MeshHealth& h = r.health;
  const Vec2 low = r.seafloor.frame.to_file(box.min);
  const Vec2 high = r.seafloor.frame.to_file(box.max);
  std::vector<std::string> notes = r.notes;
  if (const std::string hidden = hidden_note(top, r); !hidden.empty()) notes.push_back(hidden);
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
      {"area_m2", plan_area_m2(top)},
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
      {"notes", notes},
      {"warnings", warnings_of(r)},
      {"suggested",
       {{"resolution_m", s.resolution_m},
        {"swath_m", s.swath_m},
        {"line_spacing_m", s.line_spacing_m},
        {"depth_bands", s.depth_bands},
        {"safe_depth_m", s.safe_depth_m},
        {"lines", s.lines},
        {"line_km", s.line_km}}},
  };
}

std::string inspection_text(const ImportedSeafloor& r) {
  const std::optional<Seafloor> cut = seen_from_above(r);
  const Seafloor& top = cut ? *cut : r.seafloor;
  const DepthRange depths = depth_range(top);
  const Box2 box = extent(r.seafloor);
  const Vec2 low = r.seafloor.frame.to_file(box.min);
  const Vec2 high = r.seafloor.frame.to_file(box.max);
  const SuggestedSettings s = suggest_settings(top);
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
  line("area", fmt::format("{:.0f} m2", plan_area_m2(top)));
  line("mesh",
       fmt::format("{} vertices, {} faces ({} vertical), {} part{}, {} boundary loop{}", h.vertices,
                   h.faces, h.vertical_faces, h.components, h.components == 1 ? "" : "s",
                   h.boundary_loops, h.boundary_loops == 1 ? "" : "s"));
  for (const std::string& note : r.notes) line("note", note);
  if (const std::string hidden = hidden_note(top, r); !hidden.empty()) line("note", hidden);
  for (const std::string& warning : warnings_of(r)) line("WARNING", warning);
  line("try", fmt::format("<resolution> {} <depth bands> {}", s.resolution_m, s.depth_bands));
  line("",
       fmt::format("roughly {} {:.3g} m apart, {:.3g} km (a fan of {:g} degrees sweeps {:.3g} m "
                   "at the mean depth; {:g} % overlap)",
                   counted(s.lines, "line"), s.line_spacing_m, s.line_km, 2.0 * kHalfAngle.deg(),
                   s.swath_m, 100.0 * kOverlap));
  return text;
}

}  // namespace swathplan
