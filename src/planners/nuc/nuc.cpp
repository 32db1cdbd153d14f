#include "planners/nuc/nuc.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/plane/segments.h"
#include "mesh/plane/union_find.h"
#include "planners/nuc/mesh_choice.h"
#include "planners/nuc/skeleton_smoothing.h"

namespace swathplan {
namespace {

/// A path crosses an edge inside the half that both quads touch. It keeps this share of the edge
/// off the corner and off the midpoint.
constexpr double kCrossingMargin = 0.04;
/// If the straight way would miss that half, the path crosses the edge here: at this share of the
/// edge from the corner that both quads touch.
constexpr double kCrossingAt = 0.25;

/// An arc takes this share of the way that it could take, as measured on saddle, shaft and harbour.
/// Smaller arcs leave the outside of corners empty where cells are wide. Larger arcs cut off
/// corners, which pings a cell's width apart cannot fill.
constexpr double kCornerShare = 0.3;

/// The longest arc ends this share short of its limit, so that it stays in its face when rounded.
constexpr double kInside = 1.0 - 1e-6;

/// The facets' corners in one array: the sub-facet at corner k of face f is first[f] + k.
struct SubFacets {
  std::vector<std::uint32_t> first;
  std::vector<std::uint32_t> face;
  std::vector<std::uint32_t> vertex;  ///< the mesh vertex at the corner
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
    vertex.resize(count);
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
      const std::uint32_t k_after = k + 1 < n ? k + 1 : 0;
      const Vec2& here = mesh.vertices[corners[k]];
      const Vec2& after = mesh.vertices[corners[k_after]];
      const Vec2& before = mesh.vertices[corners[k > 0 ? k - 1 : n - 1]];
      const std::uint32_t i = first[f] + k;
      face[i] = f;
      vertex[i] = corners[k];
      centroid[i] = 0.25 * (here + 0.5 * (here + after) + 0.5 * (here + before) + centre);
      next[i] = first[f] + k_after;
    }
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

/// Where the way between two sub-facets crosses the edge that their faces share.
struct Crossing {
  double share = 0.5;          ///< of the way
  std::optional<Vec2> detour;  ///< point of the half-edge to go by, if the straight way misses it
};

Crossing crossing(const PlanarMesh& mesh, const SubFacets& sub, std::uint32_t i, std::uint32_t j) {
  const auto corners = [&](std::uint32_t s) {
    const std::uint32_t first = sub.first[sub.face[s]];
    const std::uint32_t end = sub.first[sub.face[s] + 1];
    return std::array<std::uint32_t, 3>{sub.vertex[s > first ? s - 1 : end - 1], sub.vertex[s],
                                        sub.vertex[s + 1 < end ? s + 1 : first]};
  };
  // Both quads touch the same vertex. Faces run counter-clockwise, so the other end of the shared
  // edge follows it in one face and comes before it in the other.
  const auto [i_before, shared, i_after] = corners(i);
  const auto [j_before, also_shared, j_after] = corners(j);
  const std::uint32_t other = i_after == j_before ? i_after : i_before;
  const Vec2& u = mesh.vertices[shared];
  const Vec2 along = mesh.vertices[other] - u;
  const Vec2& from = sub.centroid[i];
  const Vec2 way = sub.centroid[j] - from;
  const double denominator = cross(way, along);
  if (denominator != 0.0) {
    const double at_edge = cross(way, from - u) / denominator;
    if (at_edge >= kCrossingMargin && at_edge <= 0.5 - kCrossingMargin) {
      return {cross(u - from, along) / denominator, std::nullopt};
    }
  }
  return {0.5, u + kCrossingAt * along};
}

SkeletonCycle walk(const PlanarMesh& mesh, const SubFacets& sub, std::uint32_t start,
                   std::size_t sub_facets) {
  SkeletonCycle cycle;
  cycle.reserve(sub_facets + sub_facets / 16);  // few ways need a point on their edge
  std::uint32_t i = start;
  float behind = 0.0F;
  do {
    const std::uint32_t f = sub.face[i];
    const std::uint32_t j = sub.next[i];
    const auto length = static_cast<float>((sub.centroid[j] - sub.centroid[i]).norm());
    const auto corner = static_cast<std::uint16_t>(i - sub.first[f]);
    SkeletonPoint point{sub.centroid[i], f, corner, true, length, behind};
    behind = length;
    if (sub.face[j] == f) {
      cycle.push_back(point);
    } else {
      const Crossing over = crossing(mesh, sub, i, j);
      point.ahead_m = static_cast<float>(over.share) * length;
      behind = length - point.ahead_m;
      if (over.detour) {
        // The way leads over a point of the edge, and no arc may cut that corner.
        point.ahead_m = static_cast<float>((*over.detour - point.position).norm());
        behind = static_cast<float>((sub.centroid[j] - *over.detour).norm());
        cycle.push_back(point);
        cycle.push_back({*over.detour, f, corner, false, 0.0F, 0.0F});
      } else {
        cycle.push_back(point);
      }
    }
    i = j;
  } while (i != start);
  cycle.front().behind_m = behind;
  return cycle;
}

}  // namespace

namespace {

/// The length that a splice over an edge adds to the path: two links across it instead of one on
/// each side.
double splice_cost(const SharedEdge& e, const SubFacets& sub) {
  const auto size = [&](std::uint32_t f) { return sub.first[f + 1] - sub.first[f]; };
  const auto at = [&](int side, std::uint32_t step) {
    const std::uint32_t f = e.face[static_cast<std::size_t>(side)];
    const std::uint32_t k = e.edge[static_cast<std::size_t>(side)] + step;
    return sub.centroid[sub.first[f] + (k < size(f) ? k : k - size(f))];
  };
  const Vec2 a0 = at(0, 0), a1 = at(0, 1), b0 = at(1, 0), b1 = at(1, 1);
  return (a0 - b1).norm() + (a1 - b0).norm() - (a0 - a1).norm() - (b0 - b1).norm();
}

/// Edges in the order of their cost, cheapest first. The cost is rounded to kLevels steps, so that
/// a counting sort takes O(n). Edges of one step keep their order.
std::vector<std::uint32_t> by_cost(const std::vector<float>& cost, const std::vector<char>& open) {
  constexpr std::size_t kLevels = 4096;
  float low = std::numeric_limits<float>::infinity();
  float high = -low;
  for (const float c : cost) {
    low = std::min(low, c);
    high = std::max(high, c);
  }
  const float scale = high > low ? static_cast<float>(kLevels - 1) / (high - low) : 0.0F;
  const auto level = [&](std::size_t i) {
    return static_cast<std::size_t>((cost[i] - low) * scale);
  };
  std::vector<std::uint32_t> start(kLevels + 1, 0);
  for (std::size_t i = 0; i < cost.size(); ++i) ++start[level(i) + 1];
  for (std::size_t l = 1; l < start.size(); ++l) start[l] += start[l - 1];
  std::vector<std::uint32_t> order(cost.size());
  for (std::uint32_t i = 0; i < cost.size(); ++i) order[start[level(i)]++] = i;
  if (!open.empty()) std::erase_if(order, [&](std::uint32_t i) { return open[i] == 0; });
  return order;
}

}  // namespace

std::vector<SkeletonCycle> nuc_skeleton(const PlanarMesh& mesh,
                                        const std::vector<SharedEdge>& edges,
                                        const std::vector<char>& open) {
  SubFacets sub(mesh);
  std::vector<float> cost;
  cost.reserve(edges.size());
  for (const SharedEdge& e : edges) cost.push_back(static_cast<float>(splice_cost(e, sub)));
  UnionFind trees(mesh.faces.size());
  for (const std::uint32_t i : by_cost(cost, open)) {
    if (trees.join(edges[i].face[0], edges[i].face[1])) splice(edges[i], sub);
  }
  std::vector<std::uint32_t> sub_facets(mesh.faces.size(), 0);
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    sub_facets[trees.find(f)] += sub.first[f + 1] - sub.first[f];
  }
  std::vector<SkeletonCycle> cycles;
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    if (trees.find(f) == f) cycles.push_back(walk(mesh, sub, sub.first[f], sub_facets[f]));
  }
  return cycles;
}

