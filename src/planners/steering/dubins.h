#pragma once

#include <array>
#include <vector>

#include "mesh/base/frame.h"

namespace swathplan {

/// Where a boat is and where it heads; local metres, `course` of length 1.
struct Pose {
  Vec2 position = Vec2::Zero();
  Vec2 course = Vec2::UnitY();
};

/// A forward path of at most three pieces, each a circle's arc or straight.
class DubinsPath {
 public:
  /// `turn[k]`: 1 to port, -1 to starboard, 0 straight ahead for `piece_m[k]` metres.
  DubinsPath(const Pose& from, double radius_m, const std::array<int, 3>& turn,
             const std::array<double, 3>& piece_m);

  [[nodiscard]] double length_m() const { return piece_[0] + piece_[1] + piece_[2]; }
  /// What of it is straight.
  [[nodiscard]] double straight_m() const;
  /// Where the boat is after `along_m` metres, in [0, length_m()].
  [[nodiscard]] Pose at(double along_m) const;
  /// Points at an even spacing of at most `step_m`, both ends included.
  [[nodiscard]] std::vector<Vec2> points(double step_m) const;

 private:
  Pose from_;
  double radius_;
  std::array<int, 3> turn_;
  std::array<double, 3> piece_;
};

/// Dubins paths between two poses with turns of `radius_m` > 0, shortest first: one for each word
/// that joins them, so six at most. Words are two turns with a straight between (CSC) or three
/// turns (CCC). Of the two paths of a CCC word only the one whose middle turn is longer than half a
/// circle is given, since the other is never the shortest. The first path is the shortest forward
/// path in open water whose turns are no tighter, but for rounding: turning circles that overlap or
/// lie apart by a ten-millionth of the radius count as touching or as one. Never empty. Two equal
/// poses give a path of length 0. Method: [shkel-dubins].
[[nodiscard]] std::vector<DubinsPath> dubins_paths(const Pose& from, const Pose& to,
                                                   double radius_m);

/// Length of the shortest Dubins path, metres.
[[nodiscard]] double dubins_length_m(const Pose& from, const Pose& to, double radius_m);

/// Curves are written in chords of at most this many metres ...
inline constexpr double kCurveStepM = 0.2;
/// ... and by no more than this change of course.
inline constexpr double kCurveStepDeg = 3.0;
/// Turns are planned wider than the smallest radius by this share. Where chords of unequal length
/// meet, a path of chords bends tighter than its curves, by up to a few per cent.
inline constexpr double kRadiusReserve = 0.02;
/// A radius is kept if it falls short by no more than this share.
inline constexpr double kRadiusDust = 1e-6;

}  // namespace swathplan
