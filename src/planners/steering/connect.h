#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mesh/plane/polygons.h"
#include "planners/steering/dubins.h"

namespace swathplan {

/// How two lines are joined.
enum class JoinKind {
  curve,      ///< one Dubins path
  way,        ///< several Dubins paths, around land between the lines
  infeasible  ///< no forward path was found; the points are a way that the boat cannot steer
};

/// The way from one line to the next.
struct Connection {
  JoinKind kind = JoinKind::infeasible;
  std::vector<Vec2> points;   ///< from where the line before is left to where the next is met
  double off_before_m = 0.0;  ///< taken off the end of the line before
  double off_after_m = 0.0;   ///< taken off the beginning of the line after
  std::string reason;         ///< why it is infeasible: one sentence with the place; else empty
};

struct ConnectOptions {
  double radius_m = 1.5;  ///< smallest turn radius, > 0
  /// The largest share of a line that may be cut off at either end so that a turn fits.
  double longest_cut = 0.45;
  Frame frame = {};  ///< of the seafloor's file: reasons name places in its coordinates
};

/// Joins lines through safe water by forward motion, with turns no tighter than a radius. A line
/// that runs up to the water's edge is shortened there, as far as the turn needs.
/// Guarantees: (1) a feasible connection stays in the water (to SafeWater::kDust of its length) and
/// turns no tighter than the radius; (2) its first and last course are those of the lines.
/// Cost: a Dubins path and its check; where it is blocked, searches over poses (kMostPoses each).
/// Joins that took a search are kept for when they are asked for again, so it is not for use by
/// several threads at once.
class Connector {
 public:
  /// `safe_water`: where the boat may be, clearance taken off.
  Connector(const Area& safe_water, const ConnectOptions& options);
  ~Connector();
  Connector(Connector&&) noexcept;
  Connector& operator=(Connector&&) noexcept;

  /// `before` and `after`: points of the lines in sailing order. A line of one point may be sailed
  /// on any course.
  [[nodiscard]] Connection join(const std::vector<Vec2>& before,
                                const std::vector<Vec2>& after) const;
  /// The same with turns of `radius_m`, which is not below the options' radius. Empty where a quick
  /// search finds no such join.
  [[nodiscard]] std::optional<Connection> wider_join(const std::vector<Vec2>& before,
                                                     const std::vector<Vec2>& after,
                                                     double radius_m) const;
  /// Whether the boat can come onto a line and leave it. At both ends a quarter turn, or the same
  /// length straight on, must stay in the water. The line may be cut as far as allowed for that.
  [[nodiscard]] bool has_room(const std::vector<Vec2>& line) const;
  /// The shortest Dubins path between two poses that stays in the water; empty if none does.
  [[nodiscard]] std::vector<Vec2> curve(const Pose& from, const Pose& to) const;
  /// True if the path stays in the water.
  [[nodiscard]] bool in_water(const std::vector<Vec2>& points) const;

  /// The searches over poses so far, and the poses that they took: what joins cost.
  struct Effort {
    std::size_t searches = 0;
    std::size_t poses = 0;
  };
  [[nodiscard]] Effort effort() const;

  static constexpr int kMostPoses = 60000;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// A metre taken off a line costs this many metres of way, since lines are what the survey is for.
inline constexpr double kLineWorth = 2.0;
}  // namespace swathplan
