#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "mesh/plane/area_query.h"
#include "planners/rows/line_order.h"

namespace swathplan {
namespace {

/// Cells of the raster for ways. Ways are then a few per cent off, and take milliseconds.
constexpr double kCells = 1.5e4;
constexpr double kFinest = 1.0;
constexpr float kFar = std::numeric_limits<float>::infinity();

}  // namespace

/// Ways on the raster. All distances from a cell are computed at once and kept.
struct JoinCost::Impl {
  AreaQuery water;
  double radius;
  double cell = 1.0;
  Vec2 origin = Vec2::Zero();
  std::int64_t columns = 0, rows = 0;
  std::vector<char> free;
  mutable std::map<std::int64_t, std::vector<float>> from;

  Impl(const Area& area, double r) : water(area), radius(r) {
    const Box2 box = extent(area);
    const Vec2 size = box.size();
    cell = std::max(kFinest, std::sqrt(size.x() * size.y() / kCells));
    origin = box.min;
    columns = static_cast<std::int64_t>(std::ceil(size.x() / cell)) + 1;
    rows = static_cast<std::int64_t>(std::ceil(size.y() / cell)) + 1;
    free.assign(static_cast<std::size_t>(columns * rows), 0);
    for (std::int64_t i = 0; i < columns * rows; ++i) {
      free[static_cast<std::size_t>(i)] = water.contains(centre(i)) ? 1 : 0;
    }
  }

  [[nodiscard]] Vec2 centre(std::int64_t i) const {
    const std::int64_t row = i / columns;
    return origin +
           cell * Vec2(static_cast<double>(i % columns) + 0.5, static_cast<double>(row) + 0.5);
  }
  [[nodiscard]] std::int64_t cell_of(const Vec2& p) const;
  [[nodiscard]] const std::vector<float>& distances(std::int64_t cell_from) const;
};

/// The nearest free cell within two cells, else -1.
std::int64_t JoinCost::Impl::cell_of(const Vec2& p) const {
  const Vec2 at = (p - origin) / cell;
  const auto c0 = static_cast<std::int64_t>(std::floor(at.x()));
  const auto r0 = static_cast<std::int64_t>(std::floor(at.y()));
  std::int64_t found = -1;
  double best = std::numeric_limits<double>::infinity();
  for (std::int64_t r = std::max<std::int64_t>(0, r0 - 2); r <= std::min(rows - 1, r0 + 2); ++r) {
    for (std::int64_t c = std::max<std::int64_t>(0, c0 - 2); c <= std::min(columns - 1, c0 + 2);
         ++c) {
      const std::int64_t i = r * columns + c;
      const double distance = (centre(i) - p).squaredNorm();
      if (free[static_cast<std::size_t>(i)] != 0 && distance < best) {
        best = distance;
        found = i;
      }
    }
  }
  return found;
}

/// Dijkstra over the eight neighbours. Their ways are a few per cent too long, which is exact
/// enough to put lines in an order.
const std::vector<float>& JoinCost::Impl::distances(std::int64_t cell_from) const {
  auto [it, fresh] = from.try_emplace(cell_from);
  std::vector<float>& d = it->second;
  if (!fresh) return d;
  d.assign(free.size(), kFar);
  // Steps are 1 or sqrt(2) cells long, so a queue of buckets by distance is enough.
  std::vector<std::vector<std::int64_t>> buckets(1, {cell_from});
  d[static_cast<std::size_t>(cell_from)] = 0.0F;
  const float straight = static_cast<float>(cell);
  const float diagonal = static_cast<float>(cell * std::numbers::sqrt2);
  for (std::size_t b = 0; b < buckets.size(); ++b) {
    for (std::size_t k = 0; k < buckets[b].size(); ++k) {
      const std::int64_t i = buckets[b][k];
      const float here = d[static_cast<std::size_t>(i)];
      if (static_cast<std::size_t>(here / straight) != b) continue;
      for (std::int64_t dr = -1; dr <= 1; ++dr) {
        for (std::int64_t dc = -1; dc <= 1; ++dc) {
          const std::int64_t c = i % columns + dc;
          const std::int64_t r = i / columns + dr;
          if (c < 0 || r < 0 || c >= columns || r >= rows) continue;
          const std::int64_t n = r * columns + c;
          const float there = here + (dr != 0 && dc != 0 ? diagonal : straight);
          if (free[static_cast<std::size_t>(n)] == 0 || there >= d[static_cast<std::size_t>(n)]) {
            continue;
          }
          d[static_cast<std::size_t>(n)] = there;
          const auto bucket = static_cast<std::size_t>(there / straight);
          if (buckets.size() <= bucket) buckets.resize(bucket + 1);
          buckets[bucket].push_back(n);
        }
      }
    }
  }
  return d;
}

JoinCost::JoinCost(const Area& water, double turn_radius_m)
    : impl_(std::make_unique<Impl>(water, turn_radius_m)) {}
JoinCost::~JoinCost() = default;
JoinCost::JoinCost(JoinCost&&) noexcept = default;
JoinCost& JoinCost::operator=(JoinCost&&) noexcept = default;

double JoinCost::way(const Vec2& a, const Vec2& b) const {
  const double straight = (b - a).norm();
  if (impl_->water.inside_length(a, b) >= straight - 0.5) return straight;
  const std::int64_t from = impl_->cell_of(a);
  const std::int64_t to = impl_->cell_of(b);
  if (from < 0 || to < 0) return straight + kNoWay;
  const float found = impl_->distances(from)[static_cast<std::size_t>(to)];
  return found < kFar ? std::max(straight, static_cast<double>(found)) : straight + kNoWay;
}

double JoinCost::turning(const Vec2& a, const Vec2& course_a, const Vec2& b, const Vec2& course_b,
                         double way_m) const {
  const Vec2 apart = b - a;
  const double distance = apart.norm();
  const auto between = [](const Vec2& u, const Vec2& v) {
    return std::acos(std::clamp(u.dot(v), -1.0, 1.0));
  };
  const double r = impl_->radius;
  if (distance < 1e-6) return 2.0 * r * between(course_a, course_b);
  const Vec2 chord = apart / distance;
  // Two arcs and their tangent are longer than the chord by about this. Ends nearer than the
  // diameter need a loop as well.
  const double angles = between(course_a, chord) + between(chord, course_b);
  const double missing = std::max(0.0, 2.0 * r - way_m) * angles / std::numbers::pi;
  return 0.36 * r * angles + 1.5 * missing;
}

double JoinCost::operator()(const Vec2& a, const Vec2& course_a, const Vec2& b,
                            const Vec2& course_b) const {
  const double metres = way(a, b);
  return metres + turning(a, course_a, b, course_b, metres);
}

}  // namespace swathplan
