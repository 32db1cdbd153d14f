#include "planners/steer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "planners/line_poses.h"

namespace swathplan {
namespace {

/// How far before and behind a tight turn it may be left, radii.
constexpr double kReach[] = {0.3, 0.6, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0};
/// A metre of line replaced costs this much of a metre added (or left out: a short cut covers
/// less).
constexpr double kReplaced = 0.15;
/// A radius is kept if it falls short by no more than this share.
constexpr double kRadiusDust = 1e-6;

struct Mend {
  double cost = std::numeric_limits<double>::infinity();
  double from = 0.0, to = 0.0;  // along the line
  std::vector<Vec2> points;
};

class Mender {
 public:
  Mender(const LinePoses& line, double radius, const Connector& connector,
         const std::function<bool(const std::vector<Vec2>&)>& allowed)
      : line_(line), radius_(radius), connector_(connector), allowed_(allowed) {}

  [[nodiscard]] Mend best(double first, double last, double from, double to) const {
    Mend best;
    std::vector<Candidate> all;
    for (const double before : kReach) {
      const auto a = line_.at(std::max(from, first - before * radius_));
      if (a.along_m < from - LinePoses::kCoincidentM || tight(a)) continue;
      for (const double behind : kReach) {
        const auto b = line_.at(std::min(to, last + behind * radius_));
        if (b.along_m <= a.along_m || tight(b)) continue;
        const double replaced = b.along_m - a.along_m;
        const double length = dubins_length_m(a.pose, b.pose, radius_ * (1.0 + kRadiusReserve));
        all.push_back({std::abs(length - replaced) + kReplaced * replaced, a, b});
      }
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const Candidate& x, const Candidate& y) { return x.cost < y.cost; });
    for (const Candidate& c : all) {
      auto points = connector_.curve(c.a.pose, c.b.pose);
      if (points.empty() || (allowed_ && !allowed_(points))) continue;
      best = {c.cost, c.a.along_m, c.b.along_m, std::move(points)};
      break;
    }
    return best;
  }

 private:
  struct Candidate {
    double cost;
    LinePoses::Place a, b;
  };

  /// A tight turn is no place to begin or end at.
  [[nodiscard]] bool tight(const LinePoses::Place& place) const {
    return place.point && line_.radius_at(*place.point) < radius_ * (1.0 - kRadiusDust);
  }

  const LinePoses& line_;
  double radius_;
  const Connector& connector_;
  const std::function<bool(const std::vector<Vec2>&)>& allowed_;
};

/// Points of the line strictly between two places.
void copy(const LinePoses& line, double from, double to, std::vector<SteeredPoint>& out) {
  const auto& along = line.along();
  auto i =
      static_cast<std::size_t>(std::lower_bound(along.begin(), along.end(), from) - along.begin());
  for (; i < along.size() && along[i] <= to; ++i) {
    out.push_back({line.points()[i], line.source()[i], false});
  }
}

double length_of(const std::vector<Vec2>& points) {
  double sum = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += (points[i] - points[i - 1]).norm();
  return sum;
}

}  // namespace

Steering steered(const std::vector<Vec2>& given, double radius_m, const Connector& connector,
                 const std::function<bool(const std::vector<Vec2>&)>& allowed) {
  Steering result;
  const LinePoses line(given);
  const auto& along = line.along();
  const Mender mender(line, radius_m, connector, allowed);
  double done = 0.0;  // what is written already
  for (std::size_t i = 1; i + 1 < line.points().size(); ++i) {
    if (along[i] < done || line.radius_at(i) >= radius_m * (1.0 - kRadiusDust)) continue;
    Mend mend = mender.best(along[i], along[i], done, line.length_m());
    if (mend.points.empty()) {
      // Perhaps together with the tight turns that follow closely.
      std::size_t j = i;
      for (std::size_t k = i + 1; k + 1 < along.size() && along[k] < along[i] + 4.0 * radius_m;
           ++k) {
        if (line.radius_at(k) < radius_m * (1.0 - kRadiusDust)) j = k;
      }
      if (j != i) mend = mender.best(along[i], along[j], done, line.length_m());
    }
    if (mend.points.empty()) {
      copy(line, done, along[i], result.points);
      if (!result.points.empty()) result.points.back().tight = true;
      done = std::nextafter(along[i], std::numeric_limits<double>::infinity());
      ++result.left;
      continue;
    }
    copy(line, done, mend.from, result.points);
    while (!result.points.empty() &&
           (result.points.back().position - mend.points.front()).norm() < LinePoses::kCoincidentM) {
      result.points.pop_back();
    }
    const double added = length_of(mend.points) - (mend.to - mend.from);
    for (std::size_t k = 0; k < mend.points.size(); ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(mend.points.size() - 1);
      const auto place = line.at(mend.from + share * (mend.to - mend.from));
      result.points.push_back({mend.points[k], place.source, false});
    }
    done = std::nextafter(mend.to, std::numeric_limits<double>::infinity());
    ++result.mended;
    if (added > std::numbers::pi * radius_m) ++result.loops;
    result.added_m += added;
  }
  copy(line, done, line.length_m(), result.points);
  return result;
}

}  // namespace swathplan
