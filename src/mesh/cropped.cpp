#include "mesh/cropped.h"

namespace swathplan {

Seafloor cropped(const Seafloor& seafloor, const Box2& box) {
  constexpr std::uint32_t kUnused = 0xffffffffU;
  std::vector<std::uint32_t> index(seafloor.vertices.size(), kUnused);
  Seafloor part;
  part.frame = seafloor.frame;
  for (const Seafloor::Face& face : seafloor.faces) {
    Box2 around;
    for (const std::uint32_t v : face) around.extend(seafloor.vertices[v].head<2>());
    if ((around.min.array() > box.max.array()).any() ||
        (around.max.array() < box.min.array()).any()) {
      continue;
    }
    for (const std::uint32_t v : face) index[v] = 0;
    part.faces.push_back(face);
  }
  for (std::size_t v = 0; v < index.size(); ++v) {
    if (index[v] == kUnused) continue;
    index[v] = static_cast<std::uint32_t>(part.vertices.size());
    part.vertices.push_back(seafloor.vertices[v]);
  }
  for (Seafloor::Face& face : part.faces) {
    for (std::uint32_t& v : face) v = index[v];
  }
  return part;
}

}  // namespace swathplan
