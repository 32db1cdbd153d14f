#include "planners/job/boats_apart.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/plane/box.h"
#include "mesh/plane/path_thinning.h"
#include "mesh/plane/segments.h"

namespace swathplan {
namespace {

constexpr double kFarApart = std::numeric_limits<double>::infinity();

Box2 box_of(const std::vector<Vec2>& path) {
  Box2 box;
  for (const Vec2& p : path) box.extend(p);
  return box;
}

/// Metres between two boxes; 0 where they meet.
double between_boxes(const Box2& a, const Box2& b) {
  const Vec2 gap = (a.min - b.max).cwiseMax(b.min - a.max).cwiseMax(Vec2::Zero());
  return gap.norm();
}

double between_segments(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  if (crossing(a, b, c, d)) return 0.0;
  return std::min({distance_to_segment(c, d, a), distance_to_segment(c, d, b),
                   distance_to_segment(a, b, c), distance_to_segment(a, b, d)});
}

/// Whether some place of one path lies within `reach` of the other.
bool within_reach(const std::vector<Vec2>& a, const std::vector<Vec2>& b, double reach) {
  const Box2 box = box_of(b);
  for (std::size_t i = 0; i + 1 < a.size(); ++i) {
    if (between_boxes(box_of({a[i], a[i + 1]}), box) >= reach) continue;
    for (std::size_t k = 0; k + 1 < b.size(); ++k) {
      if (between_segments(a[i], a[i + 1], b[k], b[k + 1]) < reach) return true;
    }
  }
  return false;
}

/// The path with fewer points, within half a metre of it: enough to tell neighbours.
std::vector<Vec2> coarse(const std::vector<Vec2>& path) {
  constexpr double kOff = 0.5;
  std::vector<Vec2> points;
  for (const std::size_t i : thin_path(path, {}, kOff).kept) points.push_back(path[i]);
  return points;
}

bool alongside(LegKind kind) { return kind == LegKind::line || kind == LegKind::infill; }

/// A line as it is sailed at some time.
struct SailedLeg {
  double begins_s = 0.0, ends_s = 0.0;
  bool has_neighbours = false;
  std::vector<Vec2> path, coarse_path;
  std::vector<double> at_s;  ///< of the path's points
  double swath_m = 0.0;
};

std::vector<SailedLeg> sailed_legs(const BoatTrack& track, const Ground& ground,
                                   const Vehicle& vehicle) {
  std::vector<SailedLeg> result;
  for (const TimedRoute& timed : track) {
    const auto& w = timed.route->waypoints;
    double now = timed.begins_s;
    for (const Leg& leg : legs(*timed.route)) {
      SailedLeg sailed;
      sailed.begins_s = now;
      for (std::size_t i = leg.first; i <= leg.last; ++i) {
        sailed.path.push_back(w[i].position);
        sailed.at_s.push_back(now);
        if (i < leg.last) now += (w[i + 1].position - w[i].position).norm() / w[i].speed_mps;
      }
      sailed.ends_s = now;
      if (!is_survey(w[leg.first].kind)) continue;
      sailed.has_neighbours = alongside(w[leg.first].kind);
      sailed.swath_m = swath_of({w.begin() + static_cast<std::ptrdiff_t>(leg.first),
                                 w.begin() + static_cast<std::ptrdiff_t>(leg.last)},
                                ground, vehicle);
      sailed.coarse_path = coarse(sailed.path);
      result.push_back(std::move(sailed));
    }
  }
  return result;
}

Vec2 place_at(const SailedLeg& leg, double seconds, std::size_t& i) {
  while (i + 2 < leg.at_s.size() && leg.at_s[i + 1] <= seconds) ++i;
  const double step = leg.at_s[i + 1] - leg.at_s[i];
  const double share = step > 0.0 ? std::clamp((seconds - leg.at_s[i]) / step, 0.0, 1.0) : 0.0;
  return leg.path[i] + share * (leg.path[i + 1] - leg.path[i]);
}

/// The share of a straight motion from `a` to `b` that lies within `reach` of the origin.
double share_within(const Vec2& a, const Vec2& b, double reach) {
  const Vec2 way = b - a;
  const double square = way.squaredNorm();
  if (!(square > 0.0)) return a.norm() < reach ? 1.0 : 0.0;
  const double half = a.dot(way);
  const double root = half * half - square * (a.squaredNorm() - reach * reach);
  if (!(root > 0.0)) return 0.0;
  const double from = std::clamp((-half - std::sqrt(root)) / square, 0.0, 1.0);
  const double to = std::clamp((-half + std::sqrt(root)) / square, 0.0, 1.0);
  return to - from;
}

struct Nearness {
  double least_m = kFarApart;
  double within_s = 0.0;  ///< seconds within the reach
};

/// How near two boats come while both sail these legs: straight motions between the times at which
/// either passes a waypoint.
Nearness nearness(const SailedLeg& a, const SailedLeg& b, double reach) {
  const double from = std::max(a.begins_s, b.begins_s);
  const double to = std::min(a.ends_s, b.ends_s);
  std::vector<double> times{from, to};
  for (const SailedLeg* leg : {&a, &b}) {
    for (const double t : leg->at_s) {
      if (t > from && t < to) times.push_back(t);
    }
  }
  std::sort(times.begin(), times.end());
  Nearness result;
  std::size_t in_a = 0, in_b = 0;
  Vec2 before = Vec2::Zero();
  for (std::size_t k = 0; k < times.size(); ++k) {
    const Vec2 apart = place_at(a, times[k], in_a) - place_at(b, times[k], in_b);
    if (k > 0) {
      result.least_m = std::min(result.least_m, distance_to_segment(before, apart, Vec2::Zero()));
      result.within_s += (times[k] - times[k - 1]) * share_within(before, apart, reach);
    }
    before = apart;
  }
  return result;
}

void watch(const std::vector<SailedLeg>& one, const std::vector<SailedLeg>& other,
           BoatsApart& apart) {
  for (const SailedLeg& a : one) {
    for (const SailedLeg& b : other) {
      const double together = std::min(a.ends_s, b.ends_s) - std::max(a.begins_s, b.begins_s);
      if (!(together > 0.0)) continue;
      const double swath = 0.5 * (a.swath_m + b.swath_m);
      const Nearness near = nearness(a, b, swath);
      apart.least_m = std::min(apart.least_m.value_or(kFarApart), near.least_m);
      if (!a.has_neighbours || !b.has_neighbours) continue;
      apart.within_a_swath_s += near.within_s;
      if (within_reach(a.coarse_path, b.coarse_path, swath)) apart.neighbours_s += together;
    }
  }
}

/// The search for orders.
class OrderSearch {
 public:
  OrderSearch(std::vector<SortieLines> boats, const Ground& ground, const Vehicle& vehicle,
              const JobWays& ways, const Vec2& berth)
      : ways_(ways), berth_(berth) {
    for (const SortieLines& boat : boats) {
      orders_.emplace_back();
      for (const JobLine& line : boat) {
        orders_.back().push_back({lines_.size(), line, sailing_s(line.points), {}});
        lines_.push_back(line);
        boat_of_.push_back(orders_.size() - 1);
      }
    }
    for (auto& order : orders_) set_joins(order);
    std::vector<double> swath;
    std::vector<std::vector<Vec2>> paths;
    for (const JobLine& line : lines_) {
      swath.push_back(swath_of(line.points, ground, vehicle));
      paths.push_back(coarse(positions(line.points)));
    }
    near_.assign(lines_.size() * lines_.size(), 0);
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (boat_of_[i] == boat_of_[j]) continue;
        const bool close = purpose(lines_[i]) == LegKind::line &&
                           purpose(lines_[j]) == LegKind::line &&
                           within_reach(paths[i], paths[j], 0.5 * (swath[i] + swath[j]));
        near_[i * lines_.size() + j] = near_[j * lines_.size() + i] = close ? 1 : 0;
      }
    }
  }

