#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/seafloor.h"

namespace swathplan {

/// One use of an undirected edge by a face: corner `corner` of `face` begins it.
struct EdgeUse {
  std::uint32_t low, high;  ///< its vertices; the same for an edge from a vertex to itself
  std::uint32_t face;
  std::uint8_t corner;
  bool ascends;  ///< the face runs from low to high
};

/// All edge uses of a triangle mesh, three for each face, sorted by edge, then by face. Faces name
/// vertices below `vertices`. No faces give none. O(n) where few edges meet at a vertex, since only
/// those with the same lower vertex are sorted.
[[nodiscard]] std::vector<EdgeUse> edge_uses(const std::vector<Seafloor::Face>& faces,
                                             std::size_t vertices);

/// Calls `visit` once for each edge, with all its uses, in the order of the table.
template <class Visit>
void for_each_edge(const std::vector<EdgeUse>& uses, Visit visit) {
  for (std::size_t begin = 0; begin < uses.size();) {
    std::size_t end = begin + 1;
    while (end < uses.size() && uses[end].low == uses[begin].low &&
           uses[end].high == uses[begin].high) {
      ++end;
    }
    visit(std::span<const EdgeUse>(uses.data() + begin, end - begin));
    begin = end;
  }
}

}  // namespace swathplan
