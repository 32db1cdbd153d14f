#include "planners/nuc/thin_cover.h"

#include <algorithm>
#include <cmath>

#include "mesh/plane/area_query.h"

namespace swathplan {
namespace {

/// Rays that end farther beyond the area than this do not matter, metres.
constexpr double kRim = 4.0 * ThinCover::kSpreadM;
/// A ray finds the seafloor in this many steps. On a slope steeper than the ray it ends off the
/// seafloor.
constexpr int kDescents = 3;

}  // namespace

ThinCover::ThinCover(const DepthQuery& depths, const Area& survey_area, const PlanOptions& options)
    : depths_(depths),
      sonar_(options.sonar),
      pings_(options.pings),
      draft_m_(options.vehicle.draft_m),
      beams_(options.sonar.beams),
      speed_mps_(options.vehicle.speed_mps),
      cell_area_m2_(options.resolution_m * options.resolution_m) {
  const Box2 box = extent(survey_area);
  corner_ = box.min - Vec2::Constant(kRim);
  const Vec2 size = box.size() + Vec2::Constant(2.0 * kRim);
  width_ = static_cast<int>(std::ceil(size.x() / kCellM)) + 1;
  height_ = static_cast<int>(std::ceil(size.y() / kCellM)) + 1;
  const AreaQuery area(survey_area);
  wanted_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      wanted_[static_cast<std::size_t>(index(x, y))] =
          area.contains(corner_ + kCellM * Vec2(x, y)) ? 1 : 0;
    }
  }
  double sum = 0.0;
  for (int k = 0; k * kCellM <= 3.0 * kSpreadM; ++k) {
    const double z = k * kCellM / kSpreadM;
    kernel_.push_back(std::exp(-0.5 * z * z));
    sum += (k == 0 ? 1.0 : 2.0) * kernel_.back();
  }
  for (double& k : kernel_) k /= sum;
}

std::vector<ThinCover::Ray> ThinCover::rays(const Vec2& p, const Vec2& course,
                                            const FanAngles& fan) const {
  const Vec2 port(-course.y(), course.x());
  const auto below = depths_.depth(p);
  const double start = below ? *below : depths_.nearest_depth(p);
  std::vector<Ray> result;
  for (int k = 0; k < kRays; ++k) {
    const double share = (k + 0.5) / kRays;
    const double angle = fan.port.rad() - share * (fan.port.rad() + fan.starboard.rad());
    double depth = start;
    double across = 0.0;
    bool met = true;
    for (int step = 0; step < kDescents && met; ++step) {
      across = std::tan(angle) * std::max(0.0, depth - draft_m_);
      const auto there = depths_.depth(p + across * port);
      met = there.has_value();
      if (met) depth = *there;
    }
    if (met) result.push_back({across, p + across * port});
  }
  return result;
}

std::vector<double> ThinCover::blurred(const std::vector<double>& field) const {
  const auto reach = static_cast<int>(kernel_.size()) - 1;
  std::vector<double> rows(field.size()), result(field.size());
  const auto pass = [&](const std::vector<double>& in, std::vector<double>& out, int dx, int dy) {
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        double sum = 0.0;
        for (int k = -reach; k <= reach; ++k) {
          const int i = x + k * dx;
          const int j = y + k * dy;
          if (i < 0 || j < 0 || i >= width_ || j >= height_) continue;
          sum += kernel_[static_cast<std::size_t>(std::abs(k))] *
                 in[static_cast<std::size_t>(index(i, j))];
        }
        out[static_cast<std::size_t>(index(x, y))] = sum;
      }
    }
  };
  pass(field, rows, 1, 0);
  pass(rows, result, 0, 1);
  return result;
}

ThinCover::Pull ThinCover::pull(const std::vector<Vec2>& points,
                                const std::vector<FanAngles>& fans) const {
  Pull result;
  const std::size_t n = points.size();
  result.down.assign(n, Vec2::Zero());
  if (n < 3) return result;
  const auto cells = wanted_.size();
  std::vector<double> soundings(cells, 0.0);
  std::vector<std::vector<Ray>> all(n);
  std::vector<double> each(n, 0.0);  // soundings a ray stands for
  // The four cells around a place and their bilinear shares.
  const auto around = [&](const Vec2& at, const auto& visit) {
    const Vec2 g = (at - corner_) / kCellM;
    const int x = static_cast<int>(std::floor(g.x()));
    const int y = static_cast<int>(std::floor(g.y()));
    if (x < 0 || y < 0 || x + 1 >= width_ || y + 1 >= height_) return;
    const double fx = g.x() - x;
    const double fy = g.y() - y;
    visit(static_cast<std::size_t>(index(x, y)), fx, fy);
  };
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const Vec2 v = points[i + 1] - points[i - 1];
    if (!(v.norm() > 0.0)) continue;
    all[i] = rays(points[i], v.normalized(), fans[i]);
    const double step =
        0.5 * ((points[i + 1] - points[i]).norm() + (points[i] - points[i - 1]).norm());
    const auto below = depths_.depth(points[i]);
    const double depth = below ? *below : depths_.nearest_depth(points[i]);
    const double spacing = ping_spacing_m(sonar_, pings_, depth - draft_m_,
                                          std::max(fans[i].port, fans[i].starboard), speed_mps_);
    each[i] = step / spacing * beams_ / kRays;
    for (const Ray& ray : all[i]) {
      around(ray.at, [&](std::size_t c, double fx, double fy) {
        const auto w = static_cast<std::size_t>(width_);
        soundings[c] += each[i] * (1 - fx) * (1 - fy);
        soundings[c + 1] += each[i] * fx * (1 - fy);
        soundings[c + w] += each[i] * (1 - fx) * fy;
        soundings[c + w + 1] += each[i] * fx * fy;
      });
    }
  }
  std::vector<double> empty = blurred(soundings);
  const double per_cell = cell_area_m2_ / (kCellM * kCellM);
  for (std::size_t c = 0; c < cells; ++c) {
    empty[c] = wanted_[c] ? std::exp(-empty[c] * per_cell) : 0.0;
    result.empty_m2 += empty[c] * kCellM * kCellM;
  }
  const std::vector<double> potential = blurred(empty);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const Vec2 v = points[i + 1] - points[i - 1];
    if (all[i].empty()) continue;
    const Vec2 u = v.normalized();
    double torque = 0.0;
    for (const Ray& ray : all[i]) {
      Vec2 slope = Vec2::Zero();
      around(ray.at, [&](std::size_t c, double fx, double fy) {
        const auto w = static_cast<std::size_t>(width_);
        const double a = potential[c], b = potential[c + 1], d = potential[c + w],
                     e = potential[c + w + 1];
        slope = Vec2((1 - fy) * (b - a) + fy * (e - d), (1 - fx) * (d - a) + fx * (e - b)) / kCellM;
      });
      const Vec2 force = each[i] * cell_area_m2_ * slope;
      result.down[i] += force;
      torque -= ray.across_m * force.dot(u) / v.norm();
    }
    const Vec2 port(-u.y(), u.x());
    result.down[i + 1] += torque * port;
    result.down[i - 1] -= torque * port;
  }
  return result;
}

}  // namespace swathplan
