#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/files/crs.h"
#include "io/files/lonlat.h"
#include "io/report/plan_data_internal.h"
#include "io/report/report_data_internal.h"
#include "io/results/provenance_json.h"
#include "mesh/base/error.h"

namespace swathplan::internal {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint32_t kSeafloorSide = 1200, kSmallestSeafloor = 300;  // pixels
constexpr std::size_t kSeafloorBudget = 450'000;  // bytes of each PNG of the seafloor
constexpr std::size_t kListedCutOffs = 25, kDrawnHazards = 500;
constexpr double kSlit = 0.01;         // metres
constexpr double kLeastCutOff = 0.01;  // square metres
constexpr int kPatch = 4;              // places a side that longitude and latitude are known at

/// What the maps show: the area and all routes, and a little around them.
Box2 map_box(const ReportSite& site, const std::vector<ReportPlan>& plans) {
  Box2 box = extent(site.survey_area);
  for (const ReportPlan& plan : plans) {
    for (const Waypoint& w : plan.route->waypoints) box.extend(w.position);
  }
  if (box.empty()) box = extent(*site.seafloor);
  const Vec2 margin = Vec2::Constant(std::max(1.0, 0.03 * box.size().maxCoeff()));
  box.min -= margin;
  box.max += margin;
  return box;
}

/// Depth and slope; they get coarser until each has few enough bytes.
Json seafloor_json(const ReportSite& site, const Box2& box, const Pen& pen) {
  for (std::uint32_t side = kSeafloorSide;; side = side * 13 / 15) {
    const DepthField field = depth_field(*site.depths, box, side);
    const DepthPicture depth = depth_picture(field);
    const SlopePicture slope = slope_picture(field);
    const std::string depth_png = png_bytes(depth.picture), slope_png = png_bytes(slope.picture);
    if (std::max(depth_png.size(), slope_png.size()) > kSeafloorBudget &&
        side > kSmallestSeafloor) {
      continue;
    }
    Json deep = picture_json(depth.picture, depth_png, pen.box(depth.box));
    deep.update({{"min_m", depth.min_m},
                 {"max_m", depth.max_m},
                 {"isobath_m", depth.isobath_m},
                 {"levels", kDepthLevels},
                 {"shades", kDepthShades}});
    Json steep = picture_json(slope.picture, slope_png, pen.box(slope.box));
    steep["step_deg"] = kSlopeStepDeg;
    steep["pixel_m"] = field.pixel_m;
    return {{"depth", std::move(deep)}, {"slope", std::move(steep)}};
  }
}

/// What the boat keeps off, the first of many.
Json hazards_json(const Hazards& hazards, const Pen& pen, double tolerance_m) {
  Json out = Json::array();
  for (const Hazard& h : hazards.list) {
    if (out.size() == kDrawnHazards) break;
    out.push_back({{"layer", h.layer},
                   {"name", h.name},
                   {"accuracy_m", h.accuracy_m},
                   {"accuracy_from", h.accuracy_from},
                   {"buffer_m", h.buffer_m},
                   {"to_be_seen", h.to_be_seen},
                   {"rings", pen.rings(h.area, tolerance_m)}});
  }
  return out;
}

/// Longitude and latitude at kPatch x kPatch even places of the box, row by row from the
/// south-west; null without a CRS, or where a place has neither.
Json lonlat_json(const Frame& frame, const Box2& box) {
  const LonLat conversion(frame);
  if (!conversion.known()) return {};
  std::vector<Vec2> places;
  for (int row = 0; row < kPatch; ++row) {
    for (int column = 0; column < kPatch; ++column) {
      places.emplace_back(box.min + Vec2(column, row).cwiseProduct(box.size()) / (kPatch - 1));
    }
  }
  try {
    Json out = Json::array();
    for (const Vec2& p : conversion.from_local(places)) {
      out.push_back(rounded(p.x(), 9));
      out.push_back(rounded(p.y(), 9));
    }
    return out;
  } catch (const InvalidInput&) {
    return {};  // the margin around the data may lie beyond what the projection is made for
  }
}

/// The plan whose regions and gates the maps show: the last one that has gates, else regions.
const PlanRecord& record_with_regions(const std::vector<ReportPlan>& plans) {
  const PlanRecord* best = plans.front().record;
  for (const ReportPlan& plan : plans) {
    if (plan.record->regions.empty()) continue;
    if (best->regions.empty() || !plan.record->gates.empty()) best = plan.record;
  }
  return *best;
}

Json regions_json(const PlanRecord& record, const Pen& pen, double tolerance_m) {
  Json out = Json::array();
  for (const PlanRegion& r : record.regions) {
    if (r.outline.empty()) continue;
    // The union of mesh faces has slits between some of them. They are one lattice step wide.
    const Area closed = offset(offset(r.outline, kSlit), -kSlit);
    out.push_back({{"rings", pen.rings(closed, tolerance_m)},
                   {"label", pen.line({inner_point(r.outline)})},
                   {"band", r.band},
                   {"mean_depth_m", r.mean_depth_m},
                   {"opening_deg", (r.fan.port + r.fan.starboard).deg()}});
  }
  return out;
}

/// The part of the survey area that the boat cannot enter.
Json cut_off_json(const ReportSite& site, const Pen& pen, double tolerance_m) {
  Area cut = subtract(site.survey_area, site.water);
  std::erase_if(cut, [](const Polygon& p) { return area_m2({p}) < kLeastCutOff; });
  std::sort(cut.begin(), cut.end(),
            [](const Polygon& a, const Polygon& b) { return area_m2({a}) > area_m2({b}); });
  Json list = Json::array();
  for (const Polygon& piece : cut) {
    if (list.size() == kListedCutOffs) break;
    const Vec2 at = inner_point({piece});
    const Vec2 file = site.seafloor->frame.to_file(at);
    list.push_back({{"area_m2", area_m2({piece})},
                    {"at", pen.line({at})},
                    {"box", pen.box(extent({piece}))},
                    {"x", rounded(file.x())},
                    {"y", rounded(file.y())}});
  }
  return {{"area_m2", area_m2(cut)},
          {"share_pct", 100.0 * area_m2(cut) / area_m2(site.survey_area)},
          {"count", cut.size()},
          {"rings", pen.rings(cut, tolerance_m)},
          {"list", std::move(list)}};
}

Json legend_json() {
  return {{"palette", palette_json(coverage_palette())},
          {"covered", kCovered},
          {"covered_names", kCoveredNames},
          {"empty", kEmpty},
          {"empty_steps", kEmptySteps}};
}

}  // namespace

