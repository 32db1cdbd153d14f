#include "mesh/water_level.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <unordered_map>

namespace swathplan {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// Copies what stays and cuts what straddles, with one crossing point per mesh edge.
class LevelCutter {
 public:
  LevelCutter(const Seafloor& source, double level) : source_(source), level_(level) {
    result_.frame = source.frame;
    kept_.assign(source.vertices.size(), kNone);
    result_.vertices.reserve(source.vertices.size());
    result_.faces.reserve(source.faces.size());
  }

  void add(const Seafloor::Face& face) {
    const auto below = std::count_if(face.begin(), face.end(), [&](auto v) { return is_below(v); });
    const auto above = std::count_if(face.begin(), face.end(), [&](auto v) { return is_above(v); });
    // A face that only touches the level from above is land: it would be left without area.
    if (below == 0 && above > 0) return;
    std::array<std::uint32_t, 4> corners{};
    std::size_t n = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = face[i];
      const std::uint32_t b = face[(i + 1) % 3];
      if (z(a) <= level_) corners.at(n++) = keep(a);
      if ((is_below(a) && is_above(b)) || (is_above(a) && is_below(b))) {
        corners.at(n++) = crossing(a, b);
      }
    }
    for (std::size_t i = 2; i < n; ++i) append_face({corners[0], corners[i - 1], corners[i]});
  }

  [[nodiscard]] Seafloor take() { return std::move(result_); }

 private:
  [[nodiscard]] double z(std::uint32_t v) const { return source_.vertices[v].z(); }
  [[nodiscard]] bool is_below(std::uint32_t v) const { return z(v) < level_; }
  [[nodiscard]] bool is_above(std::uint32_t v) const { return z(v) > level_; }

  std::uint32_t append(const Vec3& p) {
    result_.vertices.push_back(p);
    return static_cast<std::uint32_t>(result_.vertices.size() - 1);
  }

  /// A crossing that rounds onto a corner leaves a face without area: nothing to keep.
  void append_face(const Seafloor::Face& f) {
    const Vec3& a = result_.vertices[f[0]];
    const Vec3 ab = result_.vertices[f[1]] - a;
    const Vec3 ac = result_.vertices[f[2]] - a;
    if (f[0] == f[1] || f[1] == f[2] || f[2] == f[0] || ab.cross(ac).isZero(0.0)) return;
    result_.faces.push_back(f);
  }

  std::uint32_t keep(std::uint32_t v) {
    if (kept_[v] == kNone) kept_[v] = append(source_.vertices[v]);
    return kept_[v];
  }

  std::uint32_t crossing(std::uint32_t a, std::uint32_t b) {
    // From the lower index to the higher, so that both faces of the edge get the same bits.
    if (a > b) std::swap(a, b);
    const auto [entry, is_new] =
        crossings_.try_emplace((static_cast<std::uint64_t>(a) << 32) | b, kNone);
    if (is_new) {
      const Vec3& p = source_.vertices[a];
      const Vec3& q = source_.vertices[b];
      const double t = (level_ - p.z()) / (q.z() - p.z());
      Vec3 cut = p + t * (q - p);
      cut.z() = level_;
      const std::uint32_t low = p.z() < q.z() ? a : b;
      const bool rounds_onto_low =
          cut.head<2>() == source_.vertices[low].head<2>() && p.head<2>() != q.head<2>();
      entry->second = rounds_onto_low ? keep(low) : append(cut);
    }
    return entry->second;
  }

  const Seafloor& source_;
  double level_;
  Seafloor result_;
  std::vector<std::uint32_t> kept_;
  std::unordered_map<std::uint64_t, std::uint32_t> crossings_;
};

}  // namespace

Seafloor below_level(const Seafloor& seafloor, double z) {
  LevelCutter cutter(seafloor, z);
  for (const Seafloor::Face& face : seafloor.faces) cutter.add(face);
  return cutter.take();
}

}  // namespace swathplan
