#include "planners/fitted/itinerary.h"

#include <algorithm>

#include "planners/fitted/line_workshop.h"

namespace swathplan {

Itinerary::Itinerary(const Route& route, const JoinCost& cost)
    : stretches_(stretches(route)), cost_(cost) {}

Itinerary::Place Itinerary::cheapest(const Vec2& from, const Vec2& to) const {
  // Straight ways are lower bounds of the ways through the water, so they are compared first.
  std::vector<Place> places;
  for (std::size_t k = 0; k <= stretches_.size(); ++k) {
    if (k < stretches_.size() && (stretches_[k].join || goes_on(k))) continue;
    for (const bool backwards : {false, true}) {
      places.push_back({k, backwards, detour(from, to, k, backwards, false)});
    }
  }
  std::stable_sort(places.begin(), places.end(),
                   [](const Place& a, const Place& b) { return a.cost < b.cost; });
  Place best;
  constexpr std::size_t kLook = 8;
  for (std::size_t i = 0; i < std::min(kLook, places.size()); ++i) {
    if (places[i].cost >= best.cost) break;
    places[i].cost = detour(from, to, places[i].before, places[i].backwards, true);
    if (places[i].cost < best.cost) best = places[i];
  }
  return best;
}

void Itinerary::insert(std::vector<Waypoint> points, std::size_t before) {
  if (before > 0 && before <= stretches_.size() && stretches_[before - 1].join) {
    stretches_[before - 1] = {std::move(points), false};
    return;
  }
  stretches_.insert(stretches_.begin() + static_cast<std::ptrdiff_t>(before),
                    {std::move(points), false});
}

std::vector<std::vector<Waypoint>> Itinerary::runs() const {
  std::vector<std::vector<Waypoint>> result;
  bool after_join = false;
  for (const RouteStretch& s : stretches_) {
    if (s.join || after_join) {
      if (s.join && !result.empty()) result.back().pop_back();
      if (result.empty()) result.emplace_back();
      result.back().insert(result.back().end(), s.points.begin(), s.points.end());
    } else if (!result.empty() && result.back().back().position == s.points.front().position) {
      // The next leg of one line.
      result.back().pop_back();
      result.back().insert(result.back().end(), s.points.begin(), s.points.end());
    } else {
      result.push_back(s.points);
    }
    after_join = s.join;
  }
  return result;
}

std::vector<Vec2> Itinerary::give_up_unjoined() {
  const auto unsteered = [](const RouteStretch& s) {
    return s.join && std::any_of(s.points.begin(), s.points.end(),
                                 [](const Waypoint& w) { return !w.feasible; });
  };
  const auto pass_at = [&](std::size_t i) {
    return i < stretches_.size() && stretches_[i].points.front().kind == LegKind::infill;
  };
  std::vector<char> gone(stretches_.size(), 0);
  std::vector<Vec2> middles;
  for (std::size_t i = 0; i < stretches_.size(); ++i) {
    if (!unsteered(stretches_[i])) continue;
    const std::size_t pass = pass_at(i + 1) ? i + 1 : i - 1;  // i == 0: no stretch
    if (!pass_at(pass) || gone[pass] != 0) continue;
    gone[pass] = 1;
    const std::vector<Waypoint>& points = stretches_[pass].points;
    middles.push_back(0.5 * (points.front().position + points.back().position));
  }
  std::vector<RouteStretch> left;
  for (std::size_t i = 0; i < stretches_.size(); ++i) {
    const bool beside = (i > 0 && gone[i - 1] != 0) || (i + 1 < gone.size() && gone[i + 1] != 0);
    // Joins on either side of a pass that goes are made anew.
    if (gone[i] != 0 || (stretches_[i].join && beside)) continue;
    left.push_back(std::move(stretches_[i]));
  }
  stretches_ = std::move(left);
  return middles;
}

bool Itinerary::goes_on(std::size_t k) const {
  return k > 0 && !stretches_[k].join && !stretches_[k - 1].join &&
         stretches_[k].points.front().position == stretches_[k - 1].points.back().position;
}

double Itinerary::detour(const Vec2& first, const Vec2& second, std::size_t before, bool backwards,
                         bool through_water) const {
  const Vec2 from = backwards ? second : first;
  const Vec2 to = backwards ? first : second;
  const Vec2 course = (to - from).normalized();
  const auto way = [&](const Vec2& a, const Vec2& ca, const Vec2& b, const Vec2& cb) {
    const double metres = through_water ? cost_.way(a, b) : (b - a).norm();
    return metres + cost_.turning(a, ca, b, cb, metres);
  };
  double sum = 0.0;
  const bool join = before > 0 && stretches_[before - 1].join;
  const std::size_t last = join ? before - 1 : before;
  if (last > 0) {
    const LineEnds ends = ends_of(stretches_[last - 1].points);
    sum += way(ends.to, ends.course_to, from, course);
  }
  if (before < stretches_.size()) {
    const LineEnds ends = ends_of(stretches_[before].points);
    sum += way(to, course, ends.from, ends.course_from);
    if (last > 0) {
      const LineEnds previous = ends_of(stretches_[last - 1].points);
      sum -= join ? join_length(before)
                  : way(previous.to, previous.course_to, ends.from, ends.course_from);
    }
  }
  return sum;
}

double Itinerary::join_length(std::size_t before) const {
  double length = 0.0;
  const auto& points = stretches_[before - 1].points;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    length += (points[i + 1].position - points[i].position).norm();
  }
  return length + (stretches_[before].points.front().position - points.back().position).norm();
}

}  // namespace swathplan
