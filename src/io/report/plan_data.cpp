#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/report/plan_data_internal.h"
#include "io/report/sailed_legs_internal.h"
#include "io/report/swath_internal.h"
#include "io/results/job_json.h"
#include "io/results/score_figures.h"
#include "io/results/verdict_json.h"
#include "planners/pareto.h"

namespace swathplan::internal {
namespace {

using Json = nlohmann::ordered_json;

// Bytes of PNG over all plans. A page holds a third more of them, since they stand as base 64.
constexpr std::size_t kCoverageBudget = 1'500'000, kTvuBudget = 300'000;
constexpr std::size_t kLargestPath = 24'000;                 // points of all plans
constexpr std::uint32_t kTvuSide = 700, kSmallestTvu = 200;  // pixels
constexpr std::size_t kDrawnHolidays = 200;
constexpr std::size_t kListedViolations = 100;
constexpr double kSwathStations = 3000.0;    // of all plans
constexpr std::size_t kTrackStations = 900;  // along the time of a plan
constexpr double kDepthStations = 200.0;     // of a leg

Json holidays_json(const Holidays& holidays, const Pen& pen, const Frame& frame,
                   double tolerance_m) {
  Json out = Json::array();
  for (const Holiday& h : holidays.list) {
    if (out.size() == kDrawnHolidays) break;
    const Vec2 file = frame.to_file(h.position);
    out.push_back({{"area_m2", h.area_m2},
                   {"cells", h.cells},
                   {"cause", cause_text(h.cause)},
                   {"at", pen.line({h.position})},
                   {"box", pen.box(h.box)},
                   {"rings", pen.rings({h.outline}, tolerance_m)},
                   {"x", rounded(file.x())},
                   {"y", rounded(file.y())}});
  }
  return out;
}

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

Json choices_json(const PlanRecord& plan) {
  Json list = Json::array();
  for (const Outcome& o : plan.choices) {
    list.push_back({{"coverage_pct", expected_cover_pct(o)},
                    {"length_ratio", o.length_ratio},
                    {"length_m", o.length_m},
                    {"hours", o.duration_s / 3600.0},
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

Json coverage_json(const ReportPlan& plan, const Pen& pen, std::size_t budget) {
  const CoveragePicture picture = coverage_picture(*plan.grid, plan.score->logged_counts, budget);
  return {{"png", base64(picture.png)},
          {"box", pen.box(picture.box)},
          {"columns", picture.columns},
          {"rows", picture.rows},
          {"factor", picture.factor}};
}

Json tvu_json(const UncertaintyRaster& raster, const Pen& pen, std::size_t budget) {
  for (std::uint32_t side = kTvuSide;; side = side * 13 / 15) {
    const TvuPicture tvu = tvu_picture(raster, side);
    const std::string png = png_bytes(tvu.picture);
    if (png.size() > budget && side > kSmallestTvu) continue;
    return picture_json(tvu.picture, png, pen.box(tvu.box));
  }
}

Json criterion_json(const ReportPlan& plan, const Pen& pen, const Frame& frame,
                    std::size_t budget) {
  if (plan.judged == nullptr) return {};
  Json criterion = verdict_json(*plan.judged, frame);
  criterion["tvu"] = tvu_json(plan.judged->raster, pen, budget);
  return criterion;
}

/// From the lesser to the greater depth below a leg; nulls where there is no seafloor.
Json depths_below(const Route& route, const SailedLeg& leg, const DepthQuery& depths) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  const auto look = [&](const Vec2& p) {
    if (const auto depth = depths.depth(p)) {
      low = std::min(low, *depth);
      high = std::max(high, *depth);
    }
  };
  for (std::size_t i = leg.leg.first; i < leg.leg.last; ++i) {
    const Vec2& a = route.waypoints[i].position;
    const Vec2 way = route.waypoints[i + 1].position - a;
    const int steps = static_cast<int>(
        std::clamp(std::ceil(kDepthStations * way.norm() / leg.length_m), 1.0, kDepthStations));
    for (int k = 0; k <= steps; ++k) look(a + static_cast<double>(k) / steps * way);
  }
  if (low > high) return {nullptr, nullptr};
  return {rounded(low), rounded(high)};
}

/// From the least to the greatest half-angles and speeds of a leg.
Json settings_along(const Route& route, const Leg& leg) {
  const auto range = [&](const auto& value) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t i = leg.first; i < leg.last; ++i) {
      const double v = value(route.waypoints[i]);
      low = std::min(low, v);
      high = std::max(high, v);
    }
    return Json::array({rounded(low), rounded(high)});
  };
  Json out;
  const bool sonar = route.waypoints[leg.first].fan.has_value();
  out["port_deg"] =
      sonar ? range([](const Waypoint& w) { return w.fan ? w.fan->port.deg() : 0.0; }) : Json();
  out["stbd_deg"] =
      sonar ? range([](const Waypoint& w) { return w.fan ? w.fan->starboard.deg() : 0.0; })
            : Json();
  out["speed_mps"] = range([](const Waypoint& w) { return w.speed_mps; });
  return out;
}

/// From start to end, from true north; null for a leg that comes back to where it began.
Json heading_json(const Vec2& from, const Vec2& to, Angle grid_north) {
  const Vec2 way = to - from;
  if (way.norm() < 1e-3) return {};
  const double grid = Angle::radians(std::atan2(way.x(), way.y())).deg();
  return rounded(std::fmod(grid + grid_north.deg() + 720.0, 360.0), 1);
}

/// Steps of a tenth of a second, as the points are written by steps.
Json times_json(const std::vector<double>& seconds) {
  Json out = Json::array();
  long now = 0;
  for (const double s : seconds) {
    const long t = std::lround(10.0 * s);
    out.push_back(t - now);
    now = t;
  }
  return out;
}

Json leg_json(const ReportPlan& plan, const ReportSite& site, const Pen& pen,
              const SailedLeg& sailed, std::size_t index) {
  const Route& route = *plan.route;
  const Waypoint& first = route.waypoints[sailed.leg.first];
  const Frame& frame = site.seafloor->frame;
  const Vec2 from = frame.to_file(sailed.points.front()), to = frame.to_file(sailed.points.back());
  Json leg{{"kind", name(first.kind)},
           {"log", first.log ? 1 : 0},
           {"sonar", first.fan ? 1 : 0},
           {"line", first.line ? Json(*first.line) : Json()},
           {"from", {rounded(from.x()), rounded(from.y())}},
           {"to", {rounded(to.x()), rounded(to.y())}},
           {"heading_deg",
            heading_json(sailed.points.front(), sailed.points.back(), plan.record->grid_north)},
           {"length_m", rounded(sailed.length_m)},
           {"depth_m", depths_below(route, sailed, *site.depths)}};
  leg.update(settings_along(route, sailed.leg));
  const std::vector<LegWater>& water = plan.record->water;
  const auto under_keel =
      index < water.size() ? water[index].under_keel_m : std::optional<double>();
  leg["under_keel_m"] = under_keel ? Json(rounded(*under_keel)) : Json();
  if (!first.feasible) leg["infeasible"] = 1;
  leg["points"] = pen.line(sailed.points);
  leg["times"] = times_json(sailed.seconds);
  return leg;
}

Json legs_json(const ReportPlan& plan, const ReportSite& site, const Pen& pen, double tolerance_m,
               std::size_t count) {
  const Route& route = *plan.route;
  const double stations = kSwathStations / static_cast<double>(count);
  const double step = std::max(plan.grid->resolution_m(), length_m(route) / stations);
  Json out = Json::array();
  for (const SailedLeg& sailed : sailed_legs(route, tolerance_m, kLargestPath / count)) {
    out.push_back(leg_json(plan, site, pen, sailed, out.size()));
    const Waypoint& first = route.waypoints[sailed.leg.first];
    if (!first.log || !first.fan) continue;
    const Ring swath = swath_outline(route, sailed.leg, *site.depths, plan.record->sonar,
                                     plan.record->vehicle.draft_m, step);
    out.back()["swath"] = pen.rings({{swath, {}}}, 2.0 * tolerance_m);
  }
  return out;
}

/// Three columns: minutes, metres of depth, metres between pings.
Json along_json(const ReportPlan& plan, const ReportSite& site) {
  Json minutes = Json::array(), depth = Json::array(), spacing = Json::array();
  const auto metres = [](const std::optional<double>& value, int decimals) {
    return value ? Json(rounded(*value, decimals)) : Json();
  };
  for (const AlongTrack& at :
       along_track(*plan.route, *site.depths, plan.record->sonar, plan.record->vehicle.draft_m,
                   plan.record->pings, kTrackStations)) {
    minutes.push_back(rounded(at.seconds / 60.0));
    depth.push_back(metres(at.depth_m, 2));
    spacing.push_back(metres(at.ping_spacing_m, 3));
  }
  return {std::move(minutes), std::move(depth), std::move(spacing)};
}

std::string hex(const Rgba& c) { return fmt::format("#{:02x}{:02x}{:02x}", c.r, c.g, c.b); }

}  // namespace

Json palette_json(const std::vector<Rgba>& palette) {
  Json out = Json::array();
  for (const Rgba& c : palette) out.push_back(c.a == 0 ? "" : hex(c));
  return out;
}

Json picture_json(const IndexedPicture& picture, const std::string& png, Json box) {
  return {{"png", base64(png)},
          {"box", std::move(box)},
          {"columns", picture.columns},
          {"rows", picture.rows},
          {"palette", palette_json(picture.palette)}};
}

std::vector<ComparedPlan> compared(const std::vector<ReportPlan>& plans) {
  std::vector<ComparedPlan> out;
  for (const ReportPlan& plan : plans) {
    out.push_back({plan.record->label, plan.score, plan.judged});
  }
  return out;
}

Json plan_json(const ReportPlan& plan, const ReportSite& site, const Pen& pen, double tolerance_m,
               std::size_t count) {
  const Frame& frame = site.seafloor->frame;
  const Score& score = *plan.score;
  return {{"name", plan.record->label},
          {"verdict", verdict({plan.record->label, plan.score, plan.judged})},
          {"gaps_text", gaps_text(score)},
          {"counted", score.logged_counts ? "logged" : "all"},
          {"counted_pct", score.counted().hit_pct},
          {"counted_5_pct", score.counted().hit_5_pct},
          {"warnings", warnings(score)},
          {"notes", plan.record->notes},
          {"planning_s", plan.planning_seconds},
          {"criterion", criterion_json(plan, pen, frame, kTvuBudget / count)},
          {"figures", score_figures(score)},
          {"legs", legs_json(plan, site, pen, tolerance_m, count)},
          {"along", along_json(plan, site)},
          {"job",
           plan.record->job ? job_json(*plan.record->job, plan.record->job_files, frame) : Json()},
          {"holidays", holidays_json(score.holidays, pen, frame, tolerance_m)},
          {"violations", violations_json(plan, pen, frame)},
          {"choices", choices_json(*plan.record)},
          {"coverage", coverage_json(plan, pen, kCoverageBudget / count)}};
}

}  // namespace swathplan::internal
