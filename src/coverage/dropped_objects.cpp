#include "coverage/dropped_objects.h"

#include <cmath>
#include <numbers>

namespace swathplan {
namespace {

constexpr double kSunk = 0.05;
constexpr int kAround = 24;  // facets of a round body: 1 cm off the circle at a metre's radius

// Adds a surface of rings of points, bottom ring first. Each end is closed by triangles around its
// centre.
void add_rings(Seafloor& mesh, const std::vector<std::vector<Vec3>>& rings) {
  const auto n = static_cast<std::uint32_t>(rings.front().size());
  const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const auto& ring : rings)
    mesh.vertices.insert(mesh.vertices.end(), ring.begin(), ring.end());
  const auto count = static_cast<std::uint32_t>(rings.size());
  for (std::uint32_t k = 0; k + 1 < count; ++k) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = base + k * n + i;
      const std::uint32_t b = base + k * n + (i + 1) % n;
      mesh.faces.push_back({a, b, b + n});
      mesh.faces.push_back({a, b + n, a + n});
    }
  }
  for (const std::uint32_t ring : {std::uint32_t{0}, count - 1}) {
    Vec3 centre = Vec3::Zero();
    for (const Vec3& p : rings[ring]) centre += p / n;
    const auto c = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back(centre);
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = base + ring * n + i;
      const std::uint32_t b = base + ring * n + (i + 1) % n;
      if (ring == 0) {
        mesh.faces.push_back({c, b, a});
      } else {
        mesh.faces.push_back({c, a, b});
      }
    }
  }
}

void add_sphere(Seafloor& mesh, const DroppedObject& o) {
  const double r = 0.5 * o.size_m;
  std::vector<std::vector<Vec3>> rings;
  const auto ring = [&](double radius, double height) {
    std::vector<Vec3> points;
    for (int i = 0; i < kAround; ++i) {
      const double a = 2.0 * std::numbers::pi * i / kAround;
      points.push_back(o.base + Vec3(radius * std::cos(a), radius * std::sin(a), height));
    }
    rings.push_back(std::move(points));
  };
  ring(r, -kSunk);
  constexpr int kUp = 6;
  for (int k = 0; k < kUp; ++k) {
    const double a = 0.5 * std::numbers::pi * k / kUp;
    ring(r * std::cos(a), r + r * std::sin(a));
  }
  add_rings(mesh, rings);
}

// Adds a prism along the heading. Its cross-section (across, up) is counter-clockwise as seen from
// the far end.
void add_prism(Seafloor& mesh, const DroppedObject& o, const std::vector<Vec2>& section) {
  const Vec3 along(sin(o.heading), cos(o.heading), 0.0);
  const Vec3 across(along.y(), -along.x(), 0.0);
  std::vector<std::vector<Vec3>> rings(2);
  for (int end = 0; end < 2; ++end) {
    for (const Vec2& p : section) {
      rings[static_cast<std::size_t>(end)].push_back(o.base + (end - 0.5) * o.length_m * along +
                                                     p.x() * across + Vec3(0, 0, p.y()));
    }
  }
  add_rings(mesh, rings);
}

std::vector<Vec2> cylinder_section(double diameter) {
  const double r = 0.5 * diameter;
  std::vector<Vec2> section{{-r, -kSunk}};
  for (int k = 0; k <= kAround / 2; ++k) {
    const double a = std::numbers::pi * (1.0 - 2.0 * k / kAround);
    section.emplace_back(r * std::cos(a), r + r * std::sin(a));
  }
  section.emplace_back(r, -kSunk);
  return section;
}

}  // namespace

Vec3 top(const DroppedObject& o) { return o.base + Vec3(0.0, 0.0, o.size_m); }

Seafloor with_objects(const Seafloor& seafloor, const std::vector<DroppedObject>& objects) {
  Seafloor mesh = seafloor;
  for (const DroppedObject& o : objects) {
    const double h = 0.5 * o.size_m;
    switch (o.shape) {
      case ObjectShape::sphere:
        add_sphere(mesh, o);
        break;
      case ObjectShape::cylinder:
        add_prism(mesh, o, cylinder_section(o.size_m));
        break;
      case ObjectShape::box:
        add_prism(mesh, o, {{-h, -kSunk}, {-h, o.size_m}, {h, o.size_m}, {h, -kSunk}});
        break;
    }
  }
  return mesh;
}

}  // namespace swathplan
