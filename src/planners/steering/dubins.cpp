#include "planners/steering/dubins.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace swathplan {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
/// A turn this near to a full circle is no turn. It is a turn of 0 that rounding took below 0.
constexpr double kFullTurn = 1e-9;

/// Turning circles that overlap by less than this (radii squared) only touch. Then one turn passes
/// into the other with no straight between.
constexpr double kTouching = 1e-9;

/// Turning circles whose centres are nearer than this (radii) are the same circle.
constexpr double kOneCircle = 1e-7;

double turn_mod(double angle) {
  const double a = angle - kTwoPi * std::floor(angle / kTwoPi);
  return a > kTwoPi - kFullTurn ? 0.0 : a;
}

double heading(const Pose& pose) { return std::atan2(pose.course.y(), pose.course.x()); }

Pose advanced(const Pose& from, double radius, int turn, double way) {
  if (turn == 0) return {from.position + way * from.course, from.course};
  const double angle = turn * way / radius;
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const Vec2& u = from.course;
  const Vec2 course(c * u.x() - s * u.y(), s * u.x() + c * u.y());
  const Vec2 left(-u.y(), u.x());
  const Vec2 left_after(-course.y(), course.x());
  return {from.position + turn * radius * (left - left_after), course};
}

/// Turns t, q and the middle piece p of a word, all in radii.
struct Word {
  std::array<int, 3> turn;
  double t, p, q;
};

/// The six words for two poses at a distance d, in radii. Their courses make the angles a and b
/// with the line between them.
class Words {
 public:
  Words(double distance, double alpha, double beta)
      : d(distance),
        a(alpha),
        b(beta),
        sa(std::sin(alpha)),
        sb(std::sin(beta)),
        ca(std::cos(alpha)),
        cb(std::cos(beta)),
        cab(std::cos(alpha - beta)) {}

  [[nodiscard]] std::vector<Word> all() const {
    std::vector<Word> words;
    for (const int side : {1, -1}) {
      add(words, same_side(side));
      add(words, changing_side(side));
      add(words, three_turns(side));
    }
    return words;
  }

 private:
  double d, a, b, sa, sb, ca, cb, cab;

  static void add(std::vector<Word>& words, const std::optional<Word>& word) {
    if (word) words.push_back(*word);
  }
  [[nodiscard]] std::optional<Word> same_side(int side) const {
    const double square = 2.0 + d * d - 2.0 * cab + 2.0 * d * side * (sa - sb);
    const double p = std::sqrt(std::max(0.0, square));
    // Both turning circles are the same one, so the straight has no direction.
    if (p < kOneCircle) return Word{{side, 0, side}, turn_mod(side * (b - a)), 0.0, 0.0};
    const double w = std::atan2(side * (cb - ca), d + side * (sa - sb));
    return Word{{side, 0, side}, turn_mod(side * (w - a)), p, turn_mod(side * (b - w))};
  }
  [[nodiscard]] std::optional<Word> changing_side(int side) const {
    const double square = d * d - 2.0 + 2.0 * cab + 2.0 * d * side * (sa + sb);
    if (square < -kTouching) return std::nullopt;
    const double p = std::sqrt(std::max(0.0, square));
    const double w =
        std::atan2(-side * (ca + cb), d + side * (sa + sb)) - std::atan2(-2.0 * side, p);
    return Word{{side, 0, -side}, turn_mod(side * (w - a)), p, turn_mod(side * (w - b))};
  }
  [[nodiscard]] std::optional<Word> three_turns(int side) const {
    const double cosine = (6.0 - d * d + 2.0 * cab - 2.0 * d * side * (sa - sb)) / 8.0;
    if (std::abs(cosine) > 1.0) return std::nullopt;
    const double p = turn_mod(kTwoPi - std::acos(cosine));
    const double w = std::atan2(side * (cb - ca), d + side * (sa - sb));
    const double t = turn_mod(side * (w - a) + 0.5 * p);
    return Word{{side, -side, side}, t, p, turn_mod(side * (b - a) - t + p)};
  }
};

}  // namespace

DubinsPath::DubinsPath(const Pose& from, double radius_m, const std::array<int, 3>& turn,
                       const std::array<double, 3>& piece_m)
    : from_(from), radius_(radius_m), turn_(turn), piece_(piece_m) {}

Pose DubinsPath::at(double along_m) const {
  Pose pose = from_;
  for (std::size_t k = 0; k < 3 && along_m > 0.0; ++k) {
    pose = advanced(pose, radius_, turn_[k], std::min(along_m, piece_[k]));
    along_m -= piece_[k];
  }
  return pose;
}

std::vector<Vec2> DubinsPath::points(double step_m) const {
  const double length = length_m();
  const auto parts = static_cast<int>(std::max(1.0, std::ceil(length / step_m)));
  std::vector<Vec2> result;
  result.reserve(static_cast<std::size_t>(parts) + 1);
  for (int k = 0; k <= parts; ++k) result.push_back(at(length * k / parts).position);
  return result;
}

double DubinsPath::straight_m() const {
  double metres = 0.0;
  for (std::size_t k = 0; k < 3; ++k) metres += turn_[k] == 0 ? piece_[k] : 0.0;
  return metres;
}

std::vector<DubinsPath> dubins_paths(const Pose& from, const Pose& to, double radius_m) {
  const Vec2 way = to.position - from.position;
  const double bearing = way.squaredNorm() > 0.0 ? std::atan2(way.y(), way.x()) : heading(from);
  const Words words(way.norm() / radius_m, heading(from) - bearing, heading(to) - bearing);
  std::vector<DubinsPath> paths;
  for (const Word& w : words.all()) {
    paths.emplace_back(from, radius_m, w.turn,
                       std::array<double, 3>{w.t * radius_m, w.p * radius_m, w.q * radius_m});
  }
  std::stable_sort(paths.begin(), paths.end(), [](const DubinsPath& a, const DubinsPath& b) {
    return a.length_m() < b.length_m();
  });
  return paths;
}

double dubins_length_m(const Pose& from, const Pose& to, double radius_m) {
  return dubins_paths(from, to, radius_m).front().length_m();
}

}  // namespace swathplan
