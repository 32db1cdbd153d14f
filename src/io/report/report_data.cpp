#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/files/crs.h"
#include "io/report/display_path_internal.h"
#include "io/report/pictures_internal.h"
#include "io/report/report_data_internal.h"
#include "io/report/verdict_internal.h"
#include "io/results/provenance_json.h"
#include "io/results/score_figures.h"
#include "io/results/verdict_json.h"
#include "planners/pareto.h"

namespace swathplan::internal {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kCoverageBudget = 3'300'000;  // bytes of PNG over all plans
constexpr std::size_t kLargestPath = 30'000;        // points
constexpr std::uint32_t kDepthSide = 900;           // pixels
constexpr std::uint32_t kTvuSide = 700;             // pixels
constexpr std::size_t kListedHolidays = 25;
constexpr std::size_t kListedViolations = 100;
constexpr std::size_t kListedCutOffs = 25;
constexpr double kSlit = 0.01;         // metres
constexpr double kLeastCutOff = 0.01;  // square metres

/// Turns local metres into the page's centimetres.
class Pen {
 public:
  explicit Pen(const Box2& box) : box_(box) {}

  [[nodiscard]] Json line(const std::vector<Vec2>& points) const {
    Json out = Json::array();
    long x = 0, y = 0;
    for (const Vec2& p : points) {
      const Vec2 relative = (p - box_.min) * 100.0;
      const long px = std::lround(relative.x()), py = std::lround(relative.y());
      out.push_back(px - x);
      out.push_back(py - y);
      x = px;
      y = py;
    }
    return out;
  }

  [[nodiscard]] Json rings(const Area& area, double tolerance_m) const {
    Json out = Json::array();
    for (const Polygon& polygon : area) {
      out.push_back(ring(polygon.outer, tolerance_m));
      for (const Ring& hole : polygon.holes) out.push_back(ring(hole, tolerance_m));
    }
    return out;
  }

  [[nodiscard]] Json edges(const std::vector<std::pair<Vec2, Vec2>>& list) const {
    Json out = Json::array();
    for (const auto& [a, b] : list) out.push_back(line({a, b}));
    return out;
  }

  /// [x0, y0, x1, y1], centimetres.
  [[nodiscard]] Json box(const Box2& b) const {
    const Vec2 low = (b.min - box_.min) * 100.0, high = (b.max - box_.min) * 100.0;
    return {std::lround(low.x()), std::lround(low.y()), std::lround(high.x()),
            std::lround(high.y())};
  }

 private:
  [[nodiscard]] Json ring(const Ring& points, double tolerance_m) const {
    if (points.empty()) return Json::array();
    std::vector<Vec2> closed(points.begin(), points.end());
    closed.push_back(points.front());
    return line(simplified(closed, tolerance_m));
  }

