#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "coverage/route/sonar.h"
#include "coverage/route/vehicle.h"
#include "coverage/route/violations.h"
#include "io/results/provenance.h"
#include "mesh/planar/gates.h"
#include "planners/pareto.h"

namespace swathplan {

/// A depth region as a plan used it; its id is its place in PlanFacts::regions.
struct PlanRegion {
  int band = 0;
  std::size_t faces = 0;
  double area_m2 = 0.0;
  double min_depth_m = 0.0, mean_depth_m = 0.0, max_depth_m = 0.0;
  FanAngles fan;  ///< half-angles at the region's mean depth
};

/// A gate as a plan used it; local metres.
struct PlanGate {
  std::pair<Vec2, Vec2> edge;
  std::uint32_t region_a = 0, region_b = 0;
  Angle slope;
};

/// A stretch that must not be sailed as it is drawn.
struct PlanViolation {
  Violation violation;
  std::string leg;  ///< kind of the leg that it begins in
  std::string reason;
};
[[nodiscard]] std::vector<PlanViolation> plan_violations(const Route& route, const Vehicle& vehicle,
                                                         const Area& water);

/// What a planner decided before it laid its path.
struct PlanFacts {
  std::string planner;
  std::vector<double> band_limits_m;
  std::vector<PlanRegion> regions;
  std::vector<PlanGate> gates;
  std::vector<std::pair<Vec2, Vec2>> blocked_edges;  ///< local metres
  Sonar sonar;
  Vehicle vehicle;
  std::vector<Outcome> choices;  ///< that the planner had, and which it took and why
  std::size_t chosen = 0;
  std::string chosen_why;
  std::vector<PlanViolation> violations;
  std::vector<std::string> notes;
};

/// The facts of a partition; `fans[i]` belongs to regions.regions[i].
[[nodiscard]] PlanFacts plan_facts(const std::string& planner, const PlanarMesh& mesh,
                                   const std::vector<SharedEdge>& edges,
                                   const DepthRegions& regions, const Gates& gates,
                                   const std::vector<FanAngles>& fans);

/// Provenance and facts; coordinates are those of the input file.
[[nodiscard]] std::string plan_json(const PlanFacts& facts, const Frame& frame,
                                    const Provenance& provenance);

/// Writes it to a file.
/// @throws InvalidInput if the file cannot be written.
void write_plan_json(const std::filesystem::path& path, const PlanFacts& facts, const Frame& frame,
                     const Provenance& provenance);

}  // namespace swathplan
