#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "planners/steering/dubins.h"

namespace swathplan {

/// A line of points by the metres sailed along it. Points nearer than kCoincidentM to the one
/// before are dropped.
class LinePoses {
 public:
  explicit LinePoses(const std::vector<Vec2>& line);

  /// A place on the line: where, heading how, between which points of the line as given.
  struct Place {
    double along_m = 0.0;
    Pose pose;
    std::optional<std::size_t> point;  ///< index into points(), where it is one of them
    std::size_t source = 0;  ///< last point of the line as given that lies at or before it
  };

  [[nodiscard]] double length_m() const { return along_.back(); }
  /// True if the line has no course: fewer than two points that differ.
  [[nodiscard]] bool is_point() const { return points_.size() < 2; }
  /// The place `along_m` metres along the line, in [0, length_m()]. Within short segments, which
  /// belong to curves, it is moved to a point of the line, where the course is the mean of that
  /// before and after: cutting a chord would leave a bend that is tighter than the curve.
  [[nodiscard]] Place at(double along_m) const;

  [[nodiscard]] const std::vector<Vec2>& points() const { return points_; }
  [[nodiscard]] const std::vector<double>& along() const { return along_; }
  [[nodiscard]] const std::vector<std::size_t>& source() const { return source_; }
  /// Radius that point i asks for: as RouteFigures::min_turn_radius_m; infinite at the ends.
  [[nodiscard]] double radius_at(std::size_t i) const;

  static constexpr double kCoincidentM = 1e-6;
  /// Segments shorter than this are taken for chords of a curve, metres.
  static constexpr double kChordM = 0.5;

 private:
  [[nodiscard]] Vec2 course_at(std::size_t i) const;

  std::vector<Vec2> points_;
  std::vector<double> along_;
  std::vector<std::size_t> source_;
};

}  // namespace swathplan
