#pragma once

#include <cstddef>
#include <polyclipping/clipper.hpp>
#include <vector>

namespace swathplan {

/// Unites parts [from, to), each of one or more paths, in halves, and stores the union in `result`
/// (Paths or PolyTree). Each union meets outlines that are simple already. All at once, Clipper
/// would see every crossing of parts that hide one another, and its cost is quadratic in those.
template <class Result>
void unite_in_halves(const std::vector<ClipperLib::Paths>& parts, std::size_t from, std::size_t to,
                     Result& result) {
  constexpr std::size_t kAtOnce = 16;
  ClipperLib::Clipper clipper;
  if (to - from <= kAtOnce) {
    for (std::size_t k = from; k < to; ++k) {
      clipper.AddPaths(parts[k], ClipperLib::ptSubject, true);
    }
  } else {
    const std::size_t middle = from + (to - from) / 2;
    ClipperLib::Paths half;
    unite_in_halves(parts, from, middle, half);
    clipper.AddPaths(half, ClipperLib::ptSubject, true);
    unite_in_halves(parts, middle, to, half);
    clipper.AddPaths(half, ClipperLib::ptSubject, true);
  }
  clipper.Execute(ClipperLib::ctUnion, result, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
}

}  // namespace swathplan