std::vector<SkeletonPoint> rounded(const std::vector<SkeletonPoint>& p, double radius_m) {
  constexpr double kStraight = 1e-6;  // radians; a smaller corner needs no arc
  std::vector<SkeletonPoint> result;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (i == 0 || i + 1 == p.size() || !p[i].sub_facet) {
      result.push_back(p[i]);
      continue;
    }
    const Vec2 in = p[i].position - p[i - 1].position;
    const Vec2 out = p[i + 1].position - p[i].position;
    const double turn = turn_angle(in, out);
    const double most = kInside * std::min({0.5 * in.norm(), 0.5 * out.norm(), double{p[i].ahead_m},
                                            double{p[i].behind_m}});
    const double reach =
        std::max(kCornerShare * most, std::min(most, radius_m * std::tan(0.5 * std::abs(turn))));
    if (std::abs(turn) < kStraight || !(reach > 0.0)) {
      result.push_back(p[i]);
      continue;
    }
    // Arc from p - reach * in to p + reach * out; its radius follows from the turn.
    const double radius = reach / std::tan(0.5 * std::abs(turn));
    const Vec2 begin = p[i].position - reach * in.normalized();
    const Vec2 left(-in.normalized().y(), in.normalized().x());
    const double side = turn > 0.0 ? 1.0 : -1.0;
    const Vec2 centre = begin + side * radius * left;
    const auto parts =
        static_cast<int>(std::ceil(std::abs(turn) / Angle::degrees(kArcStepDeg).rad()));
    for (int k = 0; k <= parts; ++k) {
      const double angle = turn * k / parts;
      const double c = std::cos(angle);
      const double s = std::sin(angle);
      const Vec2 arm = begin - centre;
      SkeletonPoint point = p[i];
      point.position = centre + Vec2(c * arm.x() - s * arm.y(), s * arm.x() + c * arm.y());
      result.push_back(point);
    }
  }
  return result;
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

