#include "coverage/route/pings.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "mesh/base/error.h"
#include "mesh/base/random.h"

namespace swathplan {

namespace {

// The order of draws is part of the result. An initialiser list draws from left to right.
std::array<double, 4> normals(std::mt19937_64& random) {
  const std::array<double, 4> u{uniform_above_0(random()), uniform_above_0(random()),
                                uniform_above_0(random()), uniform_above_0(random())};
  const auto [a, b] = normal_pair(u[0], u[1]);
  const auto [c, d] = normal_pair(u[2], u[3]);
  return {a, b, c, d};
}

void check(const TrackNoise& noise) {
  if (!(noise.correlation_length_m > 0)) {
    throw UsageError(fmt::format("correlation length = {} m; must be greater than 0",
                                 noise.correlation_length_m));
  }
  for (const double sigma : {noise.lateral_sigma_m, noise.heading_sigma.rad(),
                             noise.roll_sigma.rad(), noise.heave_sigma_m}) {
    if (!(sigma >= 0) || !std::isfinite(sigma)) {
      throw UsageError(
          fmt::format("standard deviation of the noise = {}; must be 0 or more", sigma));
    }
  }
}

double segment_length(const Route& route, std::size_t segment) {
  return (route.waypoints[segment + 1].position - route.waypoints[segment].position).norm();
}

Vec2 clockwise(const Vec2& v, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * v.x() + s * v.y(), -s * v.x() + c * v.y()};
}

}  // namespace

PingWalker::PingWalker(const Route& route, const Sonar& sonar, const PingTiming& timing,
                       const TrackNoise& noise, const std::optional<Box2>& reach)
    : route_(&route),
      sonar_(&sonar),
      timing_(timing),
      noise_(noise),
      reach_(reach),
      random_(noise.seed) {
  swathplan::check(sonar, timing);
  check(noise);
  if (route.waypoints.size() < 2) return;
  leg_of_segment_.resize(route.waypoints.size() - 1);
  std::uint32_t leg = 0;
  for (const Leg& l : legs(route)) {
    for (std::size_t s = l.first; s < l.last; ++s) leg_of_segment_[s] = leg;
    ++leg;
  }
  for (std::size_t s = 0; s < leg_of_segment_.size(); ++s) total_ += segment_length(route, s);
  segment_length_ = segment_length(route, 0);
  if (noise_.any()) noise_state_ = normals(random_);
}

void PingWalker::step_noise(double sailed_m) {
  if (!noise_.any()) return;
  const double keep = std::exp(-sailed_m / noise_.correlation_length_m);
  const double fresh = std::sqrt(1.0 - keep * keep);
  const std::array<double, 4> draw = normals(random_);
  for (std::size_t k = 0; k < 4; ++k) noise_state_[k] = keep * noise_state_[k] + fresh * draw[k];
}

bool PingWalker::push(std::vector<Ping>& block) const {
  const Waypoint& from = route_->waypoints[segment_];
  if (!from.fan || !(segment_length_ > 0)) return false;
  const Waypoint& to = route_->waypoints[segment_ + 1];
  const Vec2 course = (to.position - from.position) / segment_length_;
  const double along = std::clamp(at_ - segment_start_, 0.0, segment_length_);
  Ping ping{.position = from.position + along * course,
            .course = course,
            .roll = {},
            .heave_m = 0.0,
            .fan = *from.fan,
            .leg = leg_of_segment_[segment_],
            .log = from.log,
            .speed_mps = from.speed_mps,
            .path_m = at_};
  if (noise_.any()) {
    const double aside = noise_state_[0] * noise_.lateral_sigma_m + noise_.lateral_offset_m;
    ping.position += aside * Vec2(course.y(), -course.x());
    ping.course = clockwise(
        course, noise_state_[1] * noise_.heading_sigma.rad() + noise_.heading_offset.rad());
    ping.roll = noise_.roll_sigma * noise_state_[2];
    ping.heave_m = noise_state_[3] * noise_.heave_sigma_m;
  }
  block.push_back(ping);
  return true;
}