  struct Placed {
    std::size_t line;
    JobLine as_sailed;
    double seconds;                ///< of the line
    std::optional<double> join_s;  ///< of the way from the line before
  };
  using Orders = std::vector<std::vector<Placed>>;

  struct Cost {
    double neighbours_s = 0.0, makespan_s = 0.0;
    std::vector<std::size_t> in_the_way;  ///< lines with a neighbour at the same time
    [[nodiscard]] bool better_than(const Cost& other) const {
      constexpr double kDust = 1e-6;
      if (neighbours_s < other.neighbours_s - kDust) return true;
      return neighbours_s <= other.neighbours_s + kDust && makespan_s < other.makespan_s - kDust;
    }
  };

  [[nodiscard]] Cost cost(const Orders& orders) const {
    struct Span {
      std::size_t line;
      double from, to;
    };
    std::vector<std::vector<Span>> spans;
    Cost result;
    for (const auto& order : orders) {
      spans.emplace_back();
      double now = 0.0;
      for (std::size_t k = 0; k < order.size(); ++k) {
        const JobLine& line = order[k].as_sailed;
        const LineEnds ends = ends_of_line(line);
        now += k == 0 ? ways_.free_s(berth_, ends.from, ends.course_from) : *order[k].join_s;
        const double begins = now;
        now += order[k].seconds;
        spans.back().push_back({order[k].line, begins, now});
      }
      if (!order.empty()) {
        const LineEnds ends = ends_of_line(order.back().as_sailed);
        now += ways_.free_s(berth_, ends.to, -ends.course_to);
      }
      result.makespan_s = std::max(result.makespan_s, now);
    }
    for (std::size_t a = 0; a < spans.size(); ++a) {
      for (std::size_t b = a + 1; b < spans.size(); ++b) {
        for (const Span& one : spans[a]) {
          for (const Span& other : spans[b]) {
            const double together = std::min(one.to, other.to) - std::max(one.from, other.from);
            if (together <= -kLeeway || near_[one.line * lines_.size() + other.line] == 0) continue;
            result.neighbours_s += together + kLeeway;
            result.in_the_way.push_back(one.line);
            result.in_the_way.push_back(other.line);
          }
        }
      }
    }
    return result;
  }

