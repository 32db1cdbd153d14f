#include "planners/nuc/mesh_choice.h"

#include <gtest/gtest.h>

#include "coverage/tracing/ray_scene.h"
#include "mesh/synthetic.h"
#include "planners/ends_after.h"
#include "planners/nuc/nuc.h"
#include "planners/test_site.h"

namespace swathplan {
namespace {

// Finer or turned: with so few faces the simulator finds better than the plain lattice.
TEST(MeshChoice, TheSimulatorChoosesAmongMeshesOfFewQuads) {
  TestSite site(saddle(), kSafeDepthM);
  PlanOptions o = row_options(0.25, 2);
  o.faces = FaceShape::quad;
  const Plan plain = plan_nuc(site.ground, o);
  const RayScene scene(site.seafloor, Nodata::wall);
  site.ground.scene = &scene;
  const Plan chosen = plan_nuc(site.ground, o);
  ASSERT_FALSE(chosen.notes.empty());
  EXPECT_NE(chosen.notes.back().find("of 12 meshes"), std::string::npos) << chosen.notes.back();
  EXPECT_NE(chosen.mesh.vertices, plain.mesh.vertices);
}

TEST(MeshChoice, ASearchThatIsEndedChoosesAmongTheMeshesTriedByThen) {
  TestSite site(saddle(), kSafeDepthM);
  const RayScene scene(site.seafloor, Nodata::wall);
  site.ground.scene = &scene;
  PlanOptions o = row_options(0.25, 2);
  o.faces = FaceShape::quad;
  test::EndsAfter watcher(3);
  o.watch = Watch(watcher);
  const Plan plan = plan_nuc(site.ground, o);
  EXPECT_EQ(watcher.count, 3U);
  EXPECT_EQ(plan.notes.back(),
            "search ended early: the best of the 3 meshes tried by then was kept");
  EXPECT_GT(plan.route.waypoints.size(), 10U);
}

}  // namespace
}  // namespace swathplan
