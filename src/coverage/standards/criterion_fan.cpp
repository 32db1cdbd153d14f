#include "coverage/standards/criterion_fan.h"

#include <algorithm>
#include <cmath>

#include "mesh/base/require.h"

namespace swathplan {

namespace {

// The uncertainty grows with the angle but for the range's small part, so it is looked at from the
// middle out in steps no longer than this, and the first step that fails is halved.
constexpr double kFanStepDeg = 0.25;
constexpr int kFanHalvings = 6;

// A curve of so many steps, each the same share deeper.
constexpr int kCurvePoints = 48;
// The sonar never hangs nearer to the ground than this, metres.
constexpr double kShoalestBelowM = 0.1;

// The half-angle that the sonar's own curve still sees at a depth.
Angle sees_to(const Sonar& sonar, double depth) {
  const auto& curve = sonar.coverage_curve;
  if (curve.empty()) return Angle::degrees(90);
  if (depth <= curve.front().depth_m) return curve.front().half_angle;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    if (depth > curve[i].depth_m) continue;
    const double share = (depth - curve[i - 1].depth_m) / (curve[i].depth_m - curve[i - 1].depth_m);
    return curve[i - 1].half_angle + (curve[i].half_angle - curve[i - 1].half_angle) * share;
  }
  return curve.back().half_angle;
}

class AcceptedBeams {
 public:
  AcceptedBeams(const Criterion& criterion, const UncertaintyModel& model, const Sonar& sonar,
                double depth, double draft, double speed)
      : model_(model), sonar_(sonar), depth_(depth), speed_(speed) {
    tvu_limit_ = tvu_limit_m(criterion, depth + draft);
    thu_limit_ = thu_limit_m(criterion, depth + draft);
    if (const std::optional<double> cube = feature_m(criterion, depth + draft)) {
      beam_spacing_ = *cube / criterion.features->beams;
    }
  }

  // Of a fan that ends at the angle, its outermost beam.
  [[nodiscard]] bool accepts(double degrees) const {
    const double t = Angle::degrees(degrees).rad();
    const SoundingUncertainty known = model_.of({Angle::radians(t), depth_ / std::cos(t), speed_});
    if (known.tvu_m > tvu_limit_ || known.thu_m > thu_limit_) return false;
    return !beam_spacing_ ||
           edge_beam_spacing_m(sonar_, depth_, Angle::radians(t)) <= *beam_spacing_;
  }

 private:
  const UncertaintyModel& model_;
  const Sonar& sonar_;
  double depth_, speed_, tvu_limit_, thu_limit_;
  std::optional<double> beam_spacing_;
};

}  // namespace

std::optional<Angle> accepted_half_angle(const Criterion& criterion, const UncertaintyModel& model,
                                         const Sonar& sonar, double depth_m, double draft_m,
                                         double speed_mps, Angle widest) {
  require_positive("depth below the sonar", depth_m);
  require(draft_m >= 0.0, "draft", draft_m, "0 or more");
  require(widest.deg() > 0.0 && widest.deg() < 90.0, "half-angle", widest.deg(),
          "above 0 and under 90 degrees");
  const AcceptedBeams beams(criterion, model, sonar, depth_m, draft_m, speed_mps);
  if (!beams.accepts(0.0)) return std::nullopt;
  double good = 0.0;
  double bad = widest.deg();
  for (double t = 0.0; good < widest.deg();) {
    t = std::min(t + kFanStepDeg, widest.deg());
    if (!beams.accepts(t)) {
      bad = t;
      break;
    }
    good = t;
  }
  if (good == widest.deg()) return widest;
  for (int i = 0; i < kFanHalvings; ++i) {
    const double middle = 0.5 * (good + bad);
    (beams.accepts(middle) ? good : bad) = middle;
  }
  return Angle::degrees(good);
}

Sonar narrowed_to(const Criterion& criterion, const UncertaintyModel& model, const Sonar& sonar,
                  const SonarDepths& depths, double draft_m, double speed_mps) {
  const double shoalest = std::max(depths.shoalest_m, kShoalestBelowM);
  const double deepest = std::max(depths.deepest_m, shoalest);
  Sonar narrowed = sonar;
  narrowed.coverage_curve.clear();
  double narrowest = sonar.max_opening.deg() / 2.0;
  for (int k = 0; k <= kCurvePoints; ++k) {
    const double depth = shoalest * std::pow(deepest / shoalest, k / double{kCurvePoints});
    const Angle own = std::min(sonar.max_opening / 2.0, sees_to(sonar, depth));
    const auto accepted = own.rad() > 0.0 ? accepted_half_angle(criterion, model, sonar, depth,
                                                                draft_m, speed_mps, own)
                                          : std::nullopt;
    narrowest = std::min(narrowest, accepted ? accepted->deg() : 0.0);
    narrowed.coverage_curve.push_back({depth, Angle::degrees(narrowest)});
    if (!(deepest > shoalest)) break;
  }
  return narrowed;
}

std::optional<RateQuestion> asked_by(const Criterion& criterion, const UncertaintyModel& model,
                                     const RateQuestion& question, double depth_m, double draft_m) {
  const std::optional<Angle> widest =
      accepted_half_angle(criterion, model, question.sonar, depth_m, draft_m,
                          question.max_speed_mps, question.max_half_angle);
  if (!widest || !(widest->rad() > 0.0)) return std::nullopt;
  RateQuestion asked = question;
  asked.max_half_angle = *widest;
  asked.cell_m = cell_m(criterion, depth_m + draft_m);
  asked.soundings = criterion.density ? criterion.density->soundings : 1.0;
  asked.ping_spacing_m = asked.cell_m;
  if (const std::optional<double> cube = feature_m(criterion, depth_m + draft_m)) {
    asked.ping_spacing_m = std::min(asked.cell_m, *cube / criterion.features->pings);
  }
  return asked;
}

}  // namespace swathplan
