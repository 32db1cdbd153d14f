#include "apps/planning.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "coverage/route/over_land.h"
#include "coverage/route/ping_clock.h"
#include "coverage/standards/criterion_fan.h"
#include "io/files/crs.h"
#include "io/water/times.h"
#include "mesh/base/error.h"
#include "planners/fitted/edge_following.h"
#include "planners/fitted/fitted_lines.h"
#include "planners/fronts/coverage_goal.h"
#include "planners/fronts/rate_width.h"
#include "planners/fronts/water_raster.h"
#include "planners/line_spacing.h"
#include "planners/nuc/mdnuc.h"
#include "planners/nuc/nuc.h"
#include "planners/nuc/skeleton_smoothing.h"
#include "planners/passing/passing_plan.h"
#include "planners/rows/back_and_forth.h"
#include "planners/rows/multi_depth.h"
#include "planners/wording.h"

namespace swathplan {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void check_scale(const Site& site, const Survey& survey) {
  const Vec2 size = extent(site.survey_area).size();
  if (survey.scoring.resolution_m > size.maxCoeff()) {
    throw UsageError(
        fmt::format("--resolution {:g}; the survey area of {:.1f} x {:.1f} m is smaller "
                    "than one such cell",
                    survey.scoring.resolution_m, size.x(), size.y()));
  }
  const Sonar& sonar = survey.sonar;
  const double shoalest = depth_range(site.seafloor()).min;
  if (shoalest > sonar.max_range_m) {
    throw InvalidInput(fmt::format(
        "the seafloor lies {:.0f} m deep or more, beyond the range of the sonar {} ({:g} m): check "
        "--z-unit and --water-level, or choose another --sonar",
        shoalest, sonar.name, sonar.max_range_m));
  }
}

/// @throws UsageError for a ping rate that was typed and that sound forbids even over the shoalest
/// ground.
void check_ping_rate(const Survey& survey, double shoalest_below_m) {
  const PingTiming& clock = survey.scoring.pings;
  if (!survey.asked_ping_rate_hz || clock.spacing_m || !(shoalest_below_m > 0.0)) return;
  const double most = most_cycles_hz(clock, shoalest_below_m);
  if (*survey.asked_ping_rate_hz <= most) return;
  throw UsageError(fmt::format(
      "--ping-rate {:g}; over the shoalest ground, {:.4g} m below the sonar, sound is back {:.4g} "
      "times a second at most: give that or less, or leave it out",
      *survey.asked_ping_rate_hz, shoalest_below_m, most));
}

double rounded_up(double value, double step) { return step * std::ceil(value / step - 1e-9); }

/// Where a ping in each cell is out of reach, and what comes nearest; empty where it is not.
std::string out_of_reach(const LeastHours& hours, double deepest_below_m, const Survey& survey) {
  const PlanOptions& how = survey.planning;
  if (how.pings.spacing_m || !(hours.unreachable_m2 > 0.0)) return {};
  const double draft = how.vehicle.draft_m;
  const std::string where = fmt::format(
      "in {:.3g} % of the area, from {:.4g} m of depth on, no fan and no speed lays {} in each "
      "cell of {:g} m",
      100.0 * hours.unreachable_m2 / (hours.unreachable_m2 + hours.area_m2),
      hours.shoalest_unreachable_m + draft,
      how.soundings > 1.0 ? fmt::format("{:g} soundings", how.soundings) : "a sounding",
      how.resolution_m);
  if (!(widest_half_angle(how.sonar, deepest_below_m).rad() > 0.0)) {
    return fmt::format("{}: the sonar's range or coverage curve ends above the {:.4g} m there",
                       where, deepest_below_m + draft);
  }
  const double interval = ping_interval_s(how.sonar, how.pings, deepest_below_m);
  return fmt::format(
      "{}: at the least speed of {:g} m/s pings lie up to {:.3g} m apart there; <resolution> "
      "{:.3g} "
      "or <least speed> {:.3g} comes nearest",
      where, how.least_speed_mps, how.least_speed_mps * interval,
      rounded_up(how.least_speed_mps * interval, 0.01),
      std::floor(100.0 * how.resolution_m / interval) / 100.0);
}

/// @throws UsageError where no sounding of the site can be accepted; says what is missed by most.
void check_any_accepted(const Judging& judging, const Sonar& narrowed, double draft_m) {
  const CoverageLimit& shoalest = narrowed.coverage_curve.front();
  if (shoalest.half_angle.rad() > 0.0) return;
  const SoundingGeometry down{Angle(), shoalest.depth_m, 0.0};
  const std::vector<UncertaintyPart> parts = depth_parts(judging.budget, down);
  const auto most = std::max_element(parts.begin(), parts.end(), [](const auto& a, const auto& b) {
    return a.sigma_m < b.sigma_m;
  });
  const SoundingUncertainty known = sounding_uncertainty(judging.budget, down);
  const double depth = shoalest.depth_m + draft_m;
  throw UsageError(fmt::format(
      "--criteria {}: not even the beam straight down is known well enough in {:.1f} m of water: "
      "TVU {:.2f} m (limit {:.2f} m), THU {:.2f} m (limit {:.2f} m); most of the depth's comes "
      "from {} ({:.3f} m)",
      judging.criterion->name, depth, known.tvu_m, tvu_limit_m(*judging.criterion, depth),
      known.thu_m, thu_limit_m(*judging.criterion, depth), most->source, most->sigma_m));
}

/// The sonar that a plan may count on: within what the criterion accepts, if there is one.
Sonar counted_on(const Site& site, const Survey& survey, std::vector<std::string>& notes) {
  if (!survey.judging) return survey.sonar;
  const Judging& judging = *survey.judging;
  const DepthRange depths = depth_range(site.seafloor());
  const double draft = survey.vehicle.draft_m;
  Sonar narrowed =
      narrowed_to(*judging.criterion, UncertaintyModel(judging.budget), survey.sonar,
                  {depths.min - draft, depths.max - draft}, draft, survey.vehicle.speed_mps);
  check_any_accepted(judging, narrowed, draft);
  for (const CoverageLimit& limit : narrowed.coverage_curve) {
    if (limit.half_angle.rad() > 0.0) continue;
    notes.push_back(fmt::format("deeper than {:.0f} m no sounding is known well enough for {}",
                                limit.depth_m + draft, judging.criterion->title));
    break;
  }
  return narrowed;
}

}  // namespace

