#include "coverage/route/sonar.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace swathplan {

std::vector<Sonar> sonar_presets() {
  const auto preset = [](std::string name, int beams, double along, double across, double opening,
                         double rate, double range, bool dual = false) {
    return Sonar{.name = std::move(name),
                 .beams = beams,
                 .beam_width_along = Angle::degrees(along),
                 .beam_width_across = Angle::degrees(across),
                 .max_opening = Angle::degrees(opening),
                 .max_ping_rate_hz = rate,
                 .max_range_m = range,
                 .dual_swath = dual};
  };
  return {preset("norbit-iwbms", 256, 1.9, 0.9, 160, 60, 275),
          preset("norbit-iwbms-512", 512, 1.9, 0.9, 160, 60, 275),
          preset("r2sonic-2024", 256, 1.0, 0.5, 160, 60, 500),
          preset("reson-t50", 512, 1.0, 0.5, 150, 50, 575),
          preset("em2040", 400, 1.0, 1.0, 140, 50, 600)};
}

std::optional<Sonar> sonar_preset(std::string_view wanted) {
  for (Sonar& sonar : sonar_presets()) {
    if (sonar.name == wanted) return sonar;
  }
  return std::nullopt;
}

double footprint_width_m(const Sonar& sonar, double resolution_m) {
  return static_cast<double>(sonar.beams) * resolution_m;
}

Angle half_angle(const Sonar& sonar, double width_m, double depth_m) {
  const Angle wanted = Angle::radians(std::atan2(0.5 * width_m, std::max(depth_m, 1e-6)));
  return std::min(wanted, sonar.max_opening / 2.0);
}

Angle widest_half_angle(const Sonar& sonar, double depth_m) {
  // Reach falls and range grows with the angle, so bisection finds where they meet.
  const auto meets = [&](double t) {
    return depth_m / std::cos(t) <= reach_m(sonar, Angle::radians(t));
  };
  double low = 0.0;
  double high = sonar.max_opening.rad() / 2.0;
  if (meets(high)) return Angle::radians(high);
  if (!meets(low)) return {};
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (meets(middle) ? low : high) = middle;
  }
  return Angle::radians(low);
}

Angle gap_free_half_angle(const Sonar& sonar, double depth_m, double cell_m) {
  // 2 t sec^2(t) grows with t on [0, 90) degrees, so bisection finds the one root.
  const double target = cell_m * static_cast<double>(sonar.beams - 1) / std::max(depth_m, 1e-6);
  double low = 0.0;
  double high = sonar.max_opening.rad() / 2.0;
  const auto spread = [](double t) { return 2.0 * t / (std::cos(t) * std::cos(t)); };
  if (spread(high) <= target) return Angle::radians(high);
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (spread(middle) <= target ? low : high) = middle;
  }
  return Angle::radians(low);
}

double reach_m(const Sonar& sonar, Angle angle) {
  // The deepest ground that the curve still lets this beam see. Angles fall with depth.
  const double off_nadir = std::abs(angle.rad());
  const auto& curve = sonar.coverage_curve;
  double deepest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const double here = curve[i].half_angle.rad();
    if (here >= off_nadir) continue;
    if (i == 0) return 0.0;
    const double before = curve[i - 1].half_angle.rad();
    const double share = (before - off_nadir) / (before - here);
    deepest = curve[i - 1].depth_m + share * (curve[i].depth_m - curve[i - 1].depth_m);
    break;
  }
  return std::min(sonar.max_range_m, deepest / std::cos(off_nadir));
}

std::vector<double> beam_angles_rad(const Sonar& sonar, const FanAngles& fan) {
  const auto n = static_cast<std::size_t>(sonar.beams);
  std::vector<double> angles(n);
  const double port = fan.port.rad();
  const double starboard = fan.starboard.rad();
  for (std::size_t i = 0; i < n; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(n - 1);
    angles[i] = sonar.spacing == BeamSpacing::equiangular
                    ? -port + share * (port + starboard)
                    : std::atan(-std::tan(port) + share * (std::tan(port) + std::tan(starboard)));
  }
  return angles;
}

}  // namespace swathplan
