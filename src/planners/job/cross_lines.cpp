#include "planners/job/cross_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "coverage/route/cross_figures.h"
#include "mesh/base/require.h"
#include "mesh/plane/area_query.h"
#include "mesh/plane/box.h"
#include "mesh/plane/segments.h"
#include "planners/job/ground_slope.h"

namespace swathplan {
namespace {

constexpr std::size_t kTenths = 10;
/// Ground of this slope is worth half as much as level ground.
constexpr double kGentleDeg = 5.0;
/// Directions of the main scheme that cross-lines stand at right angles to, at most.
constexpr std::size_t kMostDirections = 4;
constexpr int kDirectionBins = 36;  // of 5 degrees
/// Rows of candidates over the site's width.
constexpr int kRowsTried = 80;
/// Segments of the main scheme count for no more than so many metres, since depths change along it.
constexpr double kStretch = 10.0;
/// Lines keep so far off the edge of the water, metres.
constexpr double kEdge = 0.05;

struct MainSegment {
  Vec2 a, b;
  std::size_t line;
  double depth_m;
};

/// A place where a candidate crosses the main scheme.
struct CrossingPlace {
  double along_m;
  std::size_t line, tenth;
  double gentle;  ///< (0, 1]
  double slope_deg;
};

/// A straight stretch of water that crosses the main scheme.
struct CrossCandidate {
  Vec2 from, course;
  double length_m;
  std::vector<CrossingPlace> places;  ///< in order along it
};

/// A piece of a candidate.
struct CrossWindow {
  std::size_t candidate = 0;
  double from_m = 0.0, to_m = 0.0, worth = 0.0;
};

/// The main scheme as segments, its length, its directions and its depths.
class MainScheme {
 public:
  MainScheme(const std::vector<JobLine>& main, const Ground& ground) {
    std::array<double, kDirectionBins> by_direction{};
    for (std::size_t k = 0; k < main.size(); ++k) {
      const auto& w = main[k].points;
      for (std::size_t i = 0; i + 1 < w.size(); ++i) {
        const bool counts =
            w[i].log && (w[i].kind == LegKind::line || w[i].kind == LegKind::infill);
        const Vec2 way = w[i + 1].position - w[i].position;
        if (!counts || !(way.norm() > 0.0)) continue;
        const int stretches = static_cast<int>(std::ceil(way.norm() / kStretch));
        for (int part = 0; part < stretches; ++part) {
          const Vec2 a = w[i].position + way * part / stretches;
          const Vec2 b = w[i].position + way * (part + 1) / stretches;
          const auto depth = ground.depths->depth(0.5 * (a + b));
          segments_.push_back({a, b, k, depth.value_or(0.0)});
        }
        length_ += way.norm();
        const double turn = std::atan2(way.x(), way.y()) / std::numbers::pi;  // half turns
        const double bin = std::floor((turn - std::floor(turn)) * kDirectionBins);
        by_direction[static_cast<std::size_t>(bin) % kDirectionBins] += way.norm();
      }
    }
    set_tenths();
    set_directions(by_direction);
  }

  [[nodiscard]] const std::vector<MainSegment>& segments() const { return segments_; }
  [[nodiscard]] double length_m() const { return length_; }
  /// Unit courses across the main directions, the most sailed first.
  [[nodiscard]] const std::vector<Vec2>& across() const { return across_; }
  [[nodiscard]] std::size_t tenth(double depth_m) const {
    const auto at = std::upper_bound(limits_.begin(), limits_.end(), depth_m);
    return static_cast<std::size_t>(at - limits_.begin());
  }

 private:
  /// Depths between which lie tenths of the scheme's length.
  void set_tenths() {
    std::vector<std::pair<double, double>> by_depth;
    for (const MainSegment& s : segments_) by_depth.emplace_back(s.depth_m, (s.b - s.a).norm());
    std::sort(by_depth.begin(), by_depth.end());
    double sum = 0.0;
    for (const auto& [depth, metres] : by_depth) {
      sum += metres;
      while (limits_.size() + 1 < kTenths &&
             sum > length_ * static_cast<double>(limits_.size() + 1) / kTenths) {
        limits_.push_back(depth);
      }
    }
  }

  void set_directions(std::array<double, kDirectionBins> by_direction) {
    const double least = 0.05 * length_;
    for (std::size_t k = 0; k < kMostDirections; ++k) {
      const auto most = std::max_element(by_direction.begin(), by_direction.end());
      if (!(*most > least)) break;
      const auto bin = static_cast<std::size_t>(most - by_direction.begin());
      // The mean direction of the segments in the bin and beside it.
      Vec2 twice = Vec2::Zero();
      for (const MainSegment& s : segments_) {
        const double angle = 2.0 * std::atan2((s.b - s.a).x(), (s.b - s.a).y());
        const double centre =
            2.0 * std::numbers::pi * (static_cast<double>(bin) + 0.5) / kDirectionBins;
        if (std::cos(angle - centre) < std::cos(2.0 * std::numbers::pi / kDirectionBins * 1.5)) {
          continue;
        }
        twice += (s.b - s.a).norm() * Vec2(std::sin(angle), std::cos(angle));
      }
      const double mean = 0.5 * std::atan2(twice.x(), twice.y());
      across_.emplace_back(std::cos(mean), -std::sin(mean));
      for (const std::size_t near : {bin + kDirectionBins - 2, bin + kDirectionBins - 1,
                                     bin + kDirectionBins, bin + 1, bin + 2}) {
        by_direction[near % kDirectionBins] = 0.0;
      }
    }
  }

