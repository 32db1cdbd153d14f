#include "coverage/standards/area_rate.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "mesh/base/require.h"

namespace swathplan {

namespace {

// Halvings of [0, 90) degrees: far below the rounding of the formulas.
constexpr int kHalvings = 60;
// Thirds of the same: 0.618^n, down to about 1e-8 rad, where the rate no longer changes.
constexpr int kSections = 44;

void check_question(const RateQuestion& q) {
  require(q.sonar.beams >= 2, "beams", q.sonar.beams, "at least 2");
  require_positive("ping rate", q.sonar.max_ping_rate_hz);
  require_positive("range of the sonar", q.sonar.max_range_m);
  require(q.max_half_angle.deg() > 0.0 && q.max_half_angle.deg() < 90.0, "half-angle",
          q.max_half_angle.deg(), "above 0 and under 90 degrees");
  require_positive("resolution", q.cell_m);
  require_positive("ping spacing", q.ping_spacing_m.value_or(q.cell_m));
  require_positive("soundings", q.soundings);
  require_positive("speed", q.max_speed_mps);
  require(q.least_speed_mps >= 0.0 && q.least_speed_mps <= q.max_speed_mps, "least speed",
          q.least_speed_mps, "0 or more and at most the speed");
  require_positive("sound speed", q.sound_speed_mps);
}

AreaRate rate_at(const RateQuestion& q, double depth, double t) {
  PingTiming timing;
  timing.sound_speed_mps = q.sound_speed_mps;
  AreaRate rate;
  rate.half_angle = Angle::radians(t);
  rate.beam_spacing_m = edge_beam_spacing_m(q.sonar, depth, rate.half_angle);
  rate.ping_interval_s = ping_interval_s(q.sonar, timing, depth / std::cos(t));
  const double ping_spacing = q.ping_spacing_m.value_or(q.cell_m) / rate.ping_interval_s;
  const double soundings =
      q.cell_m * q.cell_m / (q.soundings * rate.beam_spacing_m * rate.ping_interval_s);
  rate.speed_mps = std::min({q.max_speed_mps, ping_spacing, soundings});
  rate.limit = rate.speed_mps == q.max_speed_mps ? RateLimit::vehicle
               : rate.speed_mps == ping_spacing  ? RateLimit::ping_spacing
                                                 : RateLimit::soundings;
  rate.rate_m2ps = 2.0 * depth * rate.speed_mps * std::tan(t);
  return rate;
}

bool serves(const RateQuestion& q, double depth, const AreaRate& rate) {
  return rate.beam_spacing_m <= q.cell_m && rate.speed_mps >= q.least_speed_mps &&
         depth / cos(rate.half_angle) <= reach_m(q.sonar, rate.half_angle);
}

// All three conditions tighten as the fan opens, so those that serve are an interval from 0 on.
double widest_serving(const RateQuestion& q, double depth) {
  const auto good = [&](double t) { return serves(q, depth, rate_at(q, depth, t)); };
  double high = q.max_half_angle.rad();
  if (good(high)) return high;
  double low = 0.0;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (good(middle) ? low : high) = middle;
  }
  return low;
}

// Opening the fan, the rate first rises (the vehicle or the pings' spacing hold the speed) and then
// falls (the soundings do), so it has one summit.
double summit(const RateQuestion& q, double depth, double widest) {
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  const auto rate = [&](double t) { return rate_at(q, depth, t).rate_m2ps; };
  double low = 0.0;
  double high = widest;
  for (int i = 0; i < kSections; ++i) {
    const double a = high - golden * (high - low);
    const double b = low + golden * (high - low);
    if (rate(a) < rate(b)) {
      low = a;
    } else {
      high = b;
    }
  }
  const double t = 0.5 * (low + high);
  return rate(widest) >= rate(t) ? widest : t;
}

std::optional<AreaRate> best_of(const RateQuestion& q, double depth) {
  // A fan narrower than this, in radians, is none.
  constexpr double kNoFan = 1e-6;
  const double widest = widest_serving(q, depth);
  if (widest < kNoFan) return std::nullopt;
  return rate_at(q, depth, summit(q, depth, widest));
}

}  // namespace

double edge_beam_spacing_m(const Sonar& sonar, double depth_m, Angle half_angle) {
  const double gaps = sonar.beams - 1;
  const double cosine = cos(half_angle);
  return sonar.spacing == BeamSpacing::equiangular
             ? 2.0 * half_angle.rad() * depth_m / (gaps * cosine * cosine)
             : 2.0 * depth_m * tan(half_angle) / gaps;
}

std::optional<AreaRate> area_rate(const RateQuestion& question, double depth_m, Angle half_angle) {
  check_question(question);
  require_positive("depth below the sonar", depth_m);
  require(half_angle.deg() > 0.0 && half_angle.deg() < 90.0, "half-angle", half_angle.deg(),
          "above 0 and under 90 degrees");
  const AreaRate rate = rate_at(question, depth_m, half_angle.rad());
  return serves(question, depth_m, rate) ? std::optional(rate) : std::nullopt;
}

std::optional<AreaRate> best_area_rate(const RateQuestion& question, double depth_m) {
  check_question(question);
  require_positive("depth below the sonar", depth_m);
  return best_of(question, depth_m);
}

LeastHours least_hours(const RateQuestion& question, std::span<const DepthArea> places) {
  check_question(question);
  return least_hours([&](double) { return std::optional(question); }, places);
}

LeastHours least_hours(const QuestionAt& question_at, std::span<const DepthArea> places,
                       double between_m) {
  struct DepthBin {
    double area_m2 = 0.0, volume_m3 = 0.0;
  };
  std::map<long, DepthBin> bins;
  for (const DepthArea& place : places) {
    if (!(place.depth_m > 0.0) || !(place.area_m2 > 0.0)) continue;
    DepthBin& bin = bins[std::lround(std::log(place.depth_m) / kDepthBin)];
    bin.area_m2 += place.area_m2;
    bin.volume_m3 += place.area_m2 * place.depth_m;
  }
  LeastHours result;
  for (const auto& [key, bin] : bins) {
    const double depth = bin.volume_m3 / bin.area_m2;
    const std::optional<RateQuestion> question = question_at(depth);
    if (question) check_question(*question);
    const std::optional<AreaRate> best = question ? best_of(*question, depth) : std::nullopt;
    if (best) {
      // What stays unseen is passed no faster than the boat can go.
      const double rate = best->rate_m2ps + between_m * question->max_speed_mps;
      result.area_m2 += bin.area_m2;
      result.hours += bin.area_m2 / rate / 3600.0;
      result.deepest_m = depth;
    } else {
      result.unreachable_m2 += bin.area_m2;
      if (result.shoalest_unreachable_m == 0.0) result.shoalest_unreachable_m = depth;
    }
  }
  return result;
}

}  // namespace swathplan
