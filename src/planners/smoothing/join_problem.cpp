#include <algorithm>
#include <cmath>

#include "planners/smoothing/join_problem_internal.h"

namespace swathplan {
namespace {

/// Points at either end that the straight or the line there holds: one outside, two of the bend.
constexpr std::size_t kHeld = 3;
/// No point moves farther than this, radii.
constexpr double kReach = 1.0;
/// A bend is spread over about this many radii. Beyond them the curve follows the given one.
constexpr double kSpread = 2.0;
/// Steps may shrink and grow by this share.
constexpr double kUneven = 0.06;
/// The spline bends a little tighter between its points than at them. This is the reserve for that,
/// and what each round adds that was too tight.
constexpr double kReserve = 0.03;
/// A point keeps this share of its distance to the water's edge ...
constexpr double kEdgeShare = 0.1;
/// ... and this many radii, if it had at least twice as much.
constexpr double kMargin = 0.02;
constexpr int kMostIterations = 50;

/// The cubic spline through points at even steps, with these slopes (a step) at its ends, in
/// `parts` chords between two of them.
std::vector<Vec2> splined(const std::vector<Vec2>& p, const Vec2& slope_from, const Vec2& slope_to,
                          int parts) {
  // Second derivatives: m[i - 1] + 4 m[i] + m[i + 1] = 6 (p[i - 1] - 2 p[i] + p[i + 1]).
  const std::size_t n = p.size();
  std::vector<double> upper(n, 0.5);
  std::vector<Vec2> m(n, 3.0 * (p[1] - p[0] - slope_from));
  for (std::size_t i = 1; i < n; ++i) {
    const bool last = i + 1 == n;
    const double pivot = (last ? 2.0 : 4.0) - upper[i - 1];
    const Vec2 ahead = last ? slope_to : Vec2(p[i + 1] - p[i]);
    upper[i] = 1.0 / pivot;
    m[i] = (6.0 * (ahead - (p[i] - p[i - 1])) - m[i - 1]) / pivot;
  }
  for (std::size_t i = n - 1; i-- > 0;) m[i] -= upper[i] * m[i + 1];
  std::vector<Vec2> result{p[0]};
  for (std::size_t i = 0; i + 1 < n; ++i) {
    for (int k = 1; k < parts; ++k) {
      const double t = static_cast<double>(k) / parts;
      const double s = 1.0 - t;
      result.emplace_back(s * p[i] + t * p[i + 1] +
                          ((s * s * s - s) * m[i] + (t * t * t - t) * m[i + 1]) / 6.0);
    }
    result.push_back(p[i + 1]);
  }
  return result;
}

}  // namespace

JoinProblem::JoinProblem(const Pose& from, const Pose& to, const Samples& s, double radius_m,
                         const AreaQuery& water)
    : step_(s.step),
      radius_(radius_m / s.step),
      water_(water),
      origin_(from.position),
      course_from_(from.course),
      course_to_(to.course),
      reserve_(kReserve),
      margin_(kMargin) {
  given_.push_back(from.position - step_ * from.course);
  given_.insert(given_.end(), s.points.begin(), s.points.end());
  given_.push_back(to.position + step_ * to.course);
  given_[2] = from.position + step_ * from.course;
  given_[given_.size() - 3] = to.position - step_ * to.course;
  now_ = given_;
}

bool JoinProblem::held(std::size_t i) const { return i < kHeld || i + kHeld >= now_.size(); }

PathProblem JoinProblem::stated() const {
  PathProblem problem;
  for (std::size_t i = 0; i < now_.size(); ++i) {
    const Vec2 reach = Vec2::Constant(held(i) ? 0.0 : kReach * radius_);
    problem.start.push_back(scaled(now_[i]));
    problem.low.push_back(scaled(given_[i]) - reach);
    problem.high.push_back(scaled(given_[i]) + reach);
    if (!held(i)) add_edge(problem, i);
  }
  add_terms(problem);
  add_shape(problem);
  return problem;
}

/// The integrals of (R^2 x change of curvature)^2 and of (deviation / R)^2 over the length in
/// radii.
void JoinProblem::add_terms(PathProblem& problem) const {
  const double change = std::pow(radius_, 3);
  const double deviation = std::pow(radius_, -3) * std::pow(kSpread, -6);
  for (std::size_t i = 0; i < now_.size(); ++i) {
    for (const int axis : {0, 1}) {
      const int k = 2 * static_cast<int>(i) + axis;
      if (i + 3 < now_.size()) {
        problem.terms.push_back(
            {{{k, -1.0}, {k + 2, 3.0}, {k + 4, -3.0}, {k + 6, 1.0}}, 0.0, change});
      }
      if (!held(i)) problem.terms.push_back({{{k, 1.0}}, scaled(given_[i])[axis], deviation});
    }
  }
}

void JoinProblem::add_shape(PathProblem& problem) const {
  constexpr double kLow = (1.0 - kUneven) * (1.0 - kUneven);
  constexpr double kHigh = (1.0 + kUneven) * (1.0 + kUneven);
  for (std::size_t i = 0; i + 1 < now_.size(); ++i) {
    const int k = static_cast<int>(i);
    if (!held(i) || !held(i + 1)) {
      problem.norms.push_back({{{k, -1.0}, {k + 1, 1.0}}, kLow, kHigh});
    }
    if (i == 0 || (held(i - 1) && held(i) && held(i + 1))) continue;
    // |bend| <= step^2 / R as a share of that, so that Ipopt's tolerance is a share of the radius.
    const double step = 0.5 * (now_[i + 1] - now_[i - 1]).norm() / step_;
    const double share = radius_ * (1.0 + reserve_) / (step * step);
    problem.norms.push_back({{{k - 1, share}, {k, -2.0 * share}, {k + 1, share}}, 0.0, 1.0});
  }
}

/// Keeps the point on its side of the nearest edge of the water. A point on the edge itself stays
/// there, since it does not tell on which side the water lies.
void JoinProblem::add_edge(PathProblem& problem, std::size_t i) const {
  const Vec2 edge = water_.nearest_on_outline(now_[i]);
  const double distance = (edge - now_[i]).norm() / step_;
  if (distance > 2.0 * kReach * radius_) return;
  if (distance * step_ < AreaQuery::kOnOutline) {
    problem.low[i] = problem.high[i] = problem.start[i];
    return;
  }
  const double side = water_.contains(now_[i]) ? 1.0 : -1.0;
  const Vec2 out = side * (scaled(edge) - scaled(now_[i])) / distance;
  double margin = margin_ * radius_;
  if (!off_) margin = std::max(kEdgeShare * distance, std::min(0.5 * distance, margin));
  problem.half_planes.push_back({static_cast<int>(i), out, out.dot(scaled(edge)) - margin});
}

PathSolution JoinProblem::solve_round() {
  PathSolution found = solved_by_ipopt(stated(), kMostIterations);
  if (!found.good) return found;
  for (std::size_t i = 0; i < now_.size(); ++i) now_[i] = origin_ + step_ * found.points[i];
  // Set exactly: Ipopt scales its points and scales them back.
  for (const std::size_t i : {std::size_t{1}, now_.size() - 2}) now_[i] = given_[i];
  return found;
}

void JoinProblem::widen() { reserve_ += kReserve; }

void JoinProblem::keep_off() {
  margin_ *= 2.0;
  off_ = true;
}

std::vector<Vec2> JoinProblem::curve(double chord_m) const {
  const auto parts = static_cast<int>(std::ceil((1.0 + kUneven) * step_ / chord_m));
  return splined({now_.begin() + 1, now_.end() - 1}, step_ * course_from_, step_ * course_to_,
                 parts);
}

}  // namespace swathplan
