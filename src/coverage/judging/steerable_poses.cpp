#include "coverage/judging/steerable_poses.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/base/parallel.h"
#include "mesh/plane/area_query.h"
#include "mesh/plane/box.h"

namespace swathplan {

namespace {

constexpr double kLatticeOfRadius = 0.1;
constexpr double kFinestLatticeM = 0.25;
constexpr double kCourseStep = 2.0 * std::numbers::pi / SteerablePoses::kCourses;

Vec2 course_vector(double course) {
  const double azimuth = kCourseStep * course;
  return {std::sin(azimuth), std::cos(azimuth)};
}

}  // namespace

SteerablePoses::SteerablePoses(const Area& safe_water, double turn_radius_m) {
  if (safe_water.empty()) return;
  const Box2 box = extent(safe_water);
  const Vec2 size = box.size();
  cell_ = std::max({kFinestLatticeM, kLatticeOfRadius * turn_radius_m,
                    std::sqrt(size.x() * size.y() / kMostPlaces)});
  // A step must be longer than the lattice rounds.
  step_ = std::max(turn_radius_m * kCourseStep, 2.0 * cell_);
  origin_ = box.min - Vec2::Constant(cell_);
  columns_ = static_cast<std::size_t>(size.x() / cell_) + 3;
  rows_ = static_cast<std::size_t>(size.y() / cell_) + 3;
  water_.assign(columns_ * rows_, 0);
  const AreaQuery water(safe_water);
  for_each_index(std::size_t{0}, rows_, [&](std::size_t row) {
    for (std::size_t c = 0; c < columns_; ++c) {
      const Vec2 p =
          origin_ + cell_ * Vec2(static_cast<double>(c) + 0.5, static_cast<double>(row) + 0.5);
      water_[row * columns_ + c] = water.contains(p) ? 1 : 0;
    }
  });
  ways_.assign(water_.size(), 0);
  for (std::size_t i = 0; i < ways_.size(); ++i) ways_[i] = water_[i] != 0 ? 0xFFFFU : 0U;
  leave_dead_ends();
}

std::size_t SteerablePoses::place(const Vec2& p) const {
  const Vec2 at = (p - origin_) / cell_;
  const bool inside = at.x() >= 0.0 && at.y() >= 0.0 && at.x() < static_cast<double>(columns_) &&
                      at.y() < static_cast<double>(rows_);
  if (!inside) return ways_.size();
  return static_cast<std::size_t>(at.y()) * columns_ + static_cast<std::size_t>(at.x());
}

// Whether one of three moves leads to a pose that goes on.
bool SteerablePoses::goes_on(std::size_t from, int course) const {
  const std::size_t row = from / columns_;
  const Vec2 p = origin_ + cell_ * Vec2(static_cast<double>(from % columns_) + 0.5,
                                        static_cast<double>(row) + 0.5);
  constexpr int kTurns[] = {0, 1, -1};
  return std::any_of(std::begin(kTurns), std::end(kTurns), [&](int turn) {
    const Vec2 way = step_ * course_vector(course + 0.5 * turn);
    const std::size_t half = place(p + 0.5 * way);
    if (half == ways_.size() || water_[half] == 0) return false;
    const std::size_t to = place(p + way);
    const int then = (course + turn + kCourses) % kCourses;
    return to != ways_.size() && (ways_[to] >> then & 1U) != 0;
  });
}

// Takes away poses that no move leads on from, until all that are left go on. Only places near one
// that lost a pose are looked at again.
void SteerablePoses::leave_dead_ends() {
  const auto reach = static_cast<std::ptrdiff_t>(step_ / cell_) + 1;
  const auto rows = static_cast<std::ptrdiff_t>(rows_);
  const auto columns = static_cast<std::ptrdiff_t>(columns_);
  std::vector<std::uint8_t> look = water_;
  for (bool any = true; any;) {
    std::vector<std::uint16_t> next = ways_;
    std::vector<std::uint8_t> changed(rows_, 0);
    for_each_index(std::size_t{0}, rows_, [&](std::size_t row) {
      for (std::size_t i = row * columns_, end = i + columns_; i < end; ++i) {
        if (look[i] == 0 || ways_[i] == 0) continue;
        for (int course = 0; course < kCourses; ++course) {
          const auto bit = static_cast<std::uint16_t>(1U << course);
          if ((next[i] & bit) == 0 || goes_on(i, course)) continue;
          next[i] = static_cast<std::uint16_t>(next[i] & ~bit);
          changed[row] = 1;
        }
      }
    });
    any = std::find(changed.begin(), changed.end(), 1) != changed.end();
    std::fill(look.begin(), look.end(), std::uint8_t{0});
    for (std::ptrdiff_t r = 0; any && r < rows; ++r) {
      if (changed[static_cast<std::size_t>(r)] == 0) continue;
      for (std::ptrdiff_t c = 0; c < columns; ++c) {
        const auto i = static_cast<std::size_t>(r * columns + c);
        if (next[i] == ways_[i]) continue;
        for (std::ptrdiff_t y = std::max<std::ptrdiff_t>(0, r - reach);
             y <= std::min(rows - 1, r + reach); ++y) {
          const auto from = look.begin() + y * columns;
          std::fill(from + std::max<std::ptrdiff_t>(0, c - reach),
                    from + std::min(columns, c + reach + 1), std::uint8_t{1});
        }
      }
    }
    ways_ = std::move(next);
  }
}

bool SteerablePoses::steerable(const Vec2& position, const Vec2& course) const {
  const std::size_t i = place(position);
  if (i == ways_.size()) return false;
  const double azimuth = std::atan2(course.x(), course.y());
  const int k = (static_cast<int>(std::lround(azimuth / kCourseStep)) + kCourses) % kCourses;
  // What can be sailed to is what can be sailed from on the opposite course.
  const int back = (k + kCourses / 2) % kCourses;
  return (ways_[i] >> k & 1U) != 0 && (ways_[i] >> back & 1U) != 0;
}

}  // namespace swathplan
