#pragma once

#include <cstdint>
#include <random>

#include "coverage/tracing/coverage_grid.h"

namespace swathplan::test {

/// A square with one corner cut off.
inline const Area kCutSquare{
    {.outer = {{2, 3}, {32, 3}, {32, 43}, {12, 43}, {2, 33}}, .holes = {}}};

/// Random soundings, a third of the cells empty.
inline CoverageGrid random_grid(double resolution_m, unsigned seed) {
  CoverageGrid grid(kCutSquare, resolution_m);
  std::minstd_rand random(seed);
  for (std::uint32_t& word : grid.words()) {
    if ((word & CoverageGrid::kInArea) != 0 && random() % 3 != 0) {
      word |= static_cast<std::uint32_t>(1U + random() % 30U);
    }
  }
  return grid;
}

}  // namespace swathplan::test
