#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/crs.h"
#include "io/provenance_internal.h"
#include "io/report/display_path_internal.h"
#include "io/report/pictures_internal.h"
#include "io/report/report_data_internal.h"
#include "io/report/verdict_internal.h"
#include "io/score_json_internal.h"

namespace swathplan::internal {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kCoverageBudget = 3'300'000;  // bytes of PNG over all plans
constexpr std::size_t kLargestPath = 30'000;        // points
constexpr std::uint32_t kDepthSide = 900;           // pixels
constexpr std::size_t kListedHolidays = 25;

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

/// A point well inside an area, where its label goes: the best of a lattice of candidates.
Vec2 label_point(const Area& area) {
  constexpr int kSteps = 20;
  const Box2 box = extent(area);
  Vec2 best = (box.min + box.max) / 2.0;
  double most = -1.0;
  for (int i = 1; i < kSteps; ++i) {
    for (int j = 1; j < kSteps; ++j) {
      const Vec2 p = box.min + box.size().cwiseProduct(Vec2(i, j)) / double{kSteps};
      const double inside = contains(area, p) ? distance_to_outline(area, p) : -1.0;
      if (inside > most) {
        most = inside;
        best = p;
      }
    }
  }
  return best;
}

Json regions_json(const ReportSite& site, const Pen& pen, double tolerance_m) {
  Json out = Json::array();
  for (const ReportRegion& r : site.regions) {
    if (r.outline.empty()) continue;
    out.push_back({{"rings", pen.rings(r.outline, tolerance_m)},
                   {"label", pen.line({label_point(r.outline)})},
                   {"band", r.band},
                   {"mean_depth_m", r.mean_depth_m},
                   {"opening_deg", r.opening_deg}});
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
  // Never coarser than eight tolerances: about a pixel of the whole map.
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

Json plan_json(const ReportPlan& plan, const Pen& pen, const Frame& frame, double tolerance_m,
               std::size_t budget) {
  return {{"name", plan.planner},
          {"gaps_text", gaps_text(*plan.score)},
          {"coverage_text", percent_text(plan.score->all.hit_pct)},
          {"largest_text", area_text(plan.score->holidays.largest_m2)},
          {"warnings", warnings(*plan.score)},
          {"notes", plan.notes},
          {"planning_s", plan.planning_seconds},
          {"figures", score_figures(*plan.score)},
          {"path", path_json(*plan.route, pen, tolerance_m)},
          {"holidays", holidays_json(plan.score->holidays, pen, frame)},
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
  data["regions"] = regions_json(site, pen, tolerance_m);
  data["gates"] = pen.edges(site.gates);
  data["blocked"] = pen.edges(site.blocked_edges);
  data["depth"] = depth_json(site, box, pen);
  data["legend"] = legend_json();
  data["provenance"] = to_json(site.provenance);
  data["plans"] = Json::array();
  for (const ReportPlan& plan : plans) {
    data["plans"].push_back(
        plan_json(plan, pen, frame, tolerance_m, kCoverageBudget / plans.size()));
  }
  return data;
}

}  // namespace swathplan::internal
