#include "io/mosaic/zipped.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "mesh/border_edges.h"
#include "mesh/plane/area_query.h"
#include "mesh/survey_area.h"

namespace swathplan {
namespace {

using ZipKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
constexpr std::uint32_t kNoVertex = 0xffffffffU;
struct ZipInfo {
  std::uint32_t vertex = kNoVertex;
};
using ZipVertexBase = CGAL::Triangulation_vertex_base_with_info_2<ZipInfo, ZipKernel>;
using ZipTds =
    CGAL::Triangulation_data_structure_2<ZipVertexBase,
                                         CGAL::Constrained_triangulation_face_base_2<ZipKernel>>;
using ZipCdt =
    CGAL::Constrained_Delaunay_triangulation_2<ZipKernel, ZipTds, CGAL::Exact_predicates_tag>;

/// A vertex of the lower surface nearer to the upper one than this share of the bridge would make
/// needles beside it.
constexpr double kRoomShare = 0.1;

/// The work on two surfaces. Vertices of the lower one follow those of the upper one.
class Zipper {
 public:
  Zipper(const Seafloor& upper, const Seafloor& lower, double bridge_m)
      : upper_(upper),
        lower_(lower),
        bridge_m_(bridge_m),
        first_lower_(static_cast<std::uint32_t>(upper.vertices.size())),
        in_upper_(outline(upper)),
        lower_depths_(lower) {}

  Zipped join() {
    keep_clear_faces();
    insert_borders();
    insert_free_vertices();
    all_.frame = upper_.frame;
    all_.vertices = upper_.vertices;
    all_.vertices.insert(all_.vertices.end(), lower_.vertices.begin(), lower_.vertices.end());
    all_.faces = upper_.faces;
    for (const Seafloor::Face& f : kept_.faces) {
      all_.faces.push_back({f[0] + first_lower_, f[1] + first_lower_, f[2] + first_lower_});
    }
    fill();
    Zipped result;
    result.steps_m = steps();
    result.upper_m2 = plan_area_m2(upper_);
    drop_unused();
    result.lower_m2 = plan_area_m2(all_) - result.upper_m2;
    result.seafloor = std::move(all_);
    return result;
  }

 private:
  [[nodiscard]] Vec2 place(std::uint32_t v) const {
    return (v < first_lower_ ? upper_.vertices[v] : lower_.vertices[v - first_lower_]).head<2>();
  }

  [[nodiscard]] bool is_clear(const Seafloor::Face& face) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2 a = lower_.vertices[face.at(k)].head<2>();
      const Vec2 b = lower_.vertices[face.at((k + 1) % 3)].head<2>();
      if (in_upper_.contains(a) || in_upper_.inside_length(a, b) > 0.0) return false;
    }
    return true;
  }

  void keep_clear_faces() {
    upper_border_ = border_edges(upper_);
    // A face around a small piece of the upper surface meets it with none of its edges.
    std::vector<bool> covers(lower_.faces.size(), false);
    for (const auto& edge : upper_border_) {
      const auto face = lower_depths_.face(upper_.vertices[edge[0]].head<2>());
      if (face) covers[*face] = true;
    }
    kept_.frame = lower_.frame;
    kept_.vertices = lower_.vertices;
    is_kept_.assign(lower_.vertices.size(), false);
    for (std::size_t f = 0; f < lower_.faces.size(); ++f) {
      if (covers[f] || !is_clear(lower_.faces[f])) continue;
      kept_.faces.push_back(lower_.faces[f]);
      for (const std::uint32_t v : lower_.faces[f]) is_kept_[v] = true;
    }
  }

  ZipCdt::Vertex_handle insert(std::uint32_t v) {
    const Vec2 p = place(v);
    const auto handle = cdt_.insert(ZipKernel::Point_2(p.x(), p.y()), hint_);
    if (handle->info().vertex == kNoVertex) handle->info().vertex = v;
    hint_ = handle->face();
    return handle;
  }

  void insert_borders() {
    const auto add = [&](const std::vector<std::array<std::uint32_t, 2>>& edges,
                         std::uint32_t first) {
      for (const auto& edge : edges) {
        const auto a = insert(edge[0] + first);
        const auto b = insert(edge[1] + first);
        if (a != b) cdt_.insert_constraint(a, b);
      }
    };
    add(upper_border_, 0);
    add(border_edges(kept_), first_lower_);
  }

  /// Vertices of the lower surface in the strip that its dropped faces leave.
  void insert_free_vertices() {
    for (std::uint32_t v = 0; v < lower_.vertices.size(); ++v) {
      const Vec2 p = lower_.vertices[v].head<2>();
      if (is_kept_[v] || in_upper_.contains(p)) continue;
      if (in_upper_.distance(p) < kRoomShare * bridge_m_) continue;
      insert(v + first_lower_);
    }
  }

  void fill() {
    const AreaQuery in_kept(outline(kept_));
    for (const auto& face : cdt_.finite_face_handles()) {
      Seafloor::Face f{};
      Vec2 middle = Vec2::Zero();
      double longest = 0.0;
      bool known = true;
      for (int k = 0; k < 3; ++k) {
        f.at(static_cast<std::size_t>(k)) = face->vertex(k)->info().vertex;
        known = known && face->vertex(k)->info().vertex != kNoVertex;
      }
      if (!known) continue;
      bool of_upper = false;
      bool of_lower = false;
      for (std::size_t k = 0; k < 3; ++k) {
        middle += place(f.at(k)) / 3.0;
        longest = std::max(longest, (place(f.at(k)) - place(f.at((k + 1) % 3))).norm());
        (f.at(k) < first_lower_ ? of_upper : of_lower) = true;
      }
      if (in_upper_.contains(middle) || in_kept.contains(middle)) continue;
      const bool bridges = of_upper && of_lower && longest <= bridge_m_;
      if (bridges || lower_depths_.depth(middle)) all_.faces.push_back(f);
    }
  }

  [[nodiscard]] std::vector<double> steps() const {
    std::vector<double> steps;
    for (const auto& edge : upper_border_) {
      const Vec3& v = upper_.vertices[edge[0]];
      if (const auto depth = lower_depths_.depth(v.head<2>())) steps.push_back(*depth + v.z());
    }
    return steps;
  }

  void drop_unused() {
    std::vector<std::uint32_t> index(all_.vertices.size(), kNoVertex);
    for (const auto& f : all_.faces) {
      for (const std::uint32_t v : f) index[v] = 0;
    }
    std::uint32_t kept = 0;
    for (std::size_t v = 0; v < index.size(); ++v) {
      if (index[v] == kNoVertex) continue;
      all_.vertices[kept] = all_.vertices[v];
      index[v] = kept++;
    }
    all_.vertices.resize(kept);
    for (auto& f : all_.faces) {
      for (std::uint32_t& v : f) v = index[v];
    }
  }

  const Seafloor& upper_;
  const Seafloor& lower_;
  double bridge_m_;
  std::uint32_t first_lower_;
  AreaQuery in_upper_;
  DepthQuery lower_depths_;
  std::vector<std::array<std::uint32_t, 2>> upper_border_;
  Seafloor kept_;
  std::vector<bool> is_kept_;
  ZipCdt cdt_;
  ZipCdt::Face_handle hint_;
  Seafloor all_;
};

}  // namespace

Zipped zipped(const Seafloor& upper, const Seafloor& lower, double bridge_m) {
  return Zipper(upper, lower, bridge_m).join();
}

}  // namespace swathplan
