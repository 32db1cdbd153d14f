#include "planners/steering/even_bends.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <vector>

#include "mesh/base/angle.h"
#include "planners/steering/line_poses.h"

namespace swathplan {
namespace {

/// Shorter than this share of a curve's chord, a chord is a sliver: first the one, and where that
/// does not do, the other.
constexpr double kSlivers[] = {0.4, 0.8};
/// A chord of a curve bends by no more than this many steps of a curve; more is a corner.
constexpr double kCornerSteps = 2.0;
/// Chords on either side of a tight bend that may be evened out with it.
constexpr std::size_t kAround = 24;
/// Moves about one tight bend before it is given up.
constexpr int kMostMoves = 600;

/// Waypoints at one place.
struct Place {
  Vec2 position;
  std::size_t first, last;
};

class Evener {
 public:
  Evener(Route& route, double radius, const Connector& connector)
      : route_(route),
        connector_(connector),
        radius_(radius),
        chord_(std::min(kCurveStepM, radius * Angle::degrees(kCurveStepDeg).rad())) {
    for (std::size_t i = 0; i < route.waypoints.size(); ++i) {
      const Vec2& p = route.waypoints[i].position;
      if (!places_.empty() && (p - places_.back().position).norm() <= LinePoses::kCoincidentM) {
        places_.back().last = i;
      } else {
        places_.push_back({p, i, i});
      }
    }
  }

  std::size_t evened() {
    std::size_t marked = 0;
    bool moved = false;
    for (std::size_t k = 1; k + 1 < places_.size(); ++k) {
      if (!tight(k)) continue;
      if (settled(k)) {
        moved = true;
        continue;
      }
      route_.waypoints[places_[k].last].feasible = false;
      ++marked;
    }
    if (moved) write();
    return marked;
  }

 private:
  struct Bend {
    double before, after, angle;
  };

  [[nodiscard]] Bend bend(std::size_t k) const {
    const Vec2 in = places_[k].position - places_[k - 1].position;
    const Vec2 out = places_[k + 1].position - places_[k].position;
    return {in.norm(), out.norm(),
            std::abs(std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out)))};
  }
  [[nodiscard]] bool marked(std::size_t k) const {
    return !route_.waypoints[places_[k].last].feasible ||
           !route_.waypoints[places_[k - 1].last].feasible;
  }
  [[nodiscard]] bool tight(std::size_t k) const {
    const Bend b = bend(k);
    return 0.5 * std::min(b.before, b.after) <
               (1.0 - kRadiusDust) * radius_ * std::tan(0.5 * b.angle) &&
           !marked(k);
  }

  /// Evens the chords about tight bend k; if that does not do, all is as it was. The outermost
  /// places looked at stay, so that no bend beyond them changes.
  [[nodiscard]] bool settled(std::size_t k) {
    return std::any_of(std::begin(kSlivers), std::end(kSlivers),
                       [&](double sliver) { return settled(k, sliver * chord_); });
  }

  [[nodiscard]] bool settled(std::size_t k, double sliver_m) {
    const std::size_t from = k > kAround ? k - kAround : 0;
    std::size_t to = std::min(places_.size(), k + kAround + 1);
    const std::vector<Place> before(places_.begin() + static_cast<std::ptrdiff_t>(from),
                                    places_.begin() + static_cast<std::ptrdiff_t>(to));
    std::size_t low = k, high = k;  // bends that moves so far have changed
    for (int move = 0; move < kMostMoves; ++move) {
      const auto next = tightest(low, high + 1);
      if (!next) return true;
      const std::size_t count = places_.size();
      const auto moved = eased(*next, from, to, sliver_m);
      if (!moved) break;
      if (places_.size() < count) {
        --to;
        high -= high > *moved ? 1 : 0;
      }
      low = std::min(low, *moved - 1);
      high = std::max(high, *moved + 1);
    }
    places_.erase(places_.begin() + static_cast<std::ptrdiff_t>(from),
                  places_.begin() + static_cast<std::ptrdiff_t>(to));
    places_.insert(places_.begin() + static_cast<std::ptrdiff_t>(from), before.begin(),
                   before.end());
    return false;
  }

  [[nodiscard]] std::optional<std::size_t> tightest(std::size_t from, std::size_t to) const {
    std::optional<std::size_t> found;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = std::max<std::size_t>(from, 1); k < std::min(to, places_.size() - 1);
         ++k) {
      if (!tight(k)) continue;
      const Bend b = bend(k);
      const double radius = std::min(b.before, b.after) / std::tan(0.5 * b.angle);
      if (radius < least) {
        least = radius;
        found = k;
      }
    }
    return found;
  }

  /// One move that makes bend k wider, and the place that moved; only places between `from` and the
  /// last before `to` may.
  [[nodiscard]] std::optional<std::size_t> eased(std::size_t k, std::size_t from, std::size_t to,
                                                 double sliver_m) {
    const Bend b = bend(k);
    if (b.angle > kCornerSteps * Angle::degrees(kCurveStepDeg).rad()) return std::nullopt;
    if (std::min(b.before, b.after) < sliver_m) {
      const std::size_t first = b.before < b.after ? k - 1 : k;
      const bool free = first > from && first + 2 < to;
      return free && merged(first) ? std::optional(first) : std::nullopt;
    }
    const bool free = k > from && k + 1 < to;
    const bool chords = std::max(b.before, b.after) < LinePoses::kChordM;
    return free && chords && centred(k) ? std::optional(k) : std::nullopt;
  }

  /// The ends of the sliver after place k become one. What holds from the later one on stays.
  [[nodiscard]] bool merged(std::size_t k) {
    const Vec2 middle = 0.5 * (places_[k].position + places_[k + 1].position);
    if (!connector_.in_water({places_[k - 1].position, middle, places_[k + 2].position})) {
      return false;
    }
    places_[k + 1].position = middle;
    places_.erase(places_.begin() + static_cast<std::ptrdiff_t>(k));
    return true;
  }

  /// Place k moves along the circle through it and its neighbours to half-way between them.
  [[nodiscard]] bool centred(std::size_t k) {
    const Vec2& a = places_[k - 1].position;
    const Vec2& c = places_[k + 1].position;
    const Vec2 chord = c - a;
    const Vec2 in = places_[k].position - a;
    const Vec2 out = c - places_[k].position;
    const double turn = std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out));
    const Vec2 starboard(chord.y(), -chord.x());
    const Vec2 middle = 0.5 * (a + c) + 0.5 * std::tan(0.5 * turn) * starboard;
    if (!connector_.in_water({a, middle, c})) return false;
    places_[k].position = middle;
    return true;
  }

  void write() {
    std::vector<Waypoint> waypoints;
    waypoints.reserve(route_.waypoints.size());
    for (const Place& place : places_) {
      for (std::size_t i = place.first; i <= place.last; ++i) {
        waypoints.push_back(route_.waypoints[i]);
        waypoints.back().position = place.position;
      }
    }
    route_.waypoints = std::move(waypoints);
  }

  Route& route_;
  const Connector& connector_;
  double radius_, chord_;
  std::vector<Place> places_;
};

}  // namespace

std::size_t even_bends(Route& route, double radius_m, const Connector& connector) {
  return Evener(route, radius_m, connector).evened();
}

}  // namespace swathplan
