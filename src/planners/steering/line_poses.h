#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "planners/steering/dubins.h"

namespace swathplan {

/// Finds poses on a line of points by the metres sailed along it. A point nearer than kCoincidentM
/// to the point before it is dropped.
class LinePoses {
 public:
  explicit LinePoses(const std::vector<Vec2>& line);

  /// A place on the line and the course there.
  struct Place {
    double along_m = 0.0;
    Pose pose;
    std::optional<std::size_t> point;  ///< index into points(), if the place is one of them
    std::size_t source = 0;            ///< last point of the given line at or before the place
  };

  [[nodiscard]] double length_m() const { return along_.back(); }
  /// True if the line has no course: fewer than two points that differ.
  [[nodiscard]] bool is_point() const { return points_.size() < 2; }
  /// The place `along_m` metres along the line, in [0, length_m()]. Short segments are chords of a
  /// curve, and a cut chord would leave a bend tighter than the curve. A place on one moves to a
  /// point of the line, where the course is the mean of the courses before and after.
  [[nodiscard]] Place at(double along_m) const;

  [[nodiscard]] const std::vector<Vec2>& points() const { return points_; }
  [[nodiscard]] const std::vector<double>& along() const { return along_; }
  [[nodiscard]] const std::vector<std::size_t>& source() const { return source_; }
  /// The turn radius that point i asks for (bends.h) of a vehicle that turns on `turn_radius_m`;
  /// infinite at the ends.
  [[nodiscard]] double radius_at(std::size_t i, double turn_radius_m) const;

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
