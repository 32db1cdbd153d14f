#include "planners/nuc.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "planners/water_path.h"

namespace swathplan {
namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFFU;

/// Where on an edge (0 at the corner that both quads touch, 1 at the other) a path may cross it:
/// inside their half, off the corner and off the midpoint by this much.
constexpr double kCrossingMargin = 0.04;
/// ... and where it is led across when the straight way would miss that half.
constexpr double kCrossingAt = 0.25;

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The facets' corners in one array: the sub-facet at corner k of face f is first[f] + k.
struct SubFacets {
  std::vector<std::uint32_t> first;
  std::vector<std::uint32_t> face;
  std::vector<Vec2> centroid;
  std::vector<std::uint32_t> next;

  explicit SubFacets(const PlanarMesh& mesh) {
    first.reserve(mesh.faces.size() + 1);
    std::uint32_t count = 0;
    for (const auto& f : mesh.faces) {
      first.push_back(count);
      count += static_cast<std::uint32_t>(f.size());
    }
    first.push_back(count);
    face.resize(count);
    centroid.resize(count);
    next.resize(count);
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) add_face(mesh, f);
  }

 private:
  /// Cuts the face into its quads and links their centroids into a cycle, counter-clockwise.
  void add_face(const PlanarMesh& mesh, std::uint32_t f) {
    const auto& corners = mesh.faces[f];
    const auto n = static_cast<std::uint32_t>(corners.size());
    const Vec2 centre = face_centroid(mesh, f);
    for (std::uint32_t k = 0; k < n; ++k) {
      const Vec2& here = mesh.vertices[corners[k]];
      const Vec2& after = mesh.vertices[corners[(k + 1) % n]];
      const Vec2& before = mesh.vertices[corners[(k + n - 1) % n]];
      const std::uint32_t i = first[f] + k;
      face[i] = f;
      centroid[i] = 0.25 * (here + 0.5 * (here + after) + 0.5 * (here + before) + centre);
      next[i] = first[f] + (k + 1) % n;
    }
  }
};

/// Shared edges around each face, as index ranges into one array.
struct FaceEdges {
  std::vector<std::uint32_t> start, items;

  FaceEdges(std::size_t faces, const std::vector<SharedEdge>& edges, const std::vector<char>& open)
      : start(faces + 1, 0) {
    const auto each = [&](auto&& visit) {
      for (std::uint32_t i = 0; i < edges.size(); ++i) {
        if (!open.empty() && open[i] == 0) continue;
        visit(edges[i].face[0], i);
        visit(edges[i].face[1], i);
      }
    };
    each([&](std::uint32_t f, std::uint32_t) { ++start[f + 1]; });
    for (std::size_t f = 1; f < start.size(); ++f) start[f] += start[f - 1];
    items.resize(start.back());
    std::vector<std::uint32_t> at(start.begin(), start.end() - 1);
    each([&](std::uint32_t f, std::uint32_t i) { items[at[f]++] = i; });
  }
};

/// Splices the cycles of the two faces of an edge together: leaves the first face at the corner
/// where the edge begins, walks the second face's cycle, and returns at the corner where it ends.
void splice(const SharedEdge& e, SubFacets& sub) {
  const auto size = [&](std::uint32_t f) { return sub.first[f + 1] - sub.first[f]; };
  const std::uint32_t a = e.face[0];
  const std::uint32_t b = e.face[1];
  const std::uint32_t a_begin = sub.first[a] + e.edge[0];
  const std::uint32_t a_end = sub.first[a] + (e.edge[0] + 1) % size(a);
  const std::uint32_t b_begin = sub.first[b] + e.edge[1];                // touches a_end
  const std::uint32_t b_end = sub.first[b] + (e.edge[1] + 1) % size(b);  // touches a_begin
  sub.next[a_begin] = b_end;
  sub.next[b_begin] = a_end;
}

/// The point on the shared edge of two sub-facets through which the way must be led, if the
/// straight one misses the half-edge that they share.
std::optional<Vec2> crossing_point(const PlanarMesh& mesh, const SubFacets& sub, std::uint32_t i,
                                   std::uint32_t j) {
  const std::uint32_t f = sub.face[i];
  const std::uint32_t g = sub.face[j];
  if (f == g) return std::nullopt;
  const auto corner = [&](std::uint32_t s) {
    return mesh.faces[sub.face[s]][s - sub.first[sub.face[s]]];
  };
  // Both quads touch the same vertex; the other end of the edge is next to it in both faces.
  const std::uint32_t shared = corner(i);
  const auto neighbours = [&](std::uint32_t s) {
    const auto& face = mesh.faces[sub.face[s]];
    const auto n = static_cast<std::uint32_t>(face.size());
    const std::uint32_t k = s - sub.first[sub.face[s]];
    return std::array<std::uint32_t, 2>{face[(k + n - 1) % n], face[(k + 1) % n]};
  };
  // Counter-clockwise walks: the path leaves f over the edge that begins at the corner, or comes
  // back over the one that ends there; in g it is the other way round.
  const auto [f_before, f_after] = neighbours(i);
  const auto [g_before, g_after] = neighbours(j);
  const std::uint32_t other = f_after == g_before ? f_after : f_before;
  const Vec2& u = mesh.vertices[shared];
  const Vec2 along = mesh.vertices[other] - u;
  const Vec2& from = sub.centroid[i];
  const Vec2 way = sub.centroid[j] - from;
  const double denominator = cross(way, along);
  if (denominator != 0.0) {
    const double t = cross(way, from - u) / cross(way, along);
    if (t >= kCrossingMargin && t <= 0.5 - kCrossingMargin) return std::nullopt;
  }
  return u + kCrossingAt * along;
}

