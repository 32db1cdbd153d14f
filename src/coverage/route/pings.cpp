#include "coverage/route/pings.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "mesh/base/error.h"
#include "mesh/base/random.h"

namespace swathplan {

namespace {

// Braces draw the numbers from left to right.
std::array<double, 4> normals(std::mt19937_64& random) {
  const std::array<double, 4> u{uniform_above_0(random()), uniform_above_0(random()),
                                uniform_above_0(random()), uniform_above_0(random())};
  const auto [a, b] = normal_pair(u[0], u[1]);
  const auto [c, d] = normal_pair(u[2], u[3]);
  return {a, b, c, d};
}

void check(double spacing_m, const TrackNoise& noise) {
  if (!(spacing_m > 0) || !std::isfinite(spacing_m)) {
    throw UsageError("ping spacing", fmt::format("{} m", spacing_m), "must be greater than 0");
  }
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

PingWalker::PingWalker(const Route& route, double spacing_m, const TrackNoise& noise)
    : route_(&route), spacing_(spacing_m), noise_(noise), random_(noise.seed) {
  check(spacing_m, noise);
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

void PingWalker::step_noise() {
  if (!noise_.any()) return;
  const double keep = std::exp(-spacing_ / noise_.correlation_length_m);
  const double fresh = std::sqrt(1.0 - keep * keep);
  const std::array<double, 4> draw = normals(random_);
  for (std::size_t k = 0; k < 4; ++k) noise_state_[k] = keep * noise_state_[k] + fresh * draw[k];
}

void PingWalker::push(std::vector<Ping>& block) const {
  const Waypoint& from = route_->waypoints[segment_];
  if (!from.fan || !(segment_length_ > 0)) return;
  const Waypoint& to = route_->waypoints[segment_ + 1];
  const Vec2 course = (to.position - from.position) / segment_length_;
  const double along =
      std::clamp(static_cast<double>(index_) * spacing_ - segment_start_, 0.0, segment_length_);
  Ping ping{.position = from.position + along * course,
            .course = course,
            .roll = {},
            .heave_m = 0.0,
            .fan = *from.fan,
            .leg = leg_of_segment_[segment_],
            .log = from.log};
  if (noise_.any()) {
    ping.position += noise_state_[0] * noise_.lateral_sigma_m * Vec2(course.y(), -course.x());
    ping.course = clockwise(course, noise_state_[1] * noise_.heading_sigma.rad());
    ping.roll = noise_.roll_sigma * noise_state_[2];
    ping.heave_m = noise_state_[3] * noise_.heave_sigma_m;
  }
  block.push_back(ping);
}

bool PingWalker::next(std::size_t count, std::vector<Ping>& block) {
  block.clear();
  while (block.size() < count && !leg_of_segment_.empty()) {
    const double s = static_cast<double>(index_) * spacing_;
    if (s > total_ + kPathDust) break;
    while (segment_ + 1 < leg_of_segment_.size() &&
           s >= segment_start_ + segment_length_ - kPathDust) {
      segment_start_ += segment_length_;
      segment_length_ = segment_length(*route_, ++segment_);
    }
    push(block);
    ++index_;
    step_noise();
  }
  return !block.empty();
}

double PingWalker::progress() const {
  return total_ > 0 ? std::min(1.0, static_cast<double>(index_) * spacing_ / total_) : 1.0;
}

}  // namespace swathplan
