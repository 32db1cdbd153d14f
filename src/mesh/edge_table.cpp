#include "mesh/edge_table.h"

#include <algorithm>

namespace swathplan {

std::vector<EdgeUse> edge_uses(const std::vector<Seafloor::Face>& faces, std::size_t vertices) {
  std::vector<std::size_t> begin(vertices + 1, 0);
  for (const Seafloor::Face& face : faces) {
    for (std::size_t i = 0; i < 3; ++i) ++begin[std::min(face[i], face[(i + 1) % 3]) + 1];
  }
  for (std::size_t v = 0; v < vertices; ++v) begin[v + 1] += begin[v];
  std::vector<EdgeUse> uses(3 * faces.size());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    for (std::uint8_t i = 0; i < 3; ++i) {
      const std::uint32_t a = faces[f][i];
      const std::uint32_t b = faces[f][(i + 1U) % 3U];
      uses[next[std::min(a, b)]++] = {std::min(a, b), std::max(a, b), f, i, a < b};
    }
  }
  for (std::size_t v = 0; v < vertices; ++v) {
    std::sort(uses.begin() + static_cast<std::ptrdiff_t>(begin[v]),
              uses.begin() + static_cast<std::ptrdiff_t>(begin[v + 1]),
              [](const EdgeUse& a, const EdgeUse& b) {
                return a.high != b.high ? a.high < b.high : a.face < b.face;
              });
  }
  return uses;
}

}  // namespace swathplan
