#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "io/charts/chart_mesh_internal.h"
#include "mesh/plane/box.h"

namespace swathplan {
namespace {

using ChartKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
constexpr std::uint32_t kNewPlace = 0xffffffffU;
constexpr int kOutside = -1, kNotVisited = -2;

struct PlaceInfo {
  std::uint32_t place = kNewPlace;
};
struct FaceInfo {
  int area = kNotVisited;
};
using ChartVertexBase = CGAL::Triangulation_vertex_base_with_info_2<PlaceInfo, ChartKernel>;
using ChartFaceBase = CGAL::Constrained_triangulation_face_base_2<
    ChartKernel, CGAL::Triangulation_face_base_with_info_2<FaceInfo, ChartKernel>>;
using ChartTds = CGAL::Triangulation_data_structure_2<ChartVertexBase, ChartFaceBase>;
/// Outlines of a sound chart do not cross; those of a damaged one get a corner where they do.
using ChartCdt =
    CGAL::Constrained_Delaunay_triangulation_2<ChartKernel, ChartTds, CGAL::Exact_predicates_tag>;

/// Depths that differ by less are the same, metres.
constexpr double kSameDepth = 1e-6;

/// The chart's places in the order of a curve that fills the plane, so that each is found near the
/// one before.
std::vector<std::pair<ChartKernel::Point_2, std::uint32_t>> spatial_order(
    const std::vector<Vec2>& places, const std::vector<bool>& used) {
  using Point = std::pair<ChartKernel::Point_2, std::uint32_t>;
  using Map = CGAL::First_of_pair_property_map<Point>;
  std::vector<Point> order;
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    if (used[i]) order.emplace_back(ChartKernel::Point_2(places[i].x(), places[i].y()), i);
  }
  CGAL::spatial_sort(order.begin(), order.end(),
                     CGAL::Spatial_sort_traits_adapter_2<ChartKernel, Map>());
  return order;
}

std::vector<bool> places_in_use(const ChartDepths& chart) {
  std::vector<bool> used(chart.places.size(), false);
  for (std::size_t i = 0; i < used.size(); ++i) {
    used[i] = chart.soundings[i].has_value() || chart.contours[i].has_value();
  }
  for (const DepthArea& area : chart.areas) {
    for (const auto& ring : area.rings) {
      for (const std::uint32_t place : ring) used[place] = true;
    }
  }
  return used;
}

void triangulate(const ChartDepths& chart, ChartCdt& cdt) {
  std::vector<ChartCdt::Vertex_handle> at(chart.places.size());
  ChartCdt::Face_handle hint;
  for (const auto& [point, i] : spatial_order(chart.places, places_in_use(chart))) {
    at[i] = cdt.insert(point, hint);
    if (at[i]->info().place == kNewPlace) at[i]->info().place = i;
    hint = at[i]->face();
  }
  for (const DepthArea& area : chart.areas) {
    for (const auto& ring : area.rings) {
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const auto a = at[ring[k]];
        const auto b = at[ring[(k + 1) % ring.size()]];
        if (a != b) cdt.insert_constraint(a, b);
      }
    }
  }
}

/// A depth area prepared for the question whether a point lies in it.
struct AreaOutline {
  const DepthArea* area = nullptr;
  Box2 box;
};

bool lies_in(const ChartDepths& chart, const AreaOutline& outline, const Vec2& p) {
  if ((p.array() < outline.box.min.array()).any() || (p.array() > outline.box.max.array()).any()) {
    return false;
  }
  bool inside = false;
  for (const auto& ring : outline.area->rings) {
    for (std::size_t k = 0, before = ring.size() - 1; k < ring.size(); before = k++) {
      const Vec2& a = chart.places[ring[k]];
      const Vec2& b = chart.places[ring[before]];
      if ((a.y() > p.y()) == (b.y() > p.y())) continue;
      if (p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y())) inside = !inside;
    }
  }
  return inside;
}

std::vector<AreaOutline> outlines_of(const ChartDepths& chart) {
  std::vector<AreaOutline> outlines;
  for (const DepthArea& area : chart.areas) {
    AreaOutline outline{&area, {}};
    for (const auto& ring : area.rings) {
      for (const std::uint32_t place : ring) outline.box.extend(chart.places[place]);
    }
    outlines.push_back(outline);
  }
  return outlines;
}

Vec2 middle_of(const ChartCdt::Face_handle& face) {
  Vec2 sum = Vec2::Zero();
  for (int i = 0; i < 3; ++i) {
    sum += Vec2(face->vertex(i)->point().x(), face->vertex(i)->point().y());
  }
  return sum / 3.0;
}

double area_of(const ChartCdt::Face_handle& face) {
  return CGAL::area(face->vertex(0)->point(), face->vertex(1)->point(), face->vertex(2)->point());
}