  Box2 box_;
};

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

std::string hex(const Rgba& c) { return fmt::format("#{:02x}{:02x}{:02x}", c.r, c.g, c.b); }

Json palette_json(const std::vector<Rgba>& palette) {
  Json out = Json::array();
  for (const Rgba& c : palette) out.push_back(c.a == 0 ? "" : hex(c));
  return out;
}

Json depth_json(const ReportSite& site, const Box2& box, const Pen& pen) {
  const DepthPicture depth = depth_picture(*site.depths, box, kDepthSide);
  return {{"png", base64(png_bytes(depth.picture))},
          {"box", pen.box(depth.box)},
          {"columns", depth.picture.columns},
          {"rows", depth.picture.rows},
          {"min_m", depth.min_m},
          {"max_m", depth.max_m},
          {"isobath_m", depth.isobath_m},
          {"levels", kDepthLevels},
          {"shades", kDepthShades},
          {"palette", palette_json(depth.picture.palette)}};
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

Json path_json(const Route& route, const Pen& pen, double tolerance_m) {
  std::vector<DisplayPath> path = display_path(route, tolerance_m);
  const auto points = [&path] {
    std::size_t sum = 0;
    for (const DisplayPath& p : path) sum += p.points.size();
    return sum;
  };
  // The tolerance doubles three times at most, to about a pixel of the whole map.
  for (int i = 0; i < 3 && points() > kLargestPath; ++i) {
    tolerance_m *= 2.0;
    path = display_path(route, tolerance_m);
  }
  Json out = Json::array();
  for (const DisplayPath& p : path) {
    out.push_back({{"kind", name(p.kind)},
                   {"log", p.log ? 1 : 0},
                   {"sonar", p.sonar ? 1 : 0},
                   {"line", pen.line(p.points)}});
  }
  return out;
}

Json holidays_json(const Holidays& holidays, const Pen& pen, const Frame& frame) {
  Json out = Json::array();
  for (const Holiday& h : holidays.list) {
    if (out.size() == kListedHolidays) break;
    const Vec2 file = frame.to_file(h.position);
    out.push_back({{"area_m2", h.area_m2},
                   {"cause", cause_text(h.cause)},
                   {"at", pen.line({h.position})},
                   {"box", pen.box(h.box)},
                   {"x", std::round(file.x() * 100.0) / 100.0},
                   {"y", std::round(file.y() * 100.0) / 100.0}});
  }
  return out;
}

double rounded(double x) { return std::round(x * 100.0) / 100.0; }

Json violations_json(const ReportPlan& plan, const Pen& pen, const Frame& frame) {
  const std::vector<PlanViolation>& all = plan.record->violations;
  Json list = Json::array();
  for (const auto& [v, leg, reason] : all) {
    if (list.size() == kListedViolations) break;
    std::vector<Vec2> line;
    Box2 box;
    for (std::size_t i = v.first; i <= v.last; ++i) {
      line.push_back(plan.route->waypoints[i].position);
      box.extend(line.back());
    }
    const Vec2 file = frame.to_file(v.position);
    list.push_back({{"what", name(v.kind)},
                    {"kind", leg},
                    {"length_m", v.length_m},
                    {"reason", reason},
                    {"line", pen.line(line)},
                    {"at", pen.line({v.position})},
                    {"box", pen.box(box)},
                    {"x", rounded(file.x())},
                    {"y", rounded(file.y())}});
  }
  return {{"count", all.size()}, {"list", std::move(list)}};
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

Json choices_json(const PlanRecord& plan) {
  Json list = Json::array();
  for (const Outcome& o : plan.choices) {
    list.push_back({{"coverage_pct", expected_cover_pct(o)},
                    {"length_ratio", o.length_ratio},
                    {"length_m", o.length_m},
                    {"turns", o.turns},
                    {"infeasible_legs", o.infeasible_legs},
                    {"what", o.what}});
    if (o.whole_cover_pct) list.back()["within_margin_pct"] = o.cover_pct;
  }
  const Cover cover = plan.choices.empty() ? Cover::hit : plan.choices.front().cover;
  return {{"list", std::move(list)},
          {"cover", name(cover)},
          {"chosen", plan.chosen},
          {"why", plan.chosen_why}};
}

Json coverage_json(const CoverageGrid& grid, const Pen& pen, std::size_t budget) {
  const CoveragePicture picture = coverage_picture(grid, budget);
  return {{"png", base64(picture.png)},
          {"box", pen.box(picture.box)},
          {"columns", picture.columns},
          {"rows", picture.rows},
          {"factor", picture.factor}};
}

Json legend_json() {
  return {{"palette", palette_json(coverage_palette())},
          {"covered", kCovered},
          {"covered_names", kCoveredNames},
          {"empty", kEmpty},
          {"empty_steps", kEmptySteps}};
}

Json criterion_json(const ReportPlan& plan, const Pen& pen, const Frame& frame) {
  if (plan.judged == nullptr) return {};
  Json criterion = verdict_json(*plan.judged, frame);
  const TvuPicture tvu = tvu_picture(plan.judged->raster, kTvuSide);
  criterion["tvu"] = {{"png", base64(png_bytes(tvu.picture))},
                      {"box", pen.box(tvu.box)},
                      {"columns", tvu.picture.columns},
                      {"rows", tvu.picture.rows},
                      {"palette", palette_json(tvu.picture.palette)}};
  return criterion;
}

Json plan_json(const ReportPlan& plan, const ReportSite& site, const Pen& pen, double tolerance_m,
               std::size_t budget) {
  const Frame& frame = site.seafloor->frame;
  return {{"name", plan.record->label},
          {"gaps_text", gaps_text(*plan.score)},
          {"coverage_text", percent_text(plan.score->all.hit_pct)},
          {"largest_text", area_text(plan.score->holidays.largest_m2)},
          {"warnings", warnings(*plan.score)},
          {"notes", plan.record->notes},
          {"planning_s", plan.planning_seconds},
          {"criterion", criterion_json(plan, pen, frame)},
          {"figures", score_figures(*plan.score)},
          {"path", path_json(*plan.route, pen, tolerance_m)},
          {"holidays", holidays_json(plan.score->holidays, pen, frame)},
          {"violations", violations_json(plan, pen, frame)},
          {"choices", choices_json(*plan.record)},
          {"coverage", coverage_json(*plan.grid, pen, budget)}};
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
  data["file_corner"] = {corner.x(), corner.y()};
  data["file_units_per_cm"] = 0.01 / frame.metres_per_unit;
  data["box"] = pen.box(box);
  data["resolution_m"] = plans.front().grid->resolution_m();
  data["area"] = pen.rings(site.survey_area, tolerance_m);
  data["water"] = pen.rings(site.water, tolerance_m);
  data["no_go"] = pen.rings(site.no_go, tolerance_m);
  data["cut_off"] = cut_off_json(site, pen, tolerance_m);
  const PlanRecord& shown = record_with_regions(plans);
  std::vector<std::pair<Vec2, Vec2>> gates;
  for (const PlanGate& gate : shown.gates) gates.push_back(gate.edge);
  data["regions"] = regions_json(shown, pen, tolerance_m);
  data["gates"] = pen.edges(gates);
  data["blocked"] = pen.edges(shown.blocked_edges);
  data["depth"] = depth_json(site, box, pen);
  data["legend"] = legend_json();
  data["provenance"] = provenance_json(site.provenance);
  data["plans"] = Json::array();
  for (const ReportPlan& plan : plans) {
    data["plans"].push_back(
        plan_json(plan, site, pen, tolerance_m, kCoverageBudget / plans.size()));
  }
  return data;
}

}  // namespace swathplan::internal