std::vector<SkeletonPoint> path_of(const SkeletonCycle& cycle,
                                   const std::vector<std::pair<Vec2, Vec2>>& blocked,
                                   const Ground& ground, const PlanOptions& options,
                                   SmoothResult& verdict, const FannedCover* cover) {
  if (options.smooth)
    return smoothed(cycle, blocked, ground.water, *options.smooth, verdict, cover);
  return rounded(cycle, (1.0 + kRadiusReserve) * options.vehicle.turn_radius_m);
}

std::string verdict_note(const SmoothResult& verdict) {
  std::string text = fmt::format("smoothing solved {} windows", verdict.windows);
  for (const auto& [status, count] : verdict.status) text += fmt::format(", {}: {}", status, count);
  if (verdict.failed_windows > 0) {
    text += fmt::format("; {:.0f} m of the skeleton stay as they were", verdict.failed_m);
  }
  return text;
}

}  // namespace

Route skeleton_route(const std::vector<SkeletonCycle>& cycles,
                     const std::vector<std::uint32_t>& region_of,
                     const std::vector<FanAngles>& fans, const Ground& ground,
                     const PlanOptions& options, const Connector& connector,
                     std::vector<std::string>& notes,
                     const std::vector<std::pair<Vec2, Vec2>>& blocked) {
  std::vector<SkeletonCycle> left = cycles;
  std::optional<Vec2> at = options.start;
  RouteBuilder builder(ground, options, connector);
  int line = 1;
  SmoothResult verdict;
  const auto fan_of = [&](std::uint32_t face) {
    return fans[region_of.empty() ? 0 : region_of[face]];
  };
  std::optional<ThinCover> cover;
  std::optional<FannedCover> fanned;
  if (options.smooth) {
    cover.emplace(*ground.depths, ground.survey_area, options);
    fanned.emplace(FannedCover{*cover, fan_of});
  }
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
    for (const SkeletonPoint& point :
         path_of(*pick, blocked, ground, options, verdict, fanned ? &*fanned : nullptr)) {
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
  Route route = builder.finish();
  for (const std::string& note : builder.notes()) notes.push_back(note);
  if (options.smooth) notes.push_back(verdict_note(verdict));
  return route;
}

Plan plan_nuc(const Ground& ground, const PlanOptions& options) {
  return best_mesh_plan(ground, options, [&](PlanarMesh mesh, const Connector& connector) {
    Plan plan;
    plan.mesh = std::move(mesh);
    plan.edges = shared_edges(plan.mesh);
    const DepthRegions whole =
        depth_regions(plan.mesh, plan.edges, *ground.depths, {.bands = {.count = 1, .limits = {}}});
    const FanAngles fan = fan_for_depth(options, mean_depth_m(whole));
    plan.openings = {fan.port + fan.starboard};
    plan.route = skeleton_route(nuc_skeleton(plan.mesh, plan.edges), {}, {fan}, ground, options,
                                connector, plan.notes);
    if (options.opening == Opening::ping) plan.route = opened_per_ping(plan.route, ground, options);
    return plan;
  });
}

}  // namespace swathplan
