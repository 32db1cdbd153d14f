#include "planners/fitted/line_workshop.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "planners/fitted/held_fans.h"
#include "planners/fronts/field_lines.h"
#include "planners/fronts/rate_width.h"
#include "planners/steering/dubins.h"

namespace swathplan {
namespace {

/// Between ends that lie farther apart than so many turn radii, an estimate of turns will do.
constexpr double kNearRadii = 8.0;

/// Straight ways are sailed at the speed of lines from this share of those on that are worth
/// speeding up for.
constexpr double kSomeStraight = 0.5;

}  // namespace

namespace {

Connector connector_with(const Ground& ground, const PlanOptions& options,
                         std::optional<double> longest_cut) {
  if (!longest_cut) return connector_for(ground, options);
  return {ground.water,
          {.radius_m = options.vehicle.turn_radius_m,
           .longest_cut = *longest_cut,
           .frame = ground.seafloor ? ground.seafloor->frame : Frame{}}};
}

}  // namespace

LineWorkshop::LineWorkshop(const Ground& ground, const PlanOptions& options,
                           std::optional<double> longest_cut)
    : ground_(ground),
      options_(options),
      with_arcs_(options),
      raster_(ground),
      survey_area_(ground.survey_area),
      lines_in_(offset(ground.water, -kLineClearance)),
      joins_(ground.water, options.vehicle.turn_radius_m),
      connector_(connector_with(ground, options, longest_cut)) {
  with_arcs_.smooth.reset();
}

const std::vector<float>& LineWorkshop::width(double gap) {
  auto [it, fresh] = widths_.try_emplace(gap);
  if (fresh) {
    it->second = options_.counted == Counted::logged
                     ? rate_width_field(raster_, options_, gap, options_.lines_margin)
                     : width_field(raster_, options_, gap);
  }
  return it->second;
}

double LineWorkshop::mean_ping_spacing_m() const {
  return ping_spacing_m(options_, depth_range(*ground_.seafloor).mean);
}

double LineWorkshop::price() {
  // Candidates open their fans a little wider than gap-free, so the least length is for such fans.
  constexpr double kWiderThanGapFree = 1.2;
  const double ideal = area_m2(ground_.survey_area) / footprint_width_m(options_);
  return worth_per_ratio(least_line_m(raster_, width(kWiderThanGapFree)) / ideal);
}

LineEnds ends_of(const std::vector<Waypoint>& line) {
  LineEnds ends;
  ends.from = line.front().position;
  ends.to = line.back().position;
  ends.course_from = (line[1].position - ends.from).normalized();
  ends.course_to = (ends.to - line[line.size() - 2].position).normalized();
  return ends;
}

std::vector<Waypoint> backwards(const std::vector<Waypoint>& line) {
  std::vector<Waypoint> result(line.rbegin(), line.rend());
  for (std::size_t i = 0; i < result.size(); ++i) {
    // The properties of the segment from k to k + 1 now hold from k + 1 to k.
    const std::size_t from = i + 1 < result.size() ? i + 1 : i;
    const Vec2 position = result[i].position;
    result[i] = line[line.size() - 1 - from];
    result[i].position = position;
    if (result[i].fan) std::swap(result[i].fan->port, result[i].fan->starboard);
  }
  return result;
}

std::vector<std::vector<Waypoint>> LineWorkshop::sailed(const std::vector<SurveyCurve>& lines,
                                                        const std::vector<float>& width,
                                                        const LineAnglesOptions& angles,
                                                        double edge_share) const {
  auto opened = opened_lines(lines, raster_, width, survey_area_, options_, angles);
  std::erase_if(opened, [](const auto& line) { return line.size() < 2; });
  if (options_.counted == Counted::logged) {
    hold_fans(opened, raster_, survey_area_, options_, edge_share);
  }
  std::vector<LineEnds> ends;
  ends.reserve(opened.size());
  for (const auto& line : opened) ends.push_back(ends_of(line));
  std::vector<std::vector<Waypoint>> result;
  int number = 1;
  for (const OrderedLine& next : line_order(ends, cost_of_joins(), options_.start)) {
    result.push_back(next.backwards ? backwards(opened[next.line]) : opened[next.line]);
    number = numbered(result.back(), number) + 1;
  }
  return result;
}

int LineWorkshop::numbered(std::vector<Waypoint>& line, int number) const {
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool held = options_.counted == Counted::logged && options_.angles == Angles::line;
    const bool fresh =
        held && i > 0 &&
        (line[i].fan != line[i - 1].fan || line[i].speed_mps != line[i - 1].speed_mps);
    if (fresh) ++number;
    line[i].line = number;
  }
  return number;
}

