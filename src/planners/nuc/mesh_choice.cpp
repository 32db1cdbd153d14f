#include "planners/nuc/mesh_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "planners/simulated.h"
#include "planners/wording.h"

namespace swathplan {
namespace {

/// Face sizes that are tried, as shares of W.
constexpr std::array kTriangleSizes = {1.00, 0.95, 0.87, 0.80};
constexpr std::array kQuadSizes = {kQuadSize, 0.60, 0.50};

constexpr std::array kTriangleTurns_deg = {0.0, 5.0, 10.0, 15.0, 20.0, 30.0, 45.0};
constexpr std::array kQuadTurns_deg = {0.0, 30.0, 60.0, 90.0};

struct Candidate {
  double face_size;
  double turn_deg;
  Plan plan;
  Outcome outcome;
};

/// The plain lattice comes first, so that it stays where nothing is better. A quarter turn of quads
/// gives the same lattice, but the path's long runs then go the other way.
std::vector<Candidate> candidates(FaceShape faces) {
  std::vector<Candidate> result;
  const auto add = [&](const auto& sizes, const auto& turns_deg) {
    for (const double size : sizes) {
      for (const double turn : turns_deg) result.push_back({size, turn, {}, {}});
    }
  };
  if (faces == FaceShape::quad) {
    add(kQuadSizes, kQuadTurns_deg);
  } else {
    add(kTriangleSizes, kTriangleTurns_deg);
  }
  return result;
}

/// Points of coverage that one more ideal length must bring.
double points_per_ratio(const std::vector<Candidate>& tried) {
  std::vector<double> missed;
  missed.reserve(tried.size());
  for (const Candidate& c : tried) missed.push_back(100.0 - c.outcome.cover_pct);
  const auto good = missed.begin() + static_cast<std::ptrdiff_t>(missed.size() / 4);
  std::nth_element(missed.begin(), good, missed.end());
  return kMissedPerRatio * *good;
}

}  // namespace

Plan best_mesh_plan(const Ground& ground, const PlanOptions& options,
                    const std::function<Plan(PlanarMesh, const Connector&)>& plan_on) {
  PlanarMesh plain = planning_mesh(ground, options);
  const Connector connector = connector_for(ground, options);
  if (options.face_size || ground.scene == nullptr || plain.faces.size() > kFewFaces) {
    return plan_on(std::move(plain), connector);
  }
  const Area area = reachable_area(ground);
  std::vector<Candidate> tried = candidates(options.faces);
  std::size_t done = 0;
  std::string best_so_far;
  double most_pct = -1.0;
  options.watch.phase("trying meshes");
  for (Candidate& c : tried) {
    if (done > 0 && options.watch.ended()) break;
    c.plan =
        plan_on(mesh_of(area, options, c.face_size * lane_m(options), Angle::degrees(c.turn_deg)),
                connector);
    c.outcome = simulated_hits(c.plan.route, ground, options);
    if (c.outcome.cover_pct > most_pct) {
      most_pct = c.outcome.cover_pct;
      best_so_far = brief(c.outcome);
    }
    options.watch.tried(++done, tried.size(), best_so_far);
  }
  const bool ended = done < tried.size();
  tried.resize(done);
  const double price = points_per_ratio(tried);
  const auto worth = [&](const Candidate& c) {
    return c.outcome.cover_pct - price * c.outcome.length_ratio;
  };
  const auto best =
      std::max_element(tried.begin(), tried.end(),
                       [&](const Candidate& a, const Candidate& b) { return worth(a) < worth(b); });
  best->plan.notes.push_back(fmt::format(
      "few faces fit into the area, so their place matters: of {} meshes the simulator chose the "
      "one with faces of {:.2f} {} and its lattice turned by {:.0f} degrees",
      tried.size(), best->face_size, options.lane_width_m ? "lanes" : "W", best->turn_deg));
  if (ended) best->plan.notes.push_back(ended_early_note(done, "mesh", "meshes"));
  return std::move(best->plan);
}

}  // namespace swathplan
