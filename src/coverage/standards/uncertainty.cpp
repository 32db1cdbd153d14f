#include "coverage/standards/uncertainty.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "mesh/base/error.h"
#include "mesh/base/require.h"

namespace swathplan {

namespace {

// 95 % of a normal deviation in one dimension, and of two equal ones in the plane.
constexpr double kVertical95 = 1.96;
constexpr double kHorizontal95 = 2.45;

double squared(double x) { return x * x; }

struct NamedSigma {
  const char* name;
  std::optional<double> value;  // metres, radians, m/s or seconds
};

std::optional<double> radians_of(const std::optional<Angle>& angle) {
  return angle ? std::optional(angle->rad()) : std::nullopt;
}

std::vector<NamedSigma> sigmas_of(const UncertaintyBudget& b) {
  return {{"range uncertainty", b.range_m},
          {"beam angle uncertainty", radians_of(b.beam_angle)},
          {"sound speed uncertainty", b.mean_sound_speed_mps},
          {"head sound speed uncertainty", b.head_sound_speed_mps},
          {"roll uncertainty", radians_of(b.roll)},
          {"pitch uncertainty", radians_of(b.pitch)},
          {"heading uncertainty", radians_of(b.heading)},
          {"heave uncertainty", b.heave_m},
          {"position uncertainty", b.position_m},
          {"timing uncertainty", b.timing_s},
          {"draft uncertainty", b.draft_m},
          {"squat uncertainty", b.squat_m},
          {"water level uncertainty", b.water_level_m}};
}

void check_budget(const UncertaintyBudget& budget) {
  const std::vector<std::string> unknown = missing(budget);
  if (!unknown.empty()) {
    throw UsageError(fmt::format(
        "the uncertainty of a sounding needs a standard deviation that was not given: <{}>; give "
        "{}, or a <positioning> and <motion sensor> that know them",
        fmt::join(unknown, ">, <"), unknown.size() == 1 ? "it" : "them"));
  }
  for (const NamedSigma& sigma : sigmas_of(budget)) {
    require(*sigma.value >= 0.0 && std::isfinite(*sigma.value), sigma.name, *sigma.value,
            "a finite number of 0 or more");
  }
  require_positive("sound speed", budget.sound_speed_mps);
  require(budget.heave_share >= 0.0 && std::isfinite(budget.heave_share), "heave share",
          budget.heave_share, "a finite number of 0 or more");
  require(budget.expected_heave_m >= 0.0 && std::isfinite(budget.expected_heave_m),
          "expected heave", budget.expected_heave_m, "a finite number of 0 or more");
}

}  // namespace

std::vector<std::string> missing(const UncertaintyBudget& budget) {
  std::vector<std::string> names;
  for (const NamedSigma& sigma : sigmas_of(budget)) {
    if (!sigma.value) names.emplace_back(sigma.name);
  }
  return names;
}

UncertaintyModel::UncertaintyModel(const UncertaintyBudget& b) {
  check_budget(b);
  range2_ = squared(*b.range_m);
  beam_angle2_ = squared(b.beam_angle->rad());
  roll2_ = squared(b.roll->rad());
  pitch2_ = squared(b.pitch->rad());
  heading2_ = squared(b.heading->rad());
  mean_speed2_ = squared(*b.mean_sound_speed_mps / b.sound_speed_mps);
  head_speed2_ = squared(*b.head_sound_speed_mps / b.sound_speed_mps);
  half_beam_ = 1.0 - cos(b.beam_width_along / 2.0);
  heave2_ = squared(std::max(*b.heave_m, b.heave_share * b.expected_heave_m));
  draft2_ = squared(*b.draft_m);
  squat2_ = squared(*b.squat_m);
  water_level2_ = squared(*b.water_level_m);
  position2_ = squared(*b.position_m);
  timing2_ = squared(*b.timing_s);
}

/// The squares that add up to that of a depth.
struct UncertaintyParts {
  double range, sound_speed, beam_angle, roll, head_sound_speed, beam_width;

  UncertaintyParts(const UncertaintyModel& m, double depth, double across, double cosine,
                   double tangent2)
      : range(cosine * cosine * m.range2_),
        sound_speed(depth * depth * m.mean_speed2_),
        beam_angle(across * across * m.beam_angle2_),
        roll(across * across * m.roll2_),
        head_sound_speed(across * across * tangent2 * m.head_speed2_),
        beam_width(squared(depth * m.half_beam_)) {}

  [[nodiscard]] double sum() const {
    return range + sound_speed + beam_angle + roll + head_sound_speed + beam_width;
  }
  [[nodiscard]] static std::vector<UncertaintyPart> named(const UncertaintyModel& m,
                                                          const SoundingGeometry& s) {
    const double c = cos(s.from_vertical);
    const UncertaintyParts p(m, s.range_m * c, s.range_m * sin(s.from_vertical), c,
                             squared(tan(s.from_vertical)));
    return {{"range", std::sqrt(p.range)},
            {"sound speed", std::sqrt(p.sound_speed)},
            {"beam angle", std::sqrt(p.beam_angle)},
            {"roll", std::sqrt(p.roll)},
            {"sound speed at the head", std::sqrt(p.head_sound_speed)},
            {"beam width", std::sqrt(p.beam_width)},
            {"heave", std::sqrt(m.heave2_)},
            {"draft", std::sqrt(m.draft2_)},
            {"squat", std::sqrt(m.squat2_)},
            {"water level", std::sqrt(m.water_level2_)}};
  }
};

SoundingUncertainty UncertaintyModel::of(const SoundingGeometry& s) const {
  return of_beam(cos(s.from_vertical), s.range_m, s.speed_mps);
}

SoundingUncertainty UncertaintyModel::of_beam(double cosine, double range_m,
                                              double speed_mps) const {
  const double sine2 = std::max(0.0, 1.0 - cosine * cosine);
  const double depth = range_m * cosine;
  const double across = range_m * std::sqrt(sine2);
  const double tangent2 = sine2 / (cosine * cosine);
  const double depth2 = UncertaintyParts(*this, depth, across, cosine, tangent2).sum() +
                        (heave2_ + draft2_ + squat2_ + water_level2_);
  const double across2 = sine2 * range2_ + across * across * mean_speed2_ +
                         depth * depth * (beam_angle2_ + roll2_ + tangent2 * head_speed2_) +
                         position2_;
  const double along2 = depth * depth * pitch2_ + across * across * heading2_ +
                        speed_mps * speed_mps * timing2_ + position2_;
  return {kVertical95 * std::sqrt(depth2), kHorizontal95 * std::sqrt((along2 + across2) / 2.0)};
}

SoundingUncertainty sounding_uncertainty(const UncertaintyBudget& budget,
                                         const SoundingGeometry& sounding) {
  return UncertaintyModel(budget).of(sounding);
}

std::vector<UncertaintyPart> depth_parts(const UncertaintyBudget& budget,
                                         const SoundingGeometry& sounding) {
  return UncertaintyParts::named(UncertaintyModel(budget), sounding);
}

}  // namespace swathplan
