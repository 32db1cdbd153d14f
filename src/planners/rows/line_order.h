#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "coverage/route/route.h"
#include "mesh/plane/polygons.h"

namespace swathplan {

/// The two ends of a survey line and the unit courses there when it is sailed from `from` to `to`.
struct LineEnds {
  Vec2 from, to;
  Vec2 course_from, course_to;
};

/// A line of the order, sailed as given or backwards.
struct OrderedLine {
  std::size_t line = 0;
  bool backwards = false;
};

/// Estimates the metres of joins: the way through the water, and the extra metres of turns with a
/// smallest radius. Where the straight way leaves the water, ways are measured on a coarse raster.
class JoinCost {
 public:
  JoinCost(const Area& water, double turn_radius_m);
  ~JoinCost();
  JoinCost(JoinCost&&) noexcept;
  JoinCost& operator=(JoinCost&&) noexcept;

  /// Metres from a to b through the water. For separate waters: the straight way plus kNoWay.
  [[nodiscard]] double way(const Vec2& a, const Vec2& b) const;
  /// Metres that the changes of course at both ends of a join of `way_m` add.
  [[nodiscard]] double turning(const Vec2& a, const Vec2& course_a, const Vec2& b,
                               const Vec2& course_b, double way_m) const;
  [[nodiscard]] double operator()(const Vec2& a, const Vec2& course_a, const Vec2& b,
                                  const Vec2& course_b) const;
  static constexpr double kNoWay = 1e5;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Metres of a join from one place and course to another.
using LineCost =
    std::function<double(const Vec2& a, const Vec2& course_a, const Vec2& b, const Vec2& course_b)>;

/// The cost of the way to the first line of an order, or from its last one: to or from the end of a
/// line with this course there.
using EndCost = std::function<double(const Vec2& line_end, const Vec2& course)>;

/// Where an order begins and ends, each empty where that costs nothing.
struct OrderEnds {
  EndCost out, home;
};

/// The order in which lines are sailed. There are two first orders: the given one, and the one that
/// always takes the nearest next line. Each is improved by turning runs of lines round (2-opt) and
/// by moving runs of up to three lines (or-opt), until neither helps. The shorter one is kept. It
/// begins near `start`, if given. O(n^2) a round.
[[nodiscard]] std::vector<OrderedLine> line_order(const std::vector<LineEnds>& lines,
                                                  const LineCost& cost,
                                                  const std::optional<Vec2>& start);

[[nodiscard]] std::vector<OrderedLine> line_order(const std::vector<LineEnds>& lines,
                                                  const JoinCost& cost,
                                                  const std::optional<Vec2>& start);

/// The same with costs of the way to the first line and from the last one, as for a round trip.
[[nodiscard]] std::vector<OrderedLine> line_order(const std::vector<LineEnds>& lines,
                                                  const LineCost& cost, const OrderEnds& ends);

/// What an order costs in all, without the lines themselves.
[[nodiscard]] double order_cost(const std::vector<LineEnds>& lines,
                                const std::vector<OrderedLine>& order, const LineCost& cost,
                                const OrderEnds& ends);

}  // namespace swathplan