  /// The better of each boat's order and the same turned round; lines before `fixed` of the first
  /// boat stay.
  void turn_round(std::size_t fixed) {
    Cost best = cost(orders_);
    const Orders given = orders_;
    for (std::size_t mask = 1; mask < (std::size_t{1} << given.size()); ++mask) {
      Orders turned = given;
      for (std::size_t boat = 0; boat < given.size(); ++boat) {
        if ((mask >> boat & 1U) == 0) continue;
        turn(turned[boat], boat == 0 ? fixed : 0);
        for (Placed& placed : turned[boat]) placed.join_s.reset();
        set_joins(turned[boat]);
      }
      const Cost now = cost(turned);
      if (!now.better_than(best)) continue;
      best = now;
      orders_ = std::move(turned);
    }
  }

  /// Moves lines that are in the way to where they are not, the best move first.
  void move_lines(std::size_t fixed) {
    constexpr int kMostMoves = 12;
    constexpr double kLonger = 1.04;  // a move may cost so much of the time
    Cost now = cost(orders_);
    const double most = kLonger * now.makespan_s;
    for (int move = 0; move < kMostMoves && now.neighbours_s > 0.0; ++move) {
      Cost best = now;
      Orders found;
      std::vector<std::size_t> tried = now.in_the_way;
      std::sort(tried.begin(), tried.end());
      tried.erase(std::unique(tried.begin(), tried.end()), tried.end());
      for (const std::size_t line : tried) {
        const std::size_t boat = boat_of_[line];
        const std::size_t first = boat == 0 ? fixed : 0;
        for (std::size_t to = first; to < orders_[boat].size(); ++to) {
          Orders moved = orders_;
          move_line(moved[boat], line, to);
          set_joins(moved[boat]);
          const Cost then = cost(moved);
          if (then.makespan_s > most || !then.better_than(best)) continue;
          best = then;
          found = std::move(moved);
        }
      }
      if (found.empty()) return;
      orders_ = std::move(found);
      now = best;
    }
  }