LineCost LineWorkshop::cost_of_joins() const {
  if (options_.counted != Counted::logged) return std::cref(joins_);
  return [this](const Vec2& a, const Vec2& course_a, const Vec2& b, const Vec2& course_b) {
    return join_seconds(a, course_a, b, course_b);
  };
}

double LineWorkshop::join_seconds(const Vec2& a, const Vec2& course_a, const Vec2& b,
                                  const Vec2& course_b) const {
  const Vehicle& vehicle = options_.vehicle;
  const double straight = (b - a).norm();
  const double way = joins_.way(a, b);
  double metres = way + joins_.turning(a, course_a, b, course_b, way);
  // About half a circle is sailed at the speed of turns. The rest is faster where it is long.
  double turn = std::min(metres, std::numbers::pi * vehicle.turn_radius_m);
  if (way <= straight && straight < kNearRadii * vehicle.turn_radius_m) {
    const DubinsPath path =
        dubins_paths({a, course_a}, {b, course_b}, (1.0 + kRadiusReserve) * vehicle.turn_radius_m)
            .front();
    metres = path.length_m();
    turn = metres - path.straight_m();
  }
  const double rest = metres - turn;
  const double worth_m = kStraightRadii * vehicle.turn_radius_m;
  double speed = vehicle.turn_speed_mps;
  if (rest >= worth_m) {
    speed = vehicle.transit_speed_mps;
  } else if (rest >= kSomeStraight * worth_m) {
    speed = std::max(speed, std::min(vehicle.speed_mps, vehicle.transit_speed_mps));
  }
  return turn / vehicle.turn_speed_mps + rest / speed;
}

BuiltRoute LineWorkshop::build(const std::vector<SurveyCurve>& lines,
                               const std::vector<float>& width, const LineAnglesOptions& angles,
                               double edge_share) {
  return join(sailed(lines, width, angles, edge_share));
}

Outcome LineWorkshop::estimate(const std::vector<SurveyCurve>& lines,
                               const std::vector<float>& width, const LineAnglesOptions& angles,
                               int coarse, std::string what) {
  Route route;
  const Vehicle& vehicle = options_.vehicle;
  double joins = 0.0;          // metres of joins, less the straight ways that are scored for them
  double joins_seconds = 0.0;  // the same in seconds
  for (const auto& line : sailed(lines, width, angles, 1.0)) {
    auto& w = route.waypoints;
    const LineEnds here = ends_of(line);
    if (!w.empty()) {
      const Vec2 course = (w.back().position - w[w.size() - 2].position).normalized();
      const double join = joins_(w.back().position, course, here.from, here.course_from);
      const double straight = (here.from - w.back().position).norm();
      joins += join;
      joins -= straight;
      const bool turn = straight <= turn_reach_m(options_);
      joins_seconds += join / (turn ? vehicle.turn_speed_mps : vehicle.transit_speed_mps);
      joins_seconds -= straight / w.back().speed_mps;
      w.back().kind = LegKind::transit;
      // A straight way sounds about what the steered one will. A way around something sounds
      // elsewhere, so its sonar is off here.
      if (joins_.way(w.back().position, here.from) > straight) w.back().fan.reset();
      w.back().line.reset();
      w.back().log = false;
    }
    w.insert(w.end(), line.begin(), line.end());
  }
  if (route.waypoints.size() < 2) return {};
  route.waypoints.back().kind = LegKind::end;
  route.waypoints.back().log = false;
  route.waypoints.back().line.reset();
  Outcome outcome = judge(route, coarse, std::move(what));
  outcome.length_ratio *= (outcome.length_m + joins) / outcome.length_m;
  outcome.length_m += joins;
  outcome.duration_s += joins_seconds;
  return outcome;
}