void PingWalker::enter_next_segment() {
  segment_start_ += segment_length_;
  segment_length_ = segment_length(*route_, ++segment_);
}

// The path that is sailed in so many seconds from where the boat is, through waypoints and their
// speeds.
double PingWalker::after_seconds(double seconds) {
  double at = at_;
  for (;;) {
    const double speed = route_->waypoints[segment_].speed_mps;
    const double end = segment_start_ + segment_length_;
    const bool last = segment_ + 1 >= leg_of_segment_.size();
    if (last || at + speed * seconds < end - kPathDust) return at + speed * seconds;
    seconds = std::max(0.0, seconds - (end - at) / speed);
    at = end;
    enter_next_segment();
  }
}

// Where the next ping is due.
double PingWalker::advance(const std::vector<Ping>& block, bool pinged,
                           const FarthestSounding& farthest) {
  if (timing_.spacing_m) {
    // One product a ping: sums of a million spacings would wander.
    return static_cast<double>(index_) * (timing_.thinning * *timing_.spacing_m);
  }
  if (pinged) {
    if (const double range = farthest(block.back()); range > 0.0) range_ = range;
    figures_.longest_range_m = std::max(figures_.longest_range_m, range_);
  }
  return after_seconds(ping_interval_s(*sonar_, timing_, range_));
}

// Goes on to the last ping that is due before the rest of the segment reaches data, or before its
// end where it never does. False where that is this ping.
bool PingWalker::skip_to_reach() {
  if (!reach_ || !(segment_length_ > 0)) return false;
  const Vec2& from = route_->waypoints[segment_].position;
  const Vec2& to = route_->waypoints[segment_ + 1].position;
  const double along = std::clamp((at_ - segment_start_) / segment_length_, 0.0, 1.0);
  const auto part = clipped(from + along * (to - from), to, *reach_);
  if (part && part->first <= 0.0) return false;
  const double ends = segment_start_ + segment_length_;
  const double until = part ? at_ + part->first * (ends - at_) : ends;
  const double step = timing_.spacing_m ? timing_.thinning * *timing_.spacing_m
                                        : route_->waypoints[segment_].speed_mps *
                                              ping_interval_s(*sonar_, timing_, range_);
  const double pings = std::floor((until - at_) / step);
  if (!(pings > 1.0)) return false;
  index_ += static_cast<std::uint64_t>(pings);
  const double next = timing_.spacing_m ? static_cast<double>(index_) * step : at_ + pings * step;
  figures_.beyond_data_m += next - at_;
  at_ = next;
  return true;
}

bool PingWalker::next(std::size_t count, std::vector<Ping>& block,
                      const FarthestSounding& farthest) {
  block.clear();
  while (block.size() < count && !leg_of_segment_.empty()) {
    if (at_ > total_ + kPathDust) break;
    while (segment_ + 1 < leg_of_segment_.size() &&
           at_ >= segment_start_ + segment_length_ - kPathDust) {
      enter_next_segment();
    }
    if (skip_to_reach()) continue;
    const bool pinged = push(block);
    const double here = at_;
    ++index_;
    at_ = advance(block, pinged, farthest);
    const double sailed = at_ - here;
    if (pinged && at_ <= total_ + kPathDust) {
      ++figures_.intervals;
      figures_.sound_bound += by_the_clock() && sound_binds(*sonar_, timing_, range_);
      sum_of_spacings_ += sailed;
      figures_.largest_spacing_m = std::max(figures_.largest_spacing_m, sailed);
    }
    step_noise(timing_.spacing_m ? timing_.thinning * *timing_.spacing_m : sailed);
  }
  return !block.empty();
}

double PingWalker::progress() const { return total_ > 0 ? std::min(1.0, at_ / total_) : 1.0; }

PingFigures PingWalker::figures() const {
  PingFigures result = figures_;
  const auto n = static_cast<double>(std::max<std::uint64_t>(1, figures_.intervals));
  result.mean_spacing_m = sum_of_spacings_ / n;
  return result;
}

}  // namespace swathplan
