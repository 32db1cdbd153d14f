#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/plane/polygons.h"

namespace swathplan {

/// Cells of a scoring grid.
struct GridSize {
  std::uint32_t columns = 0, rows = 0;
};
/// Size of the grid over an area, without making it. `lattice`: as CoverageGrid takes it.
/// @throws UsageError if `resolution_m` is not > 0 or the grid would hold more than
///   CoverageGrid::kMaxCells; the message says the size and the limit.
[[nodiscard]] GridSize grid_size(const Area& area, double resolution_m,
                                 const std::optional<Vec2>& lattice = {});

/// Square scoring cells over an area. The grid's lower-left corner is that of the area's bounding
/// box or, where a corner of the `lattice` is given, the next corner of it to the south-west; row 0
/// is the southernmost. A cell counts when its centre lies in the area or on its
/// outline. Each cell is one word of 32 bits.
class CoverageGrid {
 public:
  /// @throws UsageError if `resolution_m` is not > 0 or the grid would hold more than kMaxCells;
  ///   the message says the size and the limit.
  CoverageGrid(const Area& area, double resolution_m, const std::optional<Vec2>& lattice = {});

  [[nodiscard]] std::uint32_t columns() const { return columns_; }
  [[nodiscard]] std::uint32_t rows() const { return rows_; }
  [[nodiscard]] double resolution_m() const { return resolution_; }
  [[nodiscard]] Vec2 origin() const { return origin_; }  ///< lower-left corner, local metres
  [[nodiscard]] Vec2 centre(std::uint32_t column, std::uint32_t row) const;

  [[nodiscard]] bool counts(std::size_t i) const { return (words_[i] & kInArea) != 0; }
  [[nodiscard]] std::uint32_t soundings(std::size_t i) const { return words_[i] & kCountMask; }
  [[nodiscard]] std::uint32_t logged_soundings(std::size_t i) const {  ///< saturates at 7
    return (words_[i] >> kLoggedShift) & 7U;
  }
  [[nodiscard]] bool footprint(std::size_t i) const { return (words_[i] & kFootprint) != 0; }
  [[nodiscard]] bool logged_footprint(std::size_t i) const {
    return (words_[i] & kLoggedFootprint) != 0;
  }
  /// Seen by two or more legs. Only 1022 legs can be told apart: legs 0 and 1022 look the same.
  [[nodiscard]] bool several_legs(std::size_t i) const {
    return ((words_[i] >> kLegShift) & kLegMask) == kLegMask;
  }

  [[nodiscard]] std::vector<std::uint32_t>& words() { return words_; }
  [[nodiscard]] const std::vector<std::uint32_t>& words() const { return words_; }

  // Layout of a word: 16 bits soundings (saturating), 3 bits logged soundings (saturating at 7),
  // 1 in area, 1 footprint, 1 logged footprint, 10 bits leg (0 none, 1..1022 a leg, 1023 several).
  static constexpr std::uint32_t kCountMask = 0xFFFFU;
  static constexpr int kLoggedShift = 16;
  static constexpr std::uint32_t kInArea = 1U << 19;
  static constexpr std::uint32_t kFootprint = 1U << 20;
  static constexpr std::uint32_t kLoggedFootprint = 1U << 21;
  static constexpr int kLegShift = 22;
  static constexpr std::uint32_t kLegMask = 1023U;
  static constexpr std::uint64_t kMaxCells = 2'000'000'000ULL;  ///< 8 GB

 private:
  std::uint32_t columns_ = 0, rows_ = 0;
  double resolution_ = 0.0;
  Vec2 origin_ = Vec2::Zero();
  std::vector<std::uint32_t> words_;
};

}  // namespace swathplan
