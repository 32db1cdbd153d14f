#include "planners/rows/line_order.h"

#include <algorithm>
#include <limits>

namespace swathplan {
namespace {

/// A change must save more than rounding, metres.
constexpr double kGain = 1e-6;
constexpr int kMostRounds = 60;
constexpr std::size_t kLongestRun = 3;

/// Node 2k is line k as given, node 2k + 1 the same line backwards. cost(i, j) leads from the end
/// of i to the beginning of j. To sail all of it backwards costs the same: cost(i, j) = cost(j ^ 1,
/// i ^ 1).
class Tour {
 public:
  Tour(const std::vector<LineEnds>& lines, const LineCost& cost, const OrderEnds& ends)
      : n_(lines.size()), cost_(4 * n_ * n_, 0.0), first_(2 * n_, 0.0), last_(2 * n_, 0.0) {
    const auto begin = [&](std::size_t i) {
      return i % 2 == 0 ? lines[i / 2].from : lines[i / 2].to;
    };
    const auto course = [&](std::size_t i) -> Vec2 {
      return i % 2 == 0 ? lines[i / 2].course_from : Vec2(-lines[i / 2].course_to);
    };
    for (std::size_t i = 0; i < 2 * n_; ++i) {
      if (ends.out) first_[i] = ends.out(begin(i), course(i));
      if (ends.home) last_[i] = ends.home(begin(i ^ 1U), -course(i ^ 1U));
      for (std::size_t j = 0; j < 2 * n_; ++j) {
        if (i / 2 == j / 2) continue;
        // The end of i is the beginning of i ^ 1, on the opposite course.
        at(i, j) = (j ^ 1U) < i && (j ^ 1U) / 2 != i / 2
                       ? at(j ^ 1U, i ^ 1U)
                       : cost(begin(i ^ 1U), -course(i ^ 1U), begin(j), course(j));
      }
    }
  }

  [[nodiscard]] std::vector<std::size_t> given() const {
    std::vector<std::size_t> order;
    for (std::size_t k = 0; k < n_; ++k) {
      std::size_t node = 2 * k;
      if (!order.empty() && at(order.back(), node + 1) < at(order.back(), node)) ++node;
      order.push_back(node);
    }
    return order;
  }

  [[nodiscard]] std::vector<std::size_t> nearest_next(std::size_t first) const {
    std::vector<std::size_t> order{first};
    std::vector<char> done(n_, 0);
    done[first / 2] = 1;
    while (order.size() < n_) {
      std::size_t next = 0;
      double best = std::numeric_limits<double>::infinity();
      for (std::size_t j = 0; j < 2 * n_; ++j) {
        if (done[j / 2] == 0 && at(order.back(), j) < best) {
          best = at(order.back(), j);
          next = j;
        }
      }
      done[next / 2] = 1;
      order.push_back(next);
    }
    return order;
  }

  [[nodiscard]] double length(const std::vector<std::size_t>& order) const {
    double sum = order.empty() ? 0.0 : first_[order.front()];
    for (std::size_t k = 0; k + 1 < order.size(); ++k) sum += at(order[k], order[k + 1]);
    return order.empty() ? sum : sum + last_[order.back()];
  }

  void mend(std::vector<std::size_t>& order) const {
    for (int round = 0; round < kMostRounds; ++round) {
      if (!turn_runs(order) && !move_runs(order)) return;
    }
  }

 private:
  [[nodiscard]] double at(std::size_t i, std::size_t j) const { return cost_[i * 2 * n_ + j]; }
  double& at(std::size_t i, std::size_t j) { return cost_[i * 2 * n_ + j]; }

  /// Cost of the join before position k if `node` stands there.
  [[nodiscard]] double into(const std::vector<std::size_t>& order, std::size_t k,
                            std::size_t node) const {
    return k == 0 ? first_[node] : at(order[k - 1], node);
  }
  [[nodiscard]] double out_of(const std::vector<std::size_t>& order, std::size_t k,
                              std::size_t node) const {
    return k + 1 >= order.size() ? last_[node] : at(node, order[k + 1]);
  }

  bool turn_runs(std::vector<std::size_t>& order) const {
    bool any = false;
    for (std::size_t i = 0; i < order.size(); ++i) {
      for (std::size_t j = i; j < order.size(); ++j) {
        const double now = into(order, i, order[i]) + out_of(order, j, order[j]);
        const double then = into(order, i, order[j] ^ 1U) + out_of(order, j, order[i] ^ 1U);
        if (then > now - kGain) continue;
        std::reverse(order.begin() + static_cast<std::ptrdiff_t>(i),
                     order.begin() + static_cast<std::ptrdiff_t>(j) + 1);
        for (std::size_t k = i; k <= j; ++k) order[k] ^= 1U;
        any = true;
      }
    }
    return any;
  }