void note_reach(Site& site, const Survey& survey) {
  const PlanOptions& how = survey.planning;
  if (how.rows.swath_by == SwathBy::fan) return;
  const double width = footprint_width_m(how);
  const double depth = depth_range(site.seafloor()).mean - how.vehicle.draft_m;
  const double reach = 2.0 * depth * tan(how.sonar.max_opening / 2.0);
  if (reach >= width) return;
  site.notes.push_back(fmt::format(
      "the footprint width of {:.4g} m ({} beams, cells of {:g} m) is more than a fan of {:g} "
      "degrees sweeps at the mean depth ({:.4g} m): lines of back-and-forth and multi-depth lie a "
      "footprint width apart and leave gaps, and length ratios count in swaths that no fan sweeps; "
      "--swath-by fan spaces lines by what the fan sweeps, and smaller cells (--resolution) bring "
      "them closer too",
      width, how.sonar.beams, how.resolution_m, how.sonar.max_opening.deg(), reach));
}

PlanOptions planning_over(const Ground& ground, const Site& site, const Survey& survey,
                          const Sonar& sonar) {
  PlanOptions how = planning_in(survey, site.imported);
  how.sonar = sonar;
  if (how.opening_angle) how.sonar.max_opening = *how.opening_angle;
  if (how.rows.swath_by == SwathBy::footprint) return how;
  how.lane_width_m = usual_lane_m(ground, how);
  if (how.smooth) how.smooth = smoothing_for(how);
  return how;
}

const std::vector<Planner>& planners() {
  static const std::vector<Planner> list{
      {"back-and-forth", "B&F", plan_back_and_forth},
      {"edge-following", "edge-following", plan_edge_following, false},
      {"multi-depth", "MDB&F", plan_multi_depth},
      {"nuc", "NUC", plan_nuc},
      {"mdnuc", "MDNUC", plan_mdnuc},
      {"fitted-lines", "fitted lines", plan_fitted_lines, true, true},
  };
  return list;
}

const Planner& planner(const std::string& name) {
  std::vector<std::string> names;
  for (const Planner& p : planners()) {
    if (p.name == name) return p;
    names.push_back(p.name);
  }
  throw UsageError(
      fmt::format("'{}' is not a planner; choose one of {}", name, fmt::join(names, ", ")));
}

