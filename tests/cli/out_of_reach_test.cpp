// What no boat, sonar or sound can do is refused or said, with what comes nearest.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/program.h"

namespace swathplan {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class OutOfReach : public testing::Test {
 protected:
  std::string refused(const std::string& arguments) {
    const auto run = folder_.run(arguments + " --profile survey -o out");
    EXPECT_EQ(run.code, 2) << arguments << "\n" << run.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out")) << arguments;
    return run.err;
  }
  test::Folder folder_;
};

TEST_F(OutOfReach, SpeedsThatAreNoneOrAboveTheVehicles) {
  ASSERT_EQ(folder_.run("synth flat --width 40 --height 40 -o flat.asc").code, 0);
  EXPECT_THAT(refused("plan flat.asc --speed 0"), HasSubstr("--speed 0; must be above 0 m/s"));
  EXPECT_THAT(refused("plan flat.asc --speed=-1kn"), HasSubstr("must be above 0 m/s"));
  EXPECT_THAT(refused("plan flat.asc --least-speed 6kn"),
              AllOf(HasSubstr("--least-speed 3.08667"), HasSubstr("speed on lines, 2 m/s")));
  EXPECT_THAT(refused("lines flat.asc --transit-speed 0"), HasSubstr("--transit-speed 0"));
}

TEST_F(OutOfReach, APingRateThatSoundForbids) {
  ASSERT_EQ(folder_.run("synth flat --width 40 --height 40 --depth 50.3 -o deep.asc").code, 0);
  // There and back 50 m below the sonar, in 0.9 of the cycle: 13.5 times a second.
  EXPECT_THAT(refused("plan deep.asc --resolution 1 --ping-rate 20"),
              AllOf(HasSubstr("--ping-rate 20"), HasSubstr("50 m below the sonar"),
                    HasSubstr("13.5 times a second")));
  folder_.write("line.csv", "x,y\n5,20\n35,20\n");
  const auto run = folder_.run(
      "score deep.asc line.csv --profile survey --resolution 1 --hit-only "
      "--ping-rate 13 --quiet -o out");
  EXPECT_EQ(run.code, 0) << run.err;
}

TEST_F(OutOfReach, SoundingsThatNoFanAndNoSpeedLays) {
  ASSERT_EQ(folder_.run("synth flat --width 30 --height 30 --depth 100.3 -o deep.asc").code, 0);
  // At 1 m/s, half the speed of the vehicle, pings lie 0.148 m apart.
  EXPECT_THAT(refused("plan deep.asc --resolution 0.1 --soundings 5"),
              AllOf(HasSubstr("--soundings 5; in 100 % of the area, from 100.3 m of depth on"),
                    HasSubstr("0.148 m apart"), HasSubstr("--resolution 0.15"),
                    HasSubstr("--least-speed 0.67 comes nearest")));
}

TEST_F(OutOfReach, ANoteSaysWhereOnlyAPartIs) {
  ASSERT_EQ(folder_
                .run("synth stepped --width 60 --height 30 --depth 10 --depth-east 100.3 -o "
                     "step.obj")
                .code,
            0);
  const auto run = folder_.run(
      "plan step.obj --profile survey --planner back-and-forth "
      "--resolution 0.1 --hit-only --spacing 10 -o out");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.err, AllOf(HasSubstr("% of the area, from "),
                             HasSubstr("lays a sounding in each cell of 0.1 m"),
                             HasSubstr("--least-speed")));
}

}  // namespace
}  // namespace swathplan
