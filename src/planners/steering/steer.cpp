#include "planners/steering/steer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "planners/steering/line_poses.h"

namespace swathplan {
namespace {

/// Distances before and behind a tight turn at which the line may be left and met again, radii.
constexpr double kReach[] = {0.3, 0.6, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0};
/// A metre of line that is replaced costs this much of a metre that is added. A metre left out
/// costs as much as one added: a short cut covers less.
constexpr double kReplaced = 0.15;

/// A Dubins path instead of a stretch of the line.
struct Replacement {
  double cost = std::numeric_limits<double>::infinity();
  double from = 0.0, to = 0.0;  // metres along the line
  std::vector<Vec2> points;
};

/// Finds the cheapest replacement for the tight turns between two places of a line.
class ReplacementSearch {
 public:
  ReplacementSearch(const LinePoses& line, double radius, const Connector& connector,
                    const std::function<bool(const std::vector<Vec2>&)>& allowed)
      : line_(line), radius_(radius), connector_(connector), allowed_(allowed) {}

  [[nodiscard]] Replacement best(double first, double last, double from, double to) const {
    Replacement best;
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

  /// A replacement must not begin or end at a tight turn.
  [[nodiscard]] bool tight(const LinePoses::Place& place) const {
    return place.point && line_.radius_at(*place.point, radius_) < radius_ * (1.0 - kRadiusDust);
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

/// Writes the line from its beginning to its end, with its tight turns replaced.
class LineRewriter {
 public:
  LineRewriter(const LinePoses& line, double radius, const ReplacementSearch& search)
      : line_(line), radius_(radius), search_(search) {}

  [[nodiscard]] Steering rewritten() {
    const auto& along = line_.along();
    for (std::size_t i = 1; i + 1 < line_.points().size(); ++i) {
      if (along[i] < done_ || !tight(i)) continue;
      double first = along[i];
      Replacement replacement = search_.best(first, first, done_, line_.length_m());
      if (replacement.points.empty()) replacement = with_those_that_follow(i);
      if (last_ && (replacement.points.empty() || is_loop(replacement))) {
        // The path for the turn before may end too near to this one. Try one path for both.
        Replacement joint = search_.best(last_->tight_m, first, last_->done_m, line_.length_m());
        if (joint.cost < last_->cost + replacement.cost) {
          first = last_->tight_m;
          replacement = std::move(joint);
          take_back();
        }
      }
      replacement.points.empty() ? leave(along[i]) : write(first, replacement);
    }
    copy(line_, done_, line_.length_m(), result_.points);
    return std::move(result_);
  }

 private:
  /// The replacement that was written last, and the state before it.
  struct Written {
    double tight_m, done_m, cost, added_m;
    std::size_t points;
    bool loop;
  };

  [[nodiscard]] bool tight(std::size_t i) const {
    return line_.radius_at(i, radius_) < radius_ * (1.0 - kRadiusDust);
  }
  [[nodiscard]] static double added_m(const Replacement& replacement) {
    return length_of(replacement.points) - (replacement.to - replacement.from);
  }
  [[nodiscard]] bool is_loop(const Replacement& replacement) const {
    return added_m(replacement) > std::numbers::pi * radius_;
  }

  /// One replacement for turn i and the tight turns that follow closely.
  [[nodiscard]] Replacement with_those_that_follow(std::size_t i) const {
    const auto& along = line_.along();
    std::size_t j = i;
    for (std::size_t k = i + 1; k + 1 < along.size() && along[k] < along[i] + 4.0 * radius_; ++k) {
      if (tight(k)) j = k;
    }
    return j == i ? Replacement{} : search_.best(along[i], along[j], done_, line_.length_m());
  }

  void leave(double along) {
    copy(line_, done_, along, result_.points);
    if (!result_.points.empty()) result_.points.back().tight = true;
    done_ = std::nextafter(along, std::numeric_limits<double>::infinity());
    ++result_.left;
    last_.reset();
  }

  void write(double tight_m, const Replacement& replacement) {
    const bool loop = is_loop(replacement);
    last_ = {tight_m, done_, replacement.cost, added_m(replacement), result_.points.size(), loop};
    copy(line_, done_, replacement.from, result_.points);
    while (!result_.points.empty() &&
           (result_.points.back().position - replacement.points.front()).norm() <
               LinePoses::kCoincidentM) {
      result_.points.pop_back();
    }
    for (std::size_t k = 0; k < replacement.points.size(); ++k) {
      const double share =
          static_cast<double>(k) / static_cast<double>(replacement.points.size() - 1);
      const auto place = line_.at(replacement.from + share * (replacement.to - replacement.from));
      result_.points.push_back({replacement.points[k], place.source, false});
    }
    done_ = std::nextafter(replacement.to, std::numeric_limits<double>::infinity());
    ++result_.mended;
    result_.loops += loop ? 1 : 0;
    result_.added_m += last_->added_m;
  }

  void take_back() {
    result_.points.resize(last_->points);
    done_ = last_->done_m;
    --result_.mended;
    result_.loops -= last_->loop ? 1 : 0;
    result_.added_m -= last_->added_m;
  }

  const LinePoses& line_;
  double radius_;
  const ReplacementSearch& search_;
  Steering result_;
  double done_ = 0.0;  // metres of the line that are written already
  std::optional<Written> last_;
};

}  // namespace

Steering steered(const std::vector<Vec2>& given, double radius_m, const Connector& connector,
                 const std::function<bool(const std::vector<Vec2>&)>& allowed) {
  const LinePoses line(given);
  const ReplacementSearch search(line, radius_m, connector, allowed);
  return LineRewriter(line, radius_m, search).rewritten();
}

}  // namespace swathplan
