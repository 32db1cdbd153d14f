#include "planners/job/patch_test.h"

#include <gtest/gtest.h>

#include "planners/job/job_site.h"

namespace swathplan {
namespace {

const PatchTest& part(const PatchTestPlan& plan, const std::string& name) {
  for (const PatchTest& test : plan.tests) {
    if (test.name == name) return test;
  }
  throw std::runtime_error("no such part");
}

PatchTestPlan found_on(const JobSite& bench) {
  return patch_test(bench.site.ground, bench.how, bench.connector, 30);
}

TEST(PatchTest, OnFlatGroundOnlyRollHasAPlace) {
  const JobSite bench;
  const PatchTestPlan plan = found_on(bench);
  ASSERT_EQ(plan.tests.size(), 4U);
  const PatchTest& roll = part(plan, "roll");
  EXPECT_TRUE(roll.met());
  ASSERT_EQ(roll.passes.size(), 2U);
  EXPECT_EQ(roll.passes[0].first, roll.passes[1].second) << "one line, both ways";
  EXPECT_EQ(roll.passes[0].second, roll.passes[1].first);
  for (const char* name : {"latency", "pitch", "yaw"}) {
    EXPECT_TRUE(part(plan, name).lines.empty()) << name;
    EXPECT_FALSE(part(plan, name).met());
    EXPECT_FALSE(part(plan, name).reason.empty());
  }
}

TEST(PatchTest, OnASlopeLatencyPitchAndYawRunUpAndDownIt) {
  const JobSite bench(tilted(600, 400, 10, Angle::degrees(15)));
  const PatchTestPlan plan = found_on(bench);
  for (const char* name : {"latency", "pitch", "yaw"}) {
    const PatchTest& test = part(plan, name);
    EXPECT_TRUE(test.met()) << name;
    ASSERT_EQ(test.passes.size(), 2U);
    for (const auto& [from, to] : test.passes) {
      EXPECT_NEAR(from.y(), to.y(), 1e-6) << name << ": the slope falls to the east";
      EXPECT_TRUE(contains(bench.site.ground.water, from));
      EXPECT_TRUE(contains(bench.site.ground.water, to));
    }
  }
  const PatchTest& latency = part(plan, "latency");
  EXPECT_EQ(latency.passes[0], latency.passes[1]) << "the same way";
  EXPECT_EQ(latency.speeds_mps[1], 0.5 * latency.speeds_mps[0]);
  const PatchTest& pitch = part(plan, "pitch");
  EXPECT_EQ(pitch.passes[0].first, pitch.passes[1].second);
  EXPECT_EQ(pitch.speeds_mps[0], pitch.speeds_mps[1]);
  const PatchTest& yaw = part(plan, "yaw");
  const double apart = std::abs(yaw.passes[0].first.y() - yaw.passes[1].first.y());
  EXPECT_GT(apart, 2.0 * yaw.depth_m * std::tan(0.5)) << "outer beams";
  EXPECT_FALSE(part(plan, "roll").met()) << "no flat ground: its conditions say so";
}

TEST(PatchTest, AnObjectServesWhereThereIsNoSlope) {
  Seafloor floor = flat(600, 400, 20);
  for (Vec3& v : floor.vertices) {
    const double off = (v.head<2>() - Vec2(300, 200)).norm();
    v.z() += 3.0 * std::exp(-0.5 * off * off / 9.0);
  }
  const JobSite bench(std::move(floor));
  const PatchTestPlan plan = found_on(bench);
  const PatchTest& pitch = part(plan, "pitch");
  ASSERT_FALSE(pitch.passes.empty());
  EXPECT_TRUE(pitch.met());
  const auto& [from, to] = pitch.passes[0];
  const Vec2 course = (to - from).normalized();
  const Vec2 off = Vec2(300, 200) - from;
  EXPECT_LT(std::abs(off.x() * course.y() - off.y() * course.x()), 8.0) << "over the object";
  EXPECT_TRUE(part(plan, "roll").met());
}

TEST(PatchTest, PassesAreNumberedAndLogged) {
  const JobSite bench(tilted(600, 400, 10, Angle::degrees(15)));
  const PatchTestPlan plan = found_on(bench);
  int number = 30;
  for (const JobLine& line : plan.lines) {
    EXPECT_EQ(line.points[0].line, number++);
    EXPECT_EQ(line.points[0].kind, LegKind::patch);
    EXPECT_TRUE(line.points[0].log);
    EXPECT_TRUE(line.points[0].fan);
  }
}

}  // namespace
}  // namespace swathplan
