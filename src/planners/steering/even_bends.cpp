#include "planners/steering/even_bends.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <vector>

#include "coverage/route/bends.h"
#include "mesh/base/angle.h"
#include "mesh/plane/segments.h"
#include "planners/steering/line_poses.h"

namespace swathplan {
namespace {

/// A chord shorter than this share of a curve's chord is a sliver. The second share is tried where
/// the first one does not widen the bend.
constexpr double kSlivers[] = {0.4, 0.8};
/// Two chords of one curve meet at no more than this many steps of kCurveStepDeg. A larger change
/// of course is a corner.
constexpr double kCornerSteps = 2.0;
/// Chords on either side of a tight bend that may be evened out with it.
constexpr std::size_t kAround = 24;
/// Moves around one tight bend before it is given up.
constexpr int kMostMoves = 600;

/// Waypoints that stand at one place.
struct Place {
  Vec2 position;
  std::size_t first, last;
};

/// Moves the places of a route until no bend is tight, and marks the bends that stay tight.
class BendWidener {
 public:
  BendWidener(Route& route, double radius, const Connector& connector)
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

  std::size_t widened_or_marked() {
    std::size_t marked = 0;
    bool moved = false;
    for (std::size_t k = 1; k + 1 < places_.size(); ++k) {
      if (!tight(k)) continue;
      if (widened(k)) {
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
  [[nodiscard]] CourseChange bend(std::size_t k) const {
    return course_change(places_[k - 1].position, places_[k].position, places_[k + 1].position);
  }
  [[nodiscard]] bool marked(std::size_t k) const {
    return !route_.waypoints[places_[k].last].feasible ||
           !route_.waypoints[places_[k - 1].last].feasible;
  }
  [[nodiscard]] bool tight(std::size_t k) const {
    return bend_radius_m(bend(k), radius_) < (1.0 - kRadiusDust) * radius_ && !marked(k);
  }

  /// Evens the chords around tight bend k. False: the bend stayed tight, and no place moved. The
  /// outermost places that are looked at never move, so that no bend beyond them changes.
  [[nodiscard]] bool widened(std::size_t k) {
    return std::any_of(std::begin(kSlivers), std::end(kSlivers),
                       [&](double sliver) { return widened(k, sliver * chord_); });
  }

  [[nodiscard]] bool widened(std::size_t k, double sliver_m) {
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
      const double radius = bend_radius_m(bend(k), radius_);
      if (radius < least) {
        least = radius;
        found = k;
      }
    }
    return found;
  }

  /// Makes bend k wider by one move and returns the place that moved. Only places after `from` and
  /// before the last one ahead of `to` may move. Empty: no move was possible.
  [[nodiscard]] std::optional<std::size_t> eased(std::size_t k, std::size_t from, std::size_t to,
                                                 double sliver_m) {
    const CourseChange b = bend(k);
    if (std::abs(b.angle_rad) > kCornerSteps * Angle::degrees(kCurveStepDeg).rad())
      return std::nullopt;
    if (std::min(b.before_m, b.after_m) < sliver_m) {
      const std::size_t first = b.before_m < b.after_m ? k - 1 : k;
      const bool free = first > from && first + 2 < to;
      return free && merged(first) ? std::optional(first) : std::nullopt;
    }
    const bool free = k > from && k + 1 < to;
    const bool chords = std::max(b.before_m, b.after_m) < LinePoses::kChordM;
    return free && chords && centred(k) ? std::optional(k) : std::nullopt;
  }

  /// Merges the two ends of the sliver after place k. The later one's waypoints stay.
  [[nodiscard]] bool merged(std::size_t k) {
    const Vec2 middle = 0.5 * (places_[k].position + places_[k + 1].position);
    if (!connector_.in_water({places_[k - 1].position, middle, places_[k + 2].position})) {
      return false;
    }
    places_[k + 1].position = middle;
    places_.erase(places_.begin() + static_cast<std::ptrdiff_t>(k));
    return true;
  }

  /// Moves place k along the circle through it and its neighbours, to half-way between them.
  [[nodiscard]] bool centred(std::size_t k) {
    const Vec2& a = places_[k - 1].position;
    const Vec2& c = places_[k + 1].position;
    const Vec2 chord = c - a;
    const Vec2 in = places_[k].position - a;
    const Vec2 out = c - places_[k].position;
    const double turn = turn_angle(in, out);
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
  return BendWidener(route, radius_m, connector).widened_or_marked();
}

}  // namespace swathplan