namespace {

/// Per cent of the cells with as many soundings that count as are wanted.
double served_pct(const CoverageGrid& grid, double wanted, bool logged) {
  std::size_t cells = 0;
  std::size_t served = 0;
  for (std::size_t i = 0; i < grid.words().size(); ++i) {
    if (!grid.counts(i)) continue;
    ++cells;
    served += (logged ? grid.logged_soundings(i) : grid.soundings(i)) >= wanted ? 1U : 0U;
  }
  return 100.0 * static_cast<double>(served) / static_cast<double>(std::max<std::size_t>(1, cells));
}

}  // namespace

Scorer::Scorer(const Site& site, const Survey& survey, Watch watch)
    : site_(&site),
      survey_(&survey),
      scene_(site.seafloor(), survey.scoring.nodata),
      ground_(site.ground(&scene_)),
      watch_(watch) {
  // A site that cannot be scored is refused before any planner works for it.
  static_cast<void>(grid_size(site.survey_area, survey.scoring.resolution_m));
  check_scale(site, survey);
  watch_.phase("working out the least hours of the site");
  const WaterRaster raster(ground_);
  const LeastHours hours = hours_and_reach(raster, survey.planning);
  goal_pct_ = coverage_goal_pct(raster, AreaQuery(ground_.water), survey.planning);
  least_hours_ = hours.hours;
  const auto sailed = block_depths(intersect(ground_.survey_area, ground_.water), *ground_.depths);
  const double draft = survey.vehicle.draft_m;
  if (!sailed.empty()) {
    check_ping_rate(survey, sailed.front() - draft);
    reach_note_ = in_flags(out_of_reach(hours, sailed.back() - draft, survey));
  }
  if (survey.asked_soundings && !reach_note_.empty() && !(hours.area_m2 > 0.0)) {
    throw UsageError(fmt::format("--soundings {:g}; {}", *survey.asked_soundings, reach_note_));
  }
  if (survey.judging) {
    judge_.emplace(ground_, *survey.judging->criterion, survey.judging->budget,
                   survey.judging->how);
    PlanOptions by_criterion = survey.planning;
    by_criterion.criterion = &judge_->criterion();
    by_criterion.uncertainty = &judge_->uncertainty();
    least_hours_ = least_hours(raster, by_criterion);
  }
}

ScoredRoute Scorer::score(const std::string& phase, const Route& route) const {
  watch_.phase(phase);
  ScoreOptions options = survey_->scoring;
  options.progress = [&](double share, std::uint64_t) { watch_.share(share); };
  ScoredRoute scored = swathplan::score(route, ground_, survey_->sonar, survey_->vehicle, options);
  scored.score.least_hours = least_hours_;
  scored.score.goal = CoverageGoal{
      goal_pct_, served_pct(scored.grid, survey_->planning.soundings, options.logged_counts)};
  if (site_->covered) scored.score.whole = site_->covered->whole(scored.grid, site_->rest);
  return scored;
}

std::optional<JudgedSurvey> Scorer::judge(const std::string& phase, const Route& route) const {
  if (!judge_) return std::nullopt;
  watch_.phase(phase);
  ScoreOptions options = survey_->scoring;
  options.progress = [&](double share, std::uint64_t) { watch_.share(share); };
  return judge_->judge(route, survey_->sonar, survey_->vehicle, options);
}

void note_beyond_data(const Score& score, std::vector<std::string>& notes) {
  if (!(score.pinging.beyond_data_m > 0.0)) return;
  notes.push_back(fmt::format(
      "{:.0f} m of the route lie farther from all data than the sonar's range; they were scored "
      "without pings",
      score.pinging.beyond_data_m));
}

void note_corners(const RouteFigures& figures, const Vehicle& vehicle,
                  std::vector<std::string>& notes) {
  std::string note = corners_note(figures, vehicle);
  if (!note.empty()) notes.push_back(std::move(note));
}

