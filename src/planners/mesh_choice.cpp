#include "planners/mesh_choice.h"

#include <fmt/format.h>

#include <limits>

#include "coverage/score.h"

namespace swathplan {
namespace {

struct Candidate {
  double face_size;  ///< hypotenuse as a factor of W
  double turn_deg;
};

/// The plain mesh first: it stays where nothing is better.
constexpr double kFaceSizes[] = {1.00, 0.95, 0.87, 0.80};
constexpr double kTurns_deg[] = {0.0, 5.0, 10.0, 15.0, 20.0, 30.0, 45.0};

double worth(const Plan& plan, const PlanningGround& ground, const PlanOptions& options) {
  const ScoringGround scoring{ground.seafloor, ground.depths, ground.scene, ground.survey_area,
                              ground.water};
  ScoreOptions how;
  how.resolution_m = options.resolution_m;
  how.ping_spacing_m = options.ping_spacing_m;
  how.footprint = false;
  how.threads = options.threads;
  const Score score =
      swathplan::score(plan.route, scoring, options.sonar, options.vehicle, how).score;
  return score.all.hit_pct - kPointsPerRatio * score.route.length_ratio;
}

}  // namespace

Plan best_mesh_plan(const PlanningGround& ground, const PlanOptions& options,
                    const std::function<Plan(PlanarMesh)>& plan_on) {
  PlanarMesh plain = planning_mesh(ground, options);
  if (options.face_size || ground.scene == nullptr || plain.faces.size() > kFewFaces) {
    return plan_on(std::move(plain));
  }
  const Area area = reachable_area(ground);
  Plan best;
  Candidate chosen{};
  double best_worth = -std::numeric_limits<double>::infinity();
  for (const double face_size : kFaceSizes) {
    for (const double turn_deg : kTurns_deg) {
      Plan plan = plan_on(planar_mesh(area, {.hypotenuse_m = face_size * footprint_width_m(options),
                                             .turn = Angle::degrees(turn_deg)}));
      const double here = worth(plan, ground, options);
      if (here <= best_worth) continue;
      best_worth = here;
      chosen = {face_size, turn_deg};
      best = std::move(plan);
    }
  }
  best.notes.push_back(fmt::format(
      "few faces fit the area: of {} meshes the simulator chose faces of {:.2f} W, the lattice "
      "turned by {:.0f} degrees",
      std::size(kFaceSizes) * std::size(kTurns_deg), chosen.face_size, chosen.turn_deg));
  return best;
}

}  // namespace swathplan
