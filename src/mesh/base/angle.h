#pragma once

#include <cmath>
#include <numbers>

namespace swathplan {

/// An angle. It has a type of its own, so that nobody takes degrees for radians. The command line
/// and the files use degrees; the program computes in radians. Not reduced to one turn.
class Angle {
 public:
  constexpr Angle() = default;
  [[nodiscard]] static constexpr Angle radians(double r) { return Angle(r); }
  [[nodiscard]] static constexpr Angle degrees(double d) {
    return Angle(d * std::numbers::pi / 180.0);
  }
  [[nodiscard]] constexpr double rad() const { return rad_; }
  [[nodiscard]] constexpr double deg() const { return rad_ * 180.0 / std::numbers::pi; }

  constexpr Angle operator+(Angle o) const { return Angle(rad_ + o.rad_); }
  constexpr Angle operator-(Angle o) const { return Angle(rad_ - o.rad_); }
  constexpr Angle operator-() const { return Angle(-rad_); }
  constexpr Angle operator*(double s) const { return Angle(rad_ * s); }
  constexpr Angle operator/(double s) const { return Angle(rad_ / s); }
  constexpr auto operator<=>(const Angle&) const = default;  // NOLINT(modernize-use-nullptr)

 private:
  explicit constexpr Angle(double r) : rad_(r) {}
  double rad_ = 0.0;
};

[[nodiscard]] inline double sin(Angle a) { return std::sin(a.rad()); }
[[nodiscard]] inline double cos(Angle a) { return std::cos(a.rad()); }
[[nodiscard]] inline double tan(Angle a) { return std::tan(a.rad()); }

}  // namespace swathplan
