#include "planners/fronts/eikonal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>

namespace swathplan {
namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();

/// First-order fast marching. A cell is accepted once its value is final.
class FastMarching {
 public:
  FastMarching(const WaterRaster& raster, const std::vector<float>& width)
      : raster_(raster), width_(width), accepted_(raster.size(), 0) {
    front_.u.assign(raster.size(), kFar);
    front_.label.assign(raster.size(), kNoLabel);
  }

  Front run(const std::vector<FrontCell>& from, double farthest) {
    for (const FrontCell& f : from) {
      if (open(f.cell)) offer(f.cell, static_cast<float>(f.value), f.label);
    }
    while (!heap_.empty()) {
      const auto [u, i] = heap_.top();
      heap_.pop();
      if (accepted_[i] != 0 || u > front_.u[i]) continue;
      if (static_cast<double>(u) > farthest) break;
      accepted_[i] = 1;
      for (const std::size_t n : neighbours(i)) {
        if (open(n) && accepted_[n] == 0) update(n);
      }
    }
    return std::move(front_);
  }

 private:
  [[nodiscard]] bool open(std::size_t i) const { return raster_.in_area(i) && width_[i] > 0.0F; }
  [[nodiscard]] std::array<std::size_t, 4> neighbours(std::size_t i) const {
    return {i - raster_.columns(), i - 1, i + 1, i + raster_.columns()};
  }

  void offer(std::size_t i, float u, std::uint32_t label) {
    if (u >= front_.u[i]) return;
    front_.u[i] = u;
    front_.label[i] = label;
    heap_.emplace(u, i);
  }

  [[nodiscard]] std::size_t lower(std::size_t a, std::size_t b) const {
    return accepted(b) < accepted(a) ? b : a;
  }
  [[nodiscard]] float accepted(std::size_t i) const {
    if (accepted_[i] == 0) return kFar;
    return front_.u[i];
  }

  void update(std::size_t i) {
    const auto n = neighbours(i);
    const std::size_t x = lower(n[1], n[2]);
    const std::size_t y = lower(n[0], n[3]);
    const double a = accepted(x);
    const double b = accepted(y);
    const double f = raster_.cell_m() / static_cast<double>(width_[i]);
    const double low = std::min(a, b);
    double u = low + f;
    // The front comes from both directions: (u - a)^2 + (u - b)^2 = f^2.
    if (std::abs(a - b) < f) {
      u = 0.5 * (a + b + std::sqrt(std::max(0.0, 2.0 * f * f - (a - b) * (a - b))));
    }
    offer(i, static_cast<float>(u), front_.label[a <= b ? x : y]);
  }

  const WaterRaster& raster_;
  const std::vector<float>& width_;
  std::vector<char> accepted_;
  Front front_;
  std::priority_queue<std::pair<float, std::size_t>, std::vector<std::pair<float, std::size_t>>,
                      std::greater<>>
      heap_;
};

}  // namespace

Front march(const WaterRaster& raster, const std::vector<float>& width,
            const std::vector<FrontCell>& from, double farthest) {
  return FastMarching(raster, width).run(from, farthest);
}

}  // namespace swathplan