BuiltRoute LineWorkshop::join(const std::vector<std::vector<Waypoint>>& lines) const {
  RouteBuilder builder(ground_, with_arcs_, connector_);
  for (const auto& line : lines) builder.add_line(line);
  return builder.built();
}

BuiltRoute LineWorkshop::with_smooth_joins(BuiltRoute built) const {
  if (!options_.smooth) return built;
  BuiltRoute smooth = rejoined(built.route, ground_, options_, connector_);
  built.route = std::move(smooth.route);
  for (std::string& note : smooth.notes) {
    const bool known = std::find(built.notes.begin(), built.notes.end(), note) != built.notes.end();
    if (!known) built.notes.push_back(std::move(note));
  }
  return built;
}

ScoredRoute LineWorkshop::score(const Route& route, int coarse, Swath swath) const {
  return score(route, coarse, how_to_score(coarse, swath));
}

ScoredRoute LineWorkshop::score(
    const Route& route,
    std::function<void(std::uint32_t, std::span<const std::uint32_t>)> logged_cells) const {
  ScoreOptions how = how_to_score(1, Swath::counted);
  how.logged_cells = std::move(logged_cells);
  return score(route, 1, how);
}

ScoreOptions LineWorkshop::how_to_score(int coarse, Swath swath) const {
  ScoreOptions how;
  how.resolution_m = coarse * options_.resolution_m;
  how.pings = options_.pings;
  how.pings.thinning = coarse * options_.pings.thinning;
  how.holiday_m2 = 1e9;
  how.footprint = options_.cover == Cover::footprint;
  how.swath_share = swath == Swath::counted ? counted_share(options_) : 1.0;
  how.noise = options_.noise;
  how.threads = options_.threads;
  return how;
}

ScoredRoute LineWorkshop::score(const Route& route, int coarse, const ScoreOptions& how) const {
  Sonar sonar = options_.sonar;
  sonar.beams = std::max(2, sonar.beams / coarse);
  sonar.beam_width_along = Angle::radians(coarse * sonar.beam_width_along.rad());
  sonar.beam_width_across = Angle::radians(coarse * sonar.beam_width_across.rad());
  return swathplan::score(route, ground_, sonar, options_.vehicle, how);
}

double LineWorkshop::cover_pct(const ScoredRoute& scored) const {
  const CoverageFigures& figures =
      options_.counted == Counted::logged ? scored.score.logged : scored.score.all;
  if (options_.cover == Cover::footprint) return figures.footprint_pct.value_or(0.0);
  if (options_.soundings <= 1.0) return figures.hit_pct;
  const CoverageGrid& grid = scored.grid;
  std::size_t served = 0;
  for (std::size_t i = 0; i < grid.words().size(); ++i) {
    served += grid.counts(i) && covered(grid, i) ? 1U : 0U;
  }
  return 100.0 * static_cast<double>(served) /
         static_cast<double>(std::max<std::uint64_t>(1, scored.score.cells));
}

bool LineWorkshop::covered(const CoverageGrid& grid, std::size_t i) const {
  const bool logged = options_.counted == Counted::logged;
  if (options_.cover == Cover::footprint) {
    return logged ? grid.logged_footprint(i) : grid.footprint(i);
  }
  const std::uint32_t soundings = logged ? grid.logged_soundings(i) : grid.soundings(i);
  return soundings >= options_.soundings;
}

Outcome LineWorkshop::judge(const Route& route, int coarse, std::string what) const {
  return judge(score(route, coarse), std::move(what));
}

Outcome LineWorkshop::judge(const ScoredRoute& scored, std::string what) const {
  const Score& score = scored.score;
  Outcome outcome;
  outcome.length_m = score.route.length_m;
  outcome.length_ratio = score.route.length_m * footprint_width_m(options_) / score.survey_area_m2;
  outcome.cover = options_.cover;
  outcome.cover_pct = cover_pct(scored);
  outcome.turns = score.route.turns;
  outcome.duration_s = score.route.duration_s;
  outcome.infeasible_legs = score.route.infeasible_legs;
  outcome.what = std::move(what);
  return outcome;
}

}  // namespace swathplan
