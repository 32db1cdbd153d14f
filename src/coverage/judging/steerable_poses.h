#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/plane/polygons.h"

namespace swathplan {

/// Tells where and on which courses a boat that cannot go astern may be. A pose counts as steerable
/// if the boat can come there from afar and sail on for ever, turning no tighter than its radius,
/// without leaving safe water: it is in no dead end that is too narrow to turn in.
/// Looked up on a lattice of places (a tenth of the radius apart, or farther where there would be
/// more than kMostPlaces) and kCourses courses, so to about that distance and half a course.
class SteerablePoses {
 public:
  SteerablePoses(const Area& safe_water, double turn_radius_m);
  /// `course`: of length 1.
  [[nodiscard]] bool steerable(const Vec2& position, const Vec2& course) const;

  static constexpr int kCourses = 16;
  static constexpr double kMostPlaces = 4e6;

 private:
  [[nodiscard]] std::size_t place(const Vec2& p) const;  ///< size of the lattice: outside it
  [[nodiscard]] bool goes_on(std::size_t place, int course) const;
  void leave_dead_ends();

  double cell_ = 1.0, step_ = 1.0;
  Vec2 origin_ = Vec2::Zero();
  std::size_t columns_ = 0, rows_ = 0;
  std::vector<std::uint16_t> ways_;  ///< of each place: one bit for each course to sail on by
  std::vector<std::uint8_t> water_;
};

}  // namespace swathplan
