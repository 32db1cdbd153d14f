#pragma once

#include <optional>
#include <string>
#include <vector>

#include "planners/plan.h"
#include "planners/rows/survey_lines.h"
#include "planners/smoothing/join_smoothing.h"
#include "planners/steering/connect.h"

namespace swathplan {

/// A route with what its joins had to say.
struct BuiltRoute {
  Route route;
  std::vector<std::string> notes;
};

/// Strings survey lines together into a route that the vehicle can steer: turns of a line that are
/// too tight are replaced (steer.h), run-in and run-out are added, and each line is joined to the
/// one before through the water (connect.h), by a `turn` where the lines end within two footprint
/// widths of each other, else by a `transit`. Both keep the fan of the line before and are not
/// logged. Where no forward way was found, the join is marked `feasible = false`. With
/// `options.smooth` the bends of joins are smoothed (join_smoothing.h).
class RouteBuilder {
 public:
  RouteBuilder(const PlanningGround& ground, const PlanOptions& options);
  RouteBuilder(const RouteBuilder&) = delete;
  RouteBuilder& operator=(const RouteBuilder&) = delete;

  /// Appends a line (at least one point, its `kind`, `fan`, ... set) after a way to it.
  void add_line(const std::vector<Waypoint>& points);
  /// Appends a line as it is, after a way to it.
  void append(std::vector<Waypoint> line);
  /// Appends a line as it is, after a join as it is: from the end of the route, which is its first
  /// waypoint, to before the line.
  void append(const std::vector<Waypoint>& join, const std::vector<Waypoint>& line);
  /// Where the route ends so far.
  [[nodiscard]] std::optional<Vec2> at() const;
  /// One sentence per join that is infeasible, and what became of turns that were too tight.
  [[nodiscard]] std::vector<std::string> notes() const;
  /// Marks the last waypoint as the end and hands the route out.
  [[nodiscard]] Route finish();
  /// The same with the notes.
  [[nodiscard]] BuiltRoute built();

 private:
  [[nodiscard]] std::vector<Waypoint> steered_line(const std::vector<Waypoint>& points);
  void add_run(std::vector<Waypoint>& line, double metres, bool in);
  void join_to(std::vector<Waypoint>& line);

  Connector connector_;
  std::optional<JoinSmoother> smoother_;
  Vehicle vehicle_;
  double run_in_, run_out_;
  double turn_reach_;
  Route route_;
  std::size_t line_begin_ = 0;  // of the last line in the route
  std::vector<std::string> notes_;
  std::size_t tight_joins_ = 0, loops_ = 0, left_tight_ = 0, short_runs_ = 0;
  double loop_m_ = 0.0;
};

/// The route with its joins made anew, as the options ask. Lines stay but for what wider turns take
/// off their ends; joins marked infeasible stay.
[[nodiscard]] BuiltRoute rejoined(const Route& route, const PlanningGround& ground,
                                  const PlanOptions& options);

/// The two waypoints of a straight survey line.
[[nodiscard]] std::vector<Waypoint> line_waypoints(const SurveyLine& line, int number,
                                                   const FanAngles& fan,
                                                   const PlanOptions& options);

}  // namespace swathplan