  [[nodiscard]] std::vector<SortieLines> lines() const {
    std::vector<SortieLines> result;
    for (const auto& order : orders_) {
      result.emplace_back();
      for (const Placed& placed : order) result.back().push_back(placed.as_sailed);
    }
    return result;
  }

 private:
  /// Estimates are off by some seconds: neighbours are to be this far apart in time.
  static constexpr double kLeeway = 20.0;

  /// Times of the joins that have none yet.
  void set_joins(std::vector<Placed>& order) const {
    for (std::size_t k = 1; k < order.size(); ++k) {
      if (order[k].join_s) continue;
      order[k].join_s = join_before_s(order[k - 1].as_sailed, order[k].as_sailed, ways_);
    }
  }

  static void turn(std::vector<Placed>& order, std::size_t first) {
    const auto begin = order.begin() + static_cast<std::ptrdiff_t>(std::min(first, order.size()));
    SortieLines rest;
    for (auto it = begin; it != order.end(); ++it) rest.push_back(it->as_sailed);
    rest = backwards(rest);
    std::reverse(begin, order.end());
    for (std::size_t k = 0; k < rest.size(); ++k) {
      (begin + static_cast<std::ptrdiff_t>(k))->as_sailed = rest[k];
    }
  }

  static void move_line(std::vector<Placed>& order, std::size_t line, std::size_t to) {
    const auto at =
        std::find_if(order.begin(), order.end(), [&](const Placed& p) { return p.line == line; });
    const auto k = static_cast<std::size_t>(at - order.begin());
    if (k == to) return;
    const auto without_join = [](Placed& placed) {
      placed.as_sailed.join_before.clear();
      placed.join_s.reset();
    };
    Placed moved = *at;
    without_join(moved);
    if (k + 1 < order.size()) without_join(order[k + 1]);
    order.erase(at);
    if (to < order.size()) without_join(order[to]);
    order.insert(order.begin() + static_cast<std::ptrdiff_t>(to), std::move(moved));
  }

  const JobWays& ways_;
  Vec2 berth_;
  std::vector<JobLine> lines_;
  std::vector<std::size_t> boat_of_;
  std::vector<char> near_;
  Orders orders_;
};

}  // namespace

double swath_of(const std::vector<Waypoint>& points, const Ground& ground, const Vehicle& vehicle) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const Waypoint& w : points) {
    const auto depth = ground.depths->depth(w.position);
    if (!w.fan || !depth) continue;
    const double below = std::max(0.0, *depth - vehicle.draft_m);
    sum += below * (tan(w.fan->port) + tan(w.fan->starboard));
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

bool neighbours(const JobLine& a, const JobLine& b, double swath_m) {
  if (purpose(a) != LegKind::line || purpose(b) != LegKind::line) return false;
  return within_reach(coarse(positions(a.points)), coarse(positions(b.points)), swath_m);
}

BoatsApart boats_apart(const std::vector<BoatTrack>& tracks, const Ground& ground,
                       const Vehicle& vehicle) {
  std::vector<std::vector<SailedLeg>> sailed;
  for (const BoatTrack& track : tracks) sailed.push_back(sailed_legs(track, ground, vehicle));
  BoatsApart apart;
  for (std::size_t a = 0; a < sailed.size(); ++a) {
    for (std::size_t b = a + 1; b < sailed.size(); ++b) watch(sailed[a], sailed[b], apart);
  }
  return apart;
}

std::vector<SortieLines> kept_apart(std::vector<SortieLines> boats, std::size_t fixed,
                                    const Ground& ground, const Vehicle& vehicle,
                                    const JobWays& ways, const Vec2& berth) {
  if (boats.size() < 2) return boats;
  OrderSearch search(std::move(boats), ground, vehicle, ways, berth);
  search.turn_round(fixed);
  search.move_lines(fixed);
  return search.lines();
}

}  // namespace swathplan