/// Gives each face its depth area, or kOutside. All faces between outlines share one, so one
/// question for each such part is enough; its largest face is the one to ask.
void find_areas(const ChartDepths& chart, ChartCdt& cdt) {
  const std::vector<AreaOutline> outlines = outlines_of(chart);
  for (const auto& start : cdt.finite_face_handles()) {
    if (start->info().area != kNotVisited) continue;
    std::vector<ChartCdt::Face_handle> part{start};
    start->info().area = kOutside;
    bool open = false;
    for (std::size_t i = 0; i < part.size(); ++i) {
      for (int k = 0; k < 3; ++k) {
        if (part[i]->is_constrained(k)) continue;
        const auto next = part[i]->neighbor(k);
        if (cdt.is_infinite(next)) {
          open = true;
        } else if (next->info().area == kNotVisited) {
          next->info().area = kOutside;
          part.push_back(next);
        }
      }
    }
    if (open) continue;
    const auto largest =
        *std::max_element(part.begin(), part.end(),
                          [](const auto& a, const auto& b) { return area_of(a) < area_of(b); });
    const Vec2 at = middle_of(largest);
    for (std::size_t a = 0; a < outlines.size(); ++a) {
      if (!lies_in(chart, outlines[a], at)) continue;
      for (const auto& face : part) face->info().area = static_cast<int>(a);
      break;
    }
  }
}

/// The depth at the outline of areas: see chart_mesh().
std::vector<double> depths_of_places(const ChartDepths& chart) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::vector<double> shoal(chart.places.size(), -kFar);
  std::vector<double> deep(chart.places.size(), kFar);
  for (const DepthArea& area : chart.areas) {
    for (const auto& ring : area.rings) {
      for (const std::uint32_t p : ring) {
        shoal[p] = std::max(shoal[p], area.shoal_m);
        deep[p] = std::min(deep[p], area.deep_m);
      }
    }
  }
  std::vector<double> depths(chart.places.size(), 0.0);
  for (std::size_t p = 0; p < depths.size(); ++p) {
    const double by_area = shoal[p] > -kFar ? std::min(shoal[p], deep[p]) : 0.0;
    depths[p] = chart.soundings[p].value_or(chart.contours[p].value_or(by_area));
  }
  return depths;
}

/// Where outlines cross: the shoalest of the neighbours.
void add_crossings(ChartCdt& cdt, ChartMesh& mesh) {
  for (const auto& vertex : cdt.finite_vertex_handles()) {
    if (vertex->info().place != kNewPlace) continue;
    double depth = std::numeric_limits<double>::infinity();
    auto around = cdt.incident_vertices(vertex);
    const auto done = around;
    do {
      if (!cdt.is_infinite(around) && around->info().place != kNewPlace) {
        depth = std::min(depth, mesh.depths[around->info().place]);
      }
    } while (++around != done);
    vertex->info().place = static_cast<std::uint32_t>(mesh.places.size());
    mesh.places.emplace_back(vertex->point().x(), vertex->point().y());
    mesh.depths.push_back(std::isfinite(depth) ? depth : 0.0);
  }
}

/// Which areas hold a sounding, and how many soundings lie in areas.
std::vector<bool> sounded_areas(const ChartDepths& chart, const ChartCdt& cdt, ChartMesh& mesh) {
  std::vector<bool> sounded(chart.areas.size(), false);
  std::vector<bool> used(chart.places.size(), false);
  for (const auto& face : cdt.finite_face_handles()) {
    if (face->info().area < 0) continue;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t place = face->vertex(k)->info().place;
      if (place >= chart.places.size() || !chart.soundings[place]) continue;
      sounded[static_cast<std::size_t>(face->info().area)] = true;
      used[place] = true;
    }
  }
  mesh.used_soundings = static_cast<std::size_t>(std::count(used.begin(), used.end(), true));
  mesh.areas_without_soundings =
      static_cast<std::size_t>(std::count(sounded.begin(), sounded.end(), false));
  return sounded;
}

/// True if the chart says no more of the face than that it is not deeper than the area's bound.
bool is_left_open(const DepthArea& area, const std::array<std::uint32_t, 3>& face,
                  const ChartMesh& mesh) {
  if (!std::isfinite(area.deep_m) || area.shoal_m >= area.deep_m) return false;
  return std::all_of(face.begin(), face.end(),
                     [&](std::uint32_t v) { return mesh.depths[v] >= area.deep_m - kSameDepth; });
}

void add_faces(const ChartDepths& chart, const ChartCdt& cdt, const std::vector<bool>& sounded,
               ChartMesh& mesh) {
  for (const auto& handle : cdt.finite_face_handles()) {
    if (handle->info().area < 0) continue;
    const auto a = static_cast<std::size_t>(handle->info().area);
    const std::array<std::uint32_t, 3> face{handle->vertex(0)->info().place,
                                            handle->vertex(1)->info().place,
                                            handle->vertex(2)->info().place};
    if (sounded[a] || !is_left_open(chart.areas[a], face, mesh)) {
      mesh.faces.push_back(face);
      continue;
    }
    const auto middle = static_cast<std::uint32_t>(mesh.places.size());
    mesh.places.push_back(middle_of(handle));
    mesh.depths.push_back(chart.areas[a].shoal_m);
    for (std::size_t k = 0; k < 3; ++k) {
      mesh.faces.push_back({face.at(k), face.at((k + 1) % 3), middle});
    }
  }
}

}  // namespace

ChartMesh chart_mesh(const ChartDepths& chart) {
  ChartCdt cdt;
  triangulate(chart, cdt);
  find_areas(chart, cdt);
  ChartMesh mesh;
  mesh.places = chart.places;
  mesh.depths = depths_of_places(chart);
  add_crossings(cdt, mesh);
  add_faces(chart, cdt, sounded_areas(chart, cdt, mesh), mesh);
  return mesh;
}

}  // namespace swathplan