  std::vector<MainSegment> segments_;
  std::vector<double> limits_;
  std::vector<Vec2> across_;
  double length_ = 0.0;
};

class CrossLineSearch {
 public:
  CrossLineSearch(const MainScheme& scheme, const Ground& ground, const PlanOptions& options)
      : scheme_(scheme),
        ground_(ground),
        options_(options),
        line_crossings_(1 + largest_line(), 0),
        area_(reachable_area(ground)),
        query_(area_) {
    for (const Vec2& course : scheme_.across()) add_candidates(course);
  }

  /// The window that is worth most for its length, at most `longest_m` long.
  [[nodiscard]] CrossWindow best(double longest_m) const {
    CrossWindow best;
    for (std::size_t c = 0; c < candidates_.size(); ++c) {
      const CrossCandidate& candidate = candidates_[c];
      const double length = std::min(longest_m, candidate.length_m);
      for (std::size_t i = 0; i < candidate.places.size(); ++i) {
        const double last = candidate.length_m - length;
        const double from = std::clamp(candidate.places[i].along_m - kPad, 0.0, last);
        const double worth = worth_of(candidate, from, from + length) / (length + kTurnWorth);
        if (worth > best.worth) best = {c, from, from + length, worth};
      }
    }
    return best;
  }

  [[nodiscard]] std::pair<Vec2, Vec2> ends(const CrossWindow& w) const {
    const CrossCandidate& c = candidates_[w.candidate];
    return {c.from + w.from_m * c.course, c.from + w.to_m * c.course};
  }

  /// Counts what the window crosses, and takes it off its candidate.
  void take(const CrossWindow& w) {
    CrossCandidate& c = candidates_[w.candidate];
    for (const CrossingPlace& p : c.places) {
      if (p.along_m < w.from_m || p.along_m > w.to_m) continue;
      ++line_crossings_[p.line];
      ++tenth_crossings_[p.tenth];
      slopes_.push_back(p.slope_deg);
    }
    drop(w);
  }

  /// Crosses the window out: it is sailed, or cannot be.
  void drop(const CrossWindow& w) {
    CrossCandidate rest = candidates_[w.candidate];
    CrossCandidate& head = candidates_[w.candidate];
    std::erase_if(head.places, [&](const CrossingPlace& p) { return p.along_m >= w.from_m; });
    head.length_m = w.from_m;
    std::erase_if(rest.places, [&](const CrossingPlace& p) { return p.along_m <= w.to_m; });
    for (CrossingPlace& p : rest.places) p.along_m -= w.to_m;
    rest.from += w.to_m * rest.course;
    rest.length_m -= w.to_m;
    if (!rest.places.empty() && rest.length_m >= least_m()) candidates_.push_back(std::move(rest));
    if (candidates_[w.candidate].length_m < least_m()) candidates_[w.candidate].places.clear();
  }

  [[nodiscard]] double least_m() const { return std::max(options_.least_line_m, 2.0 * kPad); }
  [[nodiscard]] std::size_t tenths_crossed() const {
    return static_cast<std::size_t>(
        std::count_if(tenth_crossings_.begin(), tenth_crossings_.end(),
                      [](std::size_t crossings) { return crossings > 0; }));
  }
  [[nodiscard]] const std::vector<double>& slopes() const { return slopes_; }

 private:
  /// Metres of a cross-line before its first crossing and behind its last.
  static constexpr double kPad = 5.0;
  /// A turn onto another cross-line costs as much as so many metres.
  static constexpr double kTurnWorth = 50.0;

  [[nodiscard]] std::size_t largest_line() const {
    std::size_t largest = 0;
    for (const MainSegment& s : scheme_.segments()) largest = std::max(largest, s.line);
    return largest;
  }

  [[nodiscard]] double worth_of(const CrossCandidate& c, double from, double to) const {
    double worth = 0.0;
    std::array<std::size_t, kTenths> here = tenth_crossings_;
    for (const CrossingPlace& p : c.places) {
      if (p.along_m < from || p.along_m > to) continue;
      worth += p.gentle / static_cast<double>(1 + line_crossings_[p.line]) /
               std::sqrt(static_cast<double>(1 + here[p.tenth]));
      ++here[p.tenth];
    }
    return worth;
  }