void note_speed(const Route& route, const Vehicle& vehicle, std::vector<std::string>& notes) {
  constexpr double kDust = 1e-6;
  const auto& w = route.waypoints;
  const Waypoint* fastest = nullptr;
  std::size_t faster = 0;
  std::size_t number = 0;
  const std::vector<Leg> all = legs(route);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const bool surveys = is_survey(w[all[k].first].kind);
    const double most =
        surveys ? vehicle.speed_mps
                : std::max({vehicle.speed_mps, vehicle.turn_speed_mps, vehicle.transit_speed_mps});
    const Waypoint* quick = nullptr;
    for (std::size_t i = all[k].first; i < all[k].last; ++i) {
      if (w[i].speed_mps > most + kDust && (!quick || w[i].speed_mps > quick->speed_mps)) {
        quick = &w[i];
      }
    }
    if (quick == nullptr) continue;
    ++faster;
    if (fastest == nullptr || quick->speed_mps > fastest->speed_mps) {
      fastest = quick;
      number = k + 1;
    }
  }
  if (fastest == nullptr) return;
  const double speed = is_survey(fastest->kind)
                           ? vehicle.speed_mps
                           : std::max(vehicle.speed_mps, vehicle.transit_speed_mps);
  notes.push_back(fmt::format(
      "{} {} sailed faster than the vehicle can; leg {}, a {}{}, at {:.4g} m/s where it makes "
      "{:.4g}: "
      "hours and spacing of pings hold for a boat that is as fast",
      counted(faster, "leg"), faster == 1 ? "is" : "are", number, name(fastest->kind),
      fastest->line ? fmt::format(" ({})", *fastest->line) : "", fastest->speed_mps, speed));
}

void note_endurance(const RouteFigures& figures, const Vehicle& vehicle,
                    std::vector<std::string>& notes) {
  std::string note = endurance_note(figures, vehicle);
  if (!note.empty()) notes.push_back(std::move(note));
}

namespace {

/// Notes how many legs are short of water when they are sailed, and which has the least.
void note_water(const std::vector<LegWater>& legs, const Site& site, const Route& route,
                const Vehicle& vehicle, std::vector<std::string>& notes) {
  if (site.tide == nullptr) return;
  const LegWater* least = nullptr;
  std::size_t shorts = 0, never = 0, untold = 0, unsounded = 0;
  for (const LegWater& leg : legs) {
    shorts += leg.short_of_water.value_or(false) ? 1U : 0U;
    unsounded += leg.least_depth_m ? 0U : 1U;
    never += leg.least_depth_m && leg.windows.empty() ? 1U : 0U;
    untold += site.departure_s && leg.least_depth_m && !leg.under_keel_m ? 1U : 0U;
    if (!leg.under_keel_m) continue;
    if (least == nullptr || *leg.under_keel_m < *least->under_keel_m) least = &leg;
  }
  if (least != nullptr) {
    const Waypoint& w = route.waypoints[least->leg.first];
    notes.push_back(fmt::format(
        "{} of {} are sailed with less than {:.2f} m of water (draft, squat and margin); the least "
        "under the keel is {:.2f} m, on a {}{} at {}; water.csv has all, and when each has enough",
        shorts, counted(legs.size(), "leg"), safe_depth_m(vehicle), *least->under_keel_m,
        name(w.kind), w.line ? fmt::format(" ({})", *w.line) : "",
        time_text(*site.departure_s + least->start_s)));
  }
  if (never > 0) {
    notes.push_back(fmt::format("{} never {} {:.2f} m of water within the tide's table",
                                counted(never, "leg"), never == 1 ? "has" : "have",
                                safe_depth_m(vehicle)));
  }
  if (unsounded > 0) {
    notes.push_back(
        fmt::format("{} lead where the data hold no depth: nothing is said of their water",
                    counted(unsounded, "leg")));
  }
  if (untold > 0) {
    notes.push_back(
        fmt::format("{} end after the tide's table: nothing is said of their water when sailed",
                    counted(untold, "leg")));
  }
}

}  // namespace

PlannedSurvey recorded(const std::string& planner, const std::string& label, Plan plan,
                       ScoredRoute scored, const Site& site, const Survey& survey,
                       const std::vector<Beginning>& beginnings) {
  std::vector<LegWater> water = water_of_legs(plan.route, survey.vehicle, *site.depths,
                                              {site.tide.get(), site.departure_s, beginnings});
  add_water(plan.route, water, scored.score.route);
  if (site.is_timed()) note_water(water, site, plan.route, survey.vehicle, plan.notes);
  if (const double land = scored.score.route.over_land_m; land > kTouchM) {
    plan.notes.push_back(fmt::format(
        "{:.1f} m of the route lead over land or through no-go areas: such legs are marked "
        "infeasible and must not be sailed",
        land));
  }
  if (const double unknown = scored.score.route.over_unknown_m; unknown >= 1.0) {
    plan.notes.push_back(
        fmt::format("{:.0f} m of the route lead over ground that the data do not tell of: nobody "
                    "has sounded it, or it is land; check them on a chart",
                    unknown));
  }
  PlannedSurvey result{plan_record(plan, survey.sonar, survey.vehicle, site.water, site.land),
                       std::move(plan), std::move(scored)};
  result.record.water = std::move(water);
  result.record.planner = planner;
  result.record.label = label;
  result.record.pings = survey.scoring.pings;
  result.record.grid_north = Angle::degrees(site.imported.convergence_deg);
  result.record.hazards = site.hazards;
  result.record.notes.insert(result.record.notes.end(), site.notes.begin(), site.notes.end());
  return result;
}

