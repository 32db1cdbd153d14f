#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "planners/rows/line_order.h"
#include "planners/rows/route_stretches.h"

namespace swathplan {

/// The stretches of a route in sailing order. Finds the place between two of them where a straight
/// pass costs least. Keeps a reference to `cost`.
class Itinerary {
 public:
  Itinerary(const Route& route, const JoinCost& cost);
  Itinerary(std::vector<RouteStretch> stretches, const JoinCost& cost)
      : stretches_(std::move(stretches)), cost_(cost) {}

  struct Place {
    std::size_t before = 0;  ///< the stretch before which the pass goes; their number: at the end
    bool backwards = false;  ///< sailed from its `to` to its `from`
    double cost = std::numeric_limits<double>::infinity();  ///< metres of detour
  };
  [[nodiscard]] Place cheapest(const Vec2& from, const Vec2& to) const;
  /// A join there is given up.
  void insert(std::vector<Waypoint> points, std::size_t before);
  /// Runs of stretches that keep the joins between them. Each run is added as one line.
  [[nodiscard]] std::vector<std::vector<Waypoint>> runs() const;
  /// Takes out infill passes next to joins that cannot be steered. Returns their middles.
  std::vector<Vec2> give_up_unjoined();

 private:
  /// Whether stretch k is the next leg of the line before it.
  [[nodiscard]] bool goes_on(std::size_t k) const;
  [[nodiscard]] double detour(const Vec2& first, const Vec2& second, std::size_t before,
                              bool backwards, bool through_water) const;
  [[nodiscard]] double join_length(std::size_t before) const;

  std::vector<RouteStretch> stretches_;
  const JoinCost& cost_;
};

}  // namespace swathplan
