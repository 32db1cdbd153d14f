#pragma once

#include <optional>
#include <string>
#include <vector>

#include "planners/plan.h"
#include "planners/rows/survey_lines.h"
#include "planners/smoothing/join_smoothing.h"
#include "planners/steering/connect.h"

namespace swathplan {

/// A route, and notes about its joins.
struct BuiltRoute {
  Route route;
  std::vector<std::string> notes;
};

/// What joins lines on this ground for this vehicle. Built once a plan: all its builders share it.
[[nodiscard]] Connector connector_for(const Ground& ground, const PlanOptions& options);

/// A turn joins lines whose ends lie no farther apart than this, metres: two lanes. A transit
/// joins all others.
[[nodiscard]] double turn_reach_m(const PlanOptions& options);

/// A straight stretch of a join is worth speeding up for if it is this many turn radii long.
inline constexpr double kStraightRadii = 4.0;

/// Joins survey lines into a route that the vehicle can steer. Turns of a line that are too tight
/// are replaced (steer.h). Run-in and run-out are added. Each line is joined to the one before
/// through the water (connect.h): by a `turn` where the lines end within two lanes of
/// each other, else by a `transit`. Both keep the fan of the line before and are not logged. Where
/// logged legs count, the boat speeds up on the way: straight stretches of kStraightRadii turn
/// radii or more are a `transit`, half as long ones a `turn` at the lines' speed. Where no path was
/// found, the join is marked `feasible = false`. With `options.smooth` the bends of joins are
/// smoothed (join_smoothing.h), until the watch ends the search.
class RouteBuilder {
 public:
  /// `connector` is that of this ground and vehicle and must outlive the builder.
  RouteBuilder(const Ground& ground, const PlanOptions& options, const Connector& connector);
  RouteBuilder(const RouteBuilder&) = delete;
  RouteBuilder& operator=(const RouteBuilder&) = delete;

  /// Appends a join and a line. The line has at least one point, with its `kind`, `fan` and so on
  /// set.
  void add_line(const std::vector<Waypoint>& points);
  /// Appends a join and a line that stays as it is.
  void append(std::vector<Waypoint> line);
  /// Appends a given join and a line; both stay as they are. The join begins with the end of the
  /// route as its first waypoint, and ends before the line.
  void append(const std::vector<Waypoint>& join, const std::vector<Waypoint>& line);
  /// Where the route ends so far.
  [[nodiscard]] std::optional<Vec2> at() const;
  /// One sentence for each infeasible join, and one about turns that were too tight.
  [[nodiscard]] std::vector<std::string> notes() const;
  /// Marks the last waypoint as the end and returns the route.
  [[nodiscard]] Route finish();
  /// The same with the notes.
  [[nodiscard]] BuiltRoute built();

 private:
  [[nodiscard]] std::vector<Waypoint> steered_line(const std::vector<Waypoint>& points);
  void add_run(std::vector<Waypoint>& line, double metres, bool in);
  void join_to(std::vector<Waypoint>& line);

  const Connector& connector_;
  std::optional<JoinSmoother> smoother_;
  Watch watch_;
  Vehicle vehicle_;
  double run_in_, run_out_;
  double turn_reach_;
  bool speeds_up_;  // on straight stretches of joins
  Route route_;
  std::size_t line_begin_ = 0;  // of the last line in the route
  std::vector<std::string> notes_;
  std::size_t tight_joins_ = 0, plain_joins_ = 0, loops_ = 0, left_tight_ = 0, short_runs_ = 0;
  double loop_m_ = 0.0;
};

/// The route with new joins, as the options ask. Wider turns may shorten the ends of lines; else
/// lines stay. Joins marked infeasible stay.
[[nodiscard]] BuiltRoute rejoined(const Route& route, const Ground& ground,
                                  const PlanOptions& options, const Connector& connector);

/// The two waypoints of a straight survey line.
[[nodiscard]] std::vector<Waypoint> line_waypoints(const SurveyLine& line, int number,
                                                   const FanAngles& fan,
                                                   const PlanOptions& options);

}  // namespace swathplan