PlanOptions planning_for(const Site& site, const Survey& survey, const Scorer& scorer,
                         std::vector<std::string>& notes) {
  const Sonar sonar = counted_on(site, survey, notes);
  PlanOptions how = planning_over(scorer.ground(), site, survey, sonar);
  how.watch = scorer.watch();
  if (how.smooth) how.smooth->watch = how.watch;
  return how;
}

Plan made_plan(const Planner& planner, const Site& site, const Survey& survey,
               const Scorer& scorer) {
  std::vector<std::string> notes;
  const PlanOptions how = planning_for(site, survey, scorer, notes);
  how.watch.phase("laying lines");
  // A goal of its own comes first: the criterion then only judges.
  const bool to_pass = scorer.judge() != nullptr && planner.passes && !any(how.goal);
  Plan plan = to_pass ? plan_to_pass(*scorer.judge(), how) : planner.plan(scorer.ground(), how);
  plan.notes.insert(plan.notes.end(), notes.begin(), notes.end());
  if (how.start && !contains(site.water, *how.start) && !plan.route.waypoints.empty()) {
    const Vec2 first = in_file_of(site.imported, plan.route.waypoints.front().position);
    const int decimals = is_geographic(site.imported.file_crs_wkt) ? 6 : 1;
    plan.notes.push_back(
        fmt::format("--start {0} is not in safe water; the route begins at {1:.{3}f},{2:.{3}f}",
                    survey.start_text, first.x(), first.y(), decimals));
  }
  if (plan.route.waypoints.size() < 2) {
    throw InvalidInput(
        how.lane_width_m
            ? fmt::format("{}: no line of it fits into '{}' where swaths are about {:.4g} m wide; "
                          "use another --planner",
                          planner.name, site.imported.file, lane_m(how))
            : fmt::format("{}: no line of it fits into '{}' at a footprint width of {:.4g} m ({} "
                          "beams x --resolution {:g}); use finer cells or another --planner",
                          planner.name, site.imported.file, footprint_width_m(how), how.sonar.beams,
                          how.resolution_m));
  }
  if (!scorer.reach_note().empty()) plan.notes.push_back(scorer.reach_note());
  if (std::string note = unserved_note(site, plan.route); !note.empty()) {
    plan.notes.push_back(std::move(note));
  }
  if (!plan.heading) plan.heading = how.heading;
  if (plan.heading) {
    plan.notes.push_back(fmt::format("straight lines run along {}",
                                     azimuth_text(plan.heading->deg(), how.grid_north.deg())));
  }
  return plan;
}

PlannedSurvey scored_plan(const std::string& name, const std::string& label, Plan plan,
                          const Site& site, const Survey& survey, const Scorer& scorer,
                          bool one_sortie, const std::vector<Beginning>& beginnings) {
  mark_over_land(plan.route, site.land);
  ScoredRoute scored = scorer.score("scoring", plan.route);
  note_corners(scored.score.route, survey.vehicle, plan.notes);
  if (one_sortie) note_endurance(scored.score.route, survey.vehicle, plan.notes);
  PlannedSurvey planned =
      recorded(name, label, std::move(plan), std::move(scored), site, survey, beginnings);
  planned.judged = scorer.judge("judging by the criterion", planned.plan.route);
  return planned;
}

PlannedSurvey plan_and_score(const Planner& planner, const Site& site, const Survey& survey,
                             const Scorer& scorer) {
  const auto start = std::chrono::steady_clock::now();
  Plan plan = made_plan(planner, site, survey, scorer);
  const double planning = seconds_since(start);
  PlannedSurvey planned =
      scored_plan(planner.name, planner.label, std::move(plan), site, survey, scorer);
  planned.planning_seconds = planning;
  return planned;
}

}  // namespace swathplan
