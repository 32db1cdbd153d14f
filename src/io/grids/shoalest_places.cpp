#include "io/grids/shoalest_places.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <tuple>

namespace swathplan {

void keep_shoalest_places(SurfaceData& points, bool z_down) {
  std::vector<Vec3>& vertices = points.vertices;
  std::vector<std::uint32_t> order(vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [&](std::uint32_t i) {
    const Vec3& v = vertices[i];
    return std::tuple(v.x(), v.y(), z_down ? v.z() : -v.z(), i);
  };
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return key(a) < key(b); });
  std::vector<bool> keep(vertices.size(), false);
  for (std::size_t i = 0; i < order.size(); ++i) {
    keep[order[i]] = i == 0 || vertices[order[i]].head<2>() != vertices[order[i - 1]].head<2>();
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (keep[i]) vertices[kept++] = vertices[i];
  }
  if (kept < vertices.size()) {
    points.notes.push_back(
        fmt::format("{} soundings lie at the same place as another: the shoalest was kept",
                    vertices.size() - kept));
  }
  vertices.resize(kept);
}

}  // namespace swathplan
