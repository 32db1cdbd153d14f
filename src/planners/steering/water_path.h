#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "mesh/base/frame.h"
#include "mesh/plane/polygons.h"

namespace swathplan {

/// Finds short ways through the water: around quays, moles and islands, never across.
class WaterPath {
 public:
  /// `water`: where the boat may be; ways keep `clearance_m` from its outline where they can.
  explicit WaterPath(const Area& water, double clearance_m = 1.0);
  ~WaterPath();
  WaterPath(WaterPath&&) noexcept;
  WaterPath& operator=(WaterPath&&) noexcept;

  /// The way from `from` to `to`, both included. It is straight where that stays in the water.
  /// Empty where no way exists (separate waters). Method: A* on a lattice of at most kMostCells
  /// cells, then the way is pulled taut.
  [[nodiscard]] std::optional<std::vector<Vec2>> find(const Vec2& from, const Vec2& to) const;

  static constexpr double kMostCells = 1e6;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace swathplan