SkeletonCycle walk(const PlanarMesh& mesh, const SubFacets& sub, std::uint32_t start) {
  SkeletonCycle cycle;
  std::uint32_t i = start;
  do {
    const std::uint32_t f = sub.face[i];
    cycle.push_back({sub.centroid[i], f, i - sub.first[f], true});
    const std::uint32_t j = sub.next[i];
    if (const auto p = crossing_point(mesh, sub, i, j))
      cycle.push_back({*p, f, i - sub.first[f], false});
    i = j;
  } while (i != start);
  return cycle;
}

}  // namespace

std::vector<SkeletonCycle> nuc_skeleton(const PlanarMesh& mesh,
                                        const std::vector<SharedEdge>& edges,
                                        const std::vector<char>& open) {
  SubFacets sub(mesh);
  const FaceEdges around(mesh.faces.size(), edges, open);
  std::vector<char> seen(mesh.faces.size(), 0);
  std::vector<std::uint32_t> queue;
  std::vector<std::uint32_t> roots;
  queue.reserve(mesh.faces.size());
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    if (seen[f] != 0) continue;
    roots.push_back(f);
    seen[f] = 1;
    std::size_t head = queue.size();
    queue.push_back(f);
    for (; head < queue.size(); ++head) {
      const std::uint32_t here = queue[head];
      for (std::uint32_t k = around.start[here]; k < around.start[here + 1]; ++k) {
        const SharedEdge& e = edges[around.items[k]];
        const std::uint32_t there = e.face[0] == here ? e.face[1] : e.face[0];
        if (seen[there] != 0) continue;
        seen[there] = 1;
        queue.push_back(there);
        splice(e, sub);
      }
    }
  }
  std::vector<SkeletonCycle> cycles;
  for (const std::uint32_t f : roots) cycles.push_back(walk(mesh, sub, sub.first[f]));
  return cycles;
}

namespace {

/// Turns the cycle so that it begins at the sub-facet nearest to `p`.
void begin_near(SkeletonCycle& cycle, const Vec2& p) {
  auto best = cycle.begin();
  for (auto it = cycle.begin(); it != cycle.end(); ++it) {
    if (!it->sub_facet) continue;
    if (!best->sub_facet || (it->position - p).squaredNorm() < (best->position - p).squaredNorm()) {
      best = it;
    }
  }
  std::rotate(cycle.begin(), best, cycle.end());
  // The link back to the beginning is not sailed, so a point on its edge would be a dead end.
  while (!cycle.empty() && !cycle.back().sub_facet) cycle.pop_back();
}

double nearest(const SkeletonCycle& cycle, const Vec2& p) {
  double best = std::numeric_limits<double>::infinity();
  for (const SkeletonPoint& point : cycle)
    best = std::min(best, (point.position - p).squaredNorm());
  return best;
}

}  // namespace

Route skeleton_route(const std::vector<SkeletonCycle>& cycles,
                     const std::vector<std::uint32_t>& region_of,
                     const std::vector<FanAngles>& fans, const PlanningGround& ground,
                     const PlanOptions& options, std::vector<std::string>& notes) {
  std::vector<SkeletonCycle> left = cycles;
  std::optional<Vec2> at = options.start;
  RouteBuilder builder(ground, options);
  int line = 1;
  while (!left.empty()) {
    auto pick = left.begin();
    if (at) {
      pick = std::min_element(left.begin(), left.end(), [&](const auto& a, const auto& b) {
        return nearest(a, *at) < nearest(b, *at);
      });
      begin_near(*pick, *at);
    } else {
      begin_near(*pick, pick->front().position);
    }
    std::vector<Waypoint> points;
    points.reserve(pick->size());
    for (const SkeletonPoint& point : *pick) {
      Waypoint w;
      w.position = point.position;
      w.line = line;
      w.speed_mps = options.vehicle.speed_mps;
      const std::uint32_t region = region_of.empty() ? 0 : region_of[point.face];
      w.fan = fans[region];
      if (!region_of.empty()) w.region = static_cast<int>(region);
      points.push_back(w);
    }
    at = pick->back().position;
    builder.add_line(points);
    left.erase(pick);
    ++line;
  }
  for (const std::string& note : builder.notes()) notes.push_back(note);
  return builder.finish();
}

Plan plan_nuc(const PlanningGround& ground, const PlanOptions& options) {
  Plan plan;
  plan.mesh = planning_mesh(ground, options);
  plan.edges = shared_edges(plan.mesh);
  const DepthRegions whole =
      depth_regions(plan.mesh, plan.edges, *ground.depths, {.bands = {.count = 1, .limits = {}}});
  const FanAngles fan = fan_for_depth(options, mean_depth_m(whole));
  plan.openings = {fan.port + fan.starboard};
  plan.route =
      skeleton_route(nuc_skeleton(plan.mesh, plan.edges), {}, {fan}, ground, options, plan.notes);
  if (options.opening == Opening::ping) plan.route = opened_per_ping(plan.route, ground, options);
  return plan;
}

}  // namespace swathplan
