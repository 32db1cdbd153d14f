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

/// Estimates the metres of joins: the way through the water, and what turning adds for a smallest
/// radius. Ways are measured on a coarse raster only where the straight one leaves the water.
class JoinCost {
 public:
  JoinCost(const Area& water, double turn_radius_m);
  ~JoinCost();
  JoinCost(JoinCost&&) noexcept;
  JoinCost& operator=(JoinCost&&) noexcept;

  /// Metres from a to b through the water; for separate waters the straight way and kNoWay more.
  [[nodiscard]] double way(const Vec2& a, const Vec2& b) const;
  /// What a course change at both ends of a join of `way_m` adds.
  [[nodiscard]] double turning(const Vec2& a, const Vec2& course_a, const Vec2& b,
                               const Vec2& course_b, double way_m) const;
  [[nodiscard]] double operator()(const Vec2& a, const Vec2& course_a, const Vec2& b,
                                  const Vec2& course_b) const;
  static constexpr double kNoWay = 1e5;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Metres of a join from a place on a course to another on another.
using LineCost =
    std::function<double(const Vec2& a, const Vec2& course_a, const Vec2& b, const Vec2& course_b)>;

/// The order in which lines are sailed: from the order given and from the nearest next line, each
/// mended by turning runs round (2-opt) and by moving runs of up to three lines (or-opt) until
/// neither helps; the shorter is kept. Begins near `start`, if given. O(n^2) a round.
[[nodiscard]] std::vector<OrderedLine> line_order(const std::vector<LineEnds>& lines,
                                                  const LineCost& cost,
                                                  const std::optional<Vec2>& start);

[[nodiscard]] std::vector<OrderedLine> line_order(const std::vector<LineEnds>& lines,
                                                  const JoinCost& cost,
                                                  const std::optional<Vec2>& start);

}  // namespace swathplan
