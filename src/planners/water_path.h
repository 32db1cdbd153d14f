#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "planners/plan.h"
#include "planners/survey_lines.h"

namespace swathplan {

/// Finds short ways through the water: around quays, moles and islands, never across.
class WaterPath {
 public:
  /// `water`: where the boat may be; ways keep `clearance_m` from its outline where they can.
  explicit WaterPath(const Area& water, double clearance_m = 1.0);
  ~WaterPath();
  WaterPath(WaterPath&&) noexcept;
  WaterPath& operator=(WaterPath&&) noexcept;

  /// The way from `from` to `to`, both included; straight where that stays in the water. Empty
  /// where none exists (separate waters). A* on a lattice of at most kMostCells, then pulled taut.
  [[nodiscard]] std::optional<std::vector<Vec2>> find(const Vec2& from, const Vec2& to) const;

  static constexpr double kMostCells = 1e6;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Strings survey lines together into a route: each line is joined to the one before through the
/// water, by a `turn` where the lines end within two footprint widths of each other, else by a
/// `transit`. Both keep the fan of the line before and are not logged.
class RouteBuilder {
 public:
  RouteBuilder(const PlanningGround& ground, const PlanOptions& options);

  /// Appends a line (at least one point, its `kind`, `fan`, ... set) after a way to it.
  void add_line(const std::vector<Waypoint>& points);
  /// Where the route ends so far.
  [[nodiscard]] std::optional<Vec2> at() const;
  /// One sentence per join that is not through water.
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }
  /// Marks the last waypoint as the end and hands the route out.
  [[nodiscard]] Route finish();

 private:
  void join_to(const Waypoint& next);

  WaterPath paths_;
  double turn_reach_;
  Route route_;
  std::vector<std::string> notes_;
};

/// The two waypoints of a straight survey line.
[[nodiscard]] std::vector<Waypoint> line_waypoints(const SurveyLine& line, int number,
                                                   const FanAngles& fan,
                                                   const PlanOptions& options);

}  // namespace swathplan
