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

class AcceptedBeams {
 public:
  AcceptedBeams(const Criterion& criterion, const UncertaintyModel& model, const Sonar& sonar,
                double depth, double draft, double speed)
      : criterion_(criterion), model_(model), sonar_(sonar), depth_(depth), speed_(speed) {
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
  const Criterion& criterion_;
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