  void add_candidates(const Vec2& course) {
    const Vec2 aside(course.y(), -course.x());
    Box2 turned;
    for (const Polygon& polygon : area_) {
      for (const Vec2& p : polygon.outer) turned.extend({p.dot(aside), p.dot(course)});
    }
    if (turned.empty()) return;
    const double step = turned.size().x() / kRowsTried;
    for (int row = 0; row < kRowsTried; ++row) {
      const double x = turned.min.x() + (row + 0.5) * step;
      const Vec2 a = x * aside + turned.min.y() * course;
      const Vec2 b = x * aside + turned.max.y() * course;
      for (const auto& [from, to] : query_.clip(a, b)) {
        const double length = (to - from) * (b - a).norm() - 2.0 * kEdge;
        if (length < least_m()) continue;
        CrossCandidate c{a + from * (b - a) + kEdge * course, course, length, {}};
        find_crossings(c);
        if (!c.places.empty()) candidates_.push_back(std::move(c));
      }
    }
  }

  void find_crossings(CrossCandidate& c) const {
    const Vec2 to = c.from + c.length_m * c.course;
    for (const MainSegment& s : scheme_.segments()) {
      const auto at = crossing(c.from, to, s.a, s.b);
      if (!at || crossing_angle_deg(c.course, s.b - s.a) < 90.0 - kRightAngleDeg) continue;
      const Vec2 place = c.from + *at * (to - c.from);
      const double span = std::max(1.0, 0.5 * s.depth_m);
      const auto gradient = depth_gradient(*ground_.depths, place, span);
      const double slope = gradient ? std::atan(gradient->norm()) * 180.0 / std::numbers::pi : 90.0;
      const double steep = slope / kGentleDeg;
      c.places.push_back(
          {*at * c.length_m, s.line, scheme_.tenth(s.depth_m), 1.0 / (1.0 + steep * steep), slope});
    }
    std::sort(c.places.begin(), c.places.end(),
              [](const CrossingPlace& a, const CrossingPlace& b) { return a.along_m < b.along_m; });
  }

  const MainScheme& scheme_;
  const Ground& ground_;
  const PlanOptions& options_;
  std::vector<std::size_t> line_crossings_;
  std::array<std::size_t, kTenths> tenth_crossings_{};
  std::vector<double> slopes_;
  Area area_;
  AreaQuery query_;
  std::vector<CrossCandidate> candidates_;
};

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double slope_below(const MainScheme& scheme, const Ground& ground) {
  std::vector<double> slopes;
  for (const MainSegment& s : scheme.segments()) {
    const auto gradient =
        depth_gradient(*ground.depths, 0.5 * (s.a + s.b), std::max(1.0, 0.5 * s.depth_m));
    if (gradient) slopes.push_back(std::atan(gradient->norm()) * 180.0 / std::numbers::pi);
  }
  return median(std::move(slopes));
}

/// A straight line with the fan that is due at its mean depth.
JobLine cross_line(const Vec2& from, const Vec2& to, int number, const Ground& ground,
                   const PlanOptions& options) {
  constexpr int kSamples = 20;
  double sum = 0.0;
  int known = 0;
  for (int k = 0; k <= kSamples; ++k) {
    const auto depth = ground.depths->depth(from + (to - from) * k / kSamples);
    if (!depth) continue;
    sum += *depth;
    ++known;
  }
  Waypoint w;
  w.kind = LegKind::cross;
  w.line = number;
  w.fan = fan_for_depth(options, known > 0 ? sum / known : options.vehicle.draft_m + 1.0);
  w.speed_mps = options.vehicle.speed_mps;
  JobLine line{{w, w}, {}};
  line.points[0].position = from;
  line.points[1].position = to;
  return line;
}

}  // namespace

void check(const CrossLineOptions& how) {
  require(how.share > 0.0 && how.share <= 1.0, "cross lines", 100.0 * how.share,
          "above 0 and at most 100 per cent");
}

CrossLines cross_lines(const std::vector<JobLine>& main, const Ground& ground,
                       const PlanOptions& options, const Connector& connector,
                       const CrossLineOptions& how) {
  check(how);
  CrossLines result;
  const MainScheme scheme(main, ground);
  if (scheme.segments().empty()) return result;
  CrossLineSearch search(scheme, ground, options);
  const double wanted = how.share * scheme.length_m();
  const double longest = std::max(search.least_m(), wanted / 3.0);
  double laid = 0.0;
  constexpr double kDust = 1e-6;
  while (laid < wanted - kDust) {
    const CrossWindow window =
        search.best(std::max(search.least_m(), std::min(longest, wanted - laid)));
    if (!(window.worth > 0.0)) break;
    const auto [from, to] = search.ends(window);
    if (!connector.has_room({from, to})) {
      search.drop(window);
      continue;
    }
    search.take(window);
    const int number = how.first_number + static_cast<int>(result.lines.size());
    result.lines.push_back(cross_line(from, to, number, ground, options));
    laid += (to - from).norm();
  }
  result.share = laid / scheme.length_m();
  result.depth_tenths = search.tenths_crossed();
  result.median_slope_deg = median(search.slopes());
  result.site_slope_deg = slope_below(scheme, ground);
  return result;
}

}  // namespace swathplan
