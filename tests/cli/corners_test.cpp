// Corners that cannot be sailed as drawn: said of given routes, left by no planner.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/program.h"

namespace swathplan {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Corners, AGivenRouteIsToldHowManyItHas) {
  const test::Folder folder;
  ASSERT_EQ(folder.run("synth flat --width 140 --height 140 -o flat.asc").code, 0);
  const auto scored = [&](const std::string& route) {
    folder.write("route.csv", route);
    const auto run = folder.run(
        "score flat.asc route.csv --vehicle small-usv --resolution 2 "
        "--hit-only -o out");
    EXPECT_EQ(run.code, 0) << run.err;
    const auto score = test::json_of(folder / "out" / "score.json");
    return std::pair(run.err, score);
  };
  const auto [told, score] = scored("x,y\n20,20\n80,20\n80,80\n120,120\n");
  EXPECT_EQ(score.at("sharp_corners"), 2);
  EXPECT_EQ(score.at("min_turn_radius_m"), 0.0);
  EXPECT_THAT(told, HasSubstr("2 corners that cannot be sailed as drawn"));
  const auto [gentle, none] = scored("x,y\n20,20\n80,20\n120,25\n");
  EXPECT_EQ(none.at("sharp_corners"), 0);
  EXPECT_THAT(gentle, Not(HasSubstr("corner")));
}

TEST(Speeds, AGivenRouteIsToldWhichLegIsFasterThanTheVehicle) {
  const test::Folder folder;
  ASSERT_EQ(folder.run("synth flat --width 140 --height 140 -o flat.asc").code, 0);
  const auto told = [&](const std::string& fastest) {
    folder.write("route.csv", "x_m,y_m,kind,log,line,speed_mps\n20,20,line,1,1,2\n80,20,line,1,2," +
                                  fastest + "\n80,80,end,0,,2\n");
    const auto run =
        folder.run("score flat.asc route.csv --vehicle small-usv --resolution 2 --hit-only -o out");
    EXPECT_EQ(run.code, 0) << run.err;
    return run.err;
  };
  EXPECT_THAT(told("7"), HasSubstr("1 leg is sailed faster than the vehicle can; leg 2, a line "
                                   "(2), at 7 m/s where it makes 2:"));
  EXPECT_THAT(told("2"), Not(HasSubstr("faster than the vehicle")));
}

TEST(Corners, NoPlannerLeavesAnyWhereItsJoinsCanBeSteered) {
  const test::Folder folder;
  ASSERT_EQ(folder
                .run("synth stepped --width 120 --height 90 --depth 8 --depth-east 16 -o "
                     "step.obj")
                .code,
            0);
  const auto run = folder.run(
      "compare step.obj --planners "
      "back-and-forth,multi-depth,nuc,mdnuc,edge-following --resolution 2 "
      "--crs EPSG:32630 --profile survey --hit-only --quiet --export waypoints -o "
      "out");
  ASSERT_EQ(run.code, 0) << run.err;
  for (const auto& score : test::json_of(folder / "out" / "compare.json")) {
    const std::string planner = score.at("planner");
    SCOPED_TRACE(planner);
    if (score.at("infeasible_legs").get<int>() > 0) continue;
    EXPECT_EQ(score.at("sharp_corners"), 0);
    // What an autopilot is given is thinned by a decimetre. That makes no corner of a curve.
    const auto again = folder.run("score step.obj out/" + planner +
                                  "/route.waypoints --crs EPSG:32630 --resolution 2 --profile "
                                  "survey --hit-only --quiet -o again");
    ASSERT_EQ(again.code, 0) << again.err;
    EXPECT_EQ(test::json_of(folder / "again" / "score.json").at("sharp_corners"), 0);
  }
}

}  // namespace
}  // namespace swathplan