  bool move_runs(std::vector<std::size_t>& order) const {
    bool any = false;
    for (std::size_t run = 1; run <= kLongestRun; ++run) {
      for (std::size_t i = 0; i + run <= order.size(); ++i) any |= move_run(order, i, run);
    }
    return any;
  }

  bool move_run(std::vector<std::size_t>& order, std::size_t i, std::size_t run) const {
    const auto from = order.begin() + static_cast<std::ptrdiff_t>(i);
    const std::vector<std::size_t> moved(from, from + static_cast<std::ptrdiff_t>(run));
    std::vector<std::size_t> rest(order.begin(), from);
    rest.insert(rest.end(), from + static_cast<std::ptrdiff_t>(run), order.end());
    if (rest.empty()) return false;
    const double here = gap(rest, i, moved.front(), moved.back());
    double best = here - kGain;
    std::size_t where = rest.size() + 1;
    bool turned = false;
    for (std::size_t k = 0; k <= rest.size(); ++k) {
      const double same = gap(rest, k, moved.front(), moved.back());
      const double back = gap(rest, k, moved.back() ^ 1U, moved.front() ^ 1U);
      if (std::min(same, back) < best) {
        best = std::min(same, back);
        where = k;
        turned = back < same;
      }
    }
    if (where > rest.size()) return false;
    std::vector<std::size_t> put = moved;
    if (turned) {
      std::reverse(put.begin(), put.end());
      for (std::size_t& node : put) node ^= 1U;
    }
    rest.insert(rest.begin() + static_cast<std::ptrdiff_t>(where), put.begin(), put.end());
    order = std::move(rest);
    return true;
  }

  /// The metres that a run from node a to node b adds before position k of `rest`.
  [[nodiscard]] double gap(const std::vector<std::size_t>& rest, std::size_t k, std::size_t a,
                           std::size_t b) const {
    if (k == 0) return first_[a] + at(b, rest[0]) - first_[rest[0]];
    if (k == rest.size()) return at(rest[k - 1], a) + last_[b] - last_[rest[k - 1]];
    return at(rest[k - 1], a) + at(b, rest[k]) - at(rest[k - 1], rest[k]);
  }

  std::size_t n_;
  std::vector<double> cost_;
  std::vector<double> first_, last_;
};

}  // namespace

std::vector<OrderedLine> line_order(const std::vector<LineEnds>& lines, const LineCost& cost,
                                    const std::optional<Vec2>& start) {
  OrderEnds ends;
  if (start) {
    ends.out = [at = *start](const Vec2& first, const Vec2&) { return (first - at).norm(); };
  }
  return line_order(lines, cost, ends);
}

std::vector<OrderedLine> line_order(const std::vector<LineEnds>& lines, const LineCost& cost,
                                    const OrderEnds& ends) {
  std::vector<OrderedLine> result;
  if (lines.empty()) return result;
  const Tour tour(lines, cost, ends);
  std::vector<std::size_t> best;
  double least = std::numeric_limits<double>::infinity();
  for (auto order : {tour.given(), tour.nearest_next(0), tour.nearest_next(2 * lines.size() - 1)}) {
    tour.mend(order);
    const double length = tour.length(order);
    if (length < least - kGain) {
      least = length;
      best = std::move(order);
    }
  }
  for (const std::size_t node : best) result.push_back({node / 2, node % 2 == 1});
  return result;
}

std::vector<OrderedLine> line_order(const std::vector<LineEnds>& lines, const JoinCost& cost,
                                    const std::optional<Vec2>& start) {
  return line_order(lines, LineCost(std::cref(cost)), start);
}

double order_cost(const std::vector<LineEnds>& lines, const std::vector<OrderedLine>& order,
                  const LineCost& cost, const OrderEnds& ends) {
  double sum = 0.0;
  std::optional<LineEnds> before;
  for (const OrderedLine& next : order) {
    LineEnds line = lines[next.line];
    if (next.backwards) {
      line = {line.to, line.from, Vec2(-line.course_to), Vec2(-line.course_from)};
    }
    if (before) {
      sum += cost(before->to, before->course_to, line.from, line.course_from);
    } else if (ends.out) {
      sum += ends.out(line.from, line.course_from);
    }
    before = line;
  }
  if (before && ends.home) sum += ends.home(before->to, before->course_to);
  return sum;
}

}  // namespace swathplan