Json report_data(const ReportSite& site, const std::vector<ReportPlan>& plans) {
  const Box2 box = map_box(site, plans);
  const Pen pen(box);
  const Frame& frame = site.seafloor->frame;
  const double tolerance_m = box.size().maxCoeff() / 10'000.0;
  const Vec2 corner = frame.to_file(box.min);
  Json data;
  data["title"] = site.title;
  data["crs"] = crs_name(frame.crs_wkt);
  data["grid_north_deg"] = plans.front().record->grid_north.deg();
  data["file_corner"] = {corner.x(), corner.y()};
  data["file_units_per_cm"] = 0.01 / frame.metres_per_unit;
  data["lonlat"] = lonlat_json(frame, box);
  data["box"] = pen.box(box);
  data["resolution_m"] = plans.front().grid->resolution_m();
  data["area"] = pen.rings(site.survey_area, tolerance_m);
  data["water"] = pen.rings(site.water, tolerance_m);
  data["no_go"] = pen.rings(site.no_go, tolerance_m);
  data["hazards"] = hazards_json(plans.front().record->hazards, pen, tolerance_m);
  data["cut_off"] = cut_off_json(site, pen, tolerance_m);
  const PlanRecord& shown = record_with_regions(plans);
  std::vector<std::pair<Vec2, Vec2>> gates;
  for (const PlanGate& gate : shown.gates) gates.push_back(gate.edge);
  data["regions"] = regions_json(shown, pen, tolerance_m);
  data["gates"] = pen.edges(gates);
  data["blocked"] = pen.edges(shown.blocked_edges);
  data.update(seafloor_json(site, box, pen));
  data["legend"] = legend_json();
  data["provenance"] = provenance_json(site.provenance);
  data["best"] = best_plan(compared(plans));
  data["plans"] = Json::array();
  for (const ReportPlan& plan : plans) {
    data["plans"].push_back(plan_json(plan, site, pen, tolerance_m, plans.size()));
  }
  return data;
}

}  // namespace swathplan::internal
