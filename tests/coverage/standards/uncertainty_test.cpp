#include "coverage/standards/uncertainty.h"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <map>
#include <regex>

#include "coverage/route/sonar.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// All deviations known and nought.
UncertaintyBudget perfect() {
  UncertaintyBudget budget;
  budget.range_m = budget.mean_sound_speed_mps = budget.head_sound_speed_mps = 0.0;
  budget.beam_angle = budget.roll = budget.pitch = budget.heading = Angle();
  budget.heave_m = budget.position_m = budget.timing_s = 0.0;
  budget.draft_m = budget.squat_m = budget.water_level_m = 0.0;
  return budget;
}

/// At 60 degrees, range 40 m: 20 m below and 34.64 m across, at 2 m/s.
const SoundingGeometry kOblique{Angle::degrees(60), 40.0, 2.0};
constexpr double kBelow = 20.0;
const double kAbeam = 20.0 * std::sqrt(3.0);

double tvu(const UncertaintyBudget& budget) {
  return sounding_uncertainty(budget, kOblique).tvu_m / 1.96;
}
/// Of an error in one horizontal direction.
double one_way(const UncertaintyBudget& budget) {
  return sounding_uncertainty(budget, kOblique).thu_m / 2.45 * std::sqrt(2.0);
}

constexpr double kThousandth = 1e-3;
#define EXPECT_CLOSE(value, exact) EXPECT_NEAR(value, exact, kThousandth*(exact))

TEST(Uncertainty, IsNoughtWhereAllIsKnown) {
  EXPECT_DOUBLE_EQ(tvu(perfect()), 0.0);
  EXPECT_DOUBLE_EQ(one_way(perfect()), 0.0);
}

TEST(Uncertainty, OfTheRangeSplitsByTheAngle) {
  UncertaintyBudget budget = perfect();
  budget.range_m = 0.1;
  EXPECT_CLOSE(tvu(budget), 0.05);
  EXPECT_CLOSE(one_way(budget), 0.1 * std::sqrt(3.0) / 2.0);
}

TEST(Uncertainty, OfTheMeanSoundSpeedIsAShareOfDepthAndDistance) {
  UncertaintyBudget budget = perfect();
  budget.mean_sound_speed_mps = 3.0;
  EXPECT_CLOSE(tvu(budget), kBelow * 0.002);
  EXPECT_CLOSE(one_way(budget), kAbeam * 0.002);
}

TEST(Uncertainty, OfBeamAngleAndRollTurnsTheSounding) {
  for (const auto& [angle, roll] : {std::pair(0.01, 0.0), {0.0, 0.01}}) {
    UncertaintyBudget budget = perfect();
    budget.beam_angle = Angle::radians(angle);
    budget.roll = Angle::radians(roll);
    EXPECT_CLOSE(tvu(budget), kAbeam * 0.01);
    EXPECT_CLOSE(one_way(budget), kBelow * 0.01);
  }
}

TEST(Uncertainty, OfTheSoundSpeedAtTheHeadBendsTheBeam) {
  UncertaintyBudget budget = perfect();
  budget.head_sound_speed_mps = 1.5;
  EXPECT_CLOSE(tvu(budget), kAbeam * std::sqrt(3.0) * 0.001);
  EXPECT_CLOSE(one_way(budget), kBelow * std::sqrt(3.0) * 0.001);
}

TEST(Uncertainty, OfTheBeamWidthIsWhatItsRimLiesShoaler) {
  UncertaintyBudget budget = perfect();
  budget.beam_width_along = Angle::degrees(20);
  EXPECT_CLOSE(tvu(budget), kBelow * (1.0 - std::cos(10.0 * M_PI / 180.0)));
}

TEST(Uncertainty, OfLevelsAddsUpInSquares) {
  UncertaintyBudget budget = perfect();
  budget.heave_m = 0.1;
  budget.draft_m = 0.2;
  budget.squat_m = 0.2;
  budget.water_level_m = 0.4;
  EXPECT_CLOSE(tvu(budget), 0.5);
  EXPECT_DOUBLE_EQ(one_way(budget), 0.0);
}

TEST(Uncertainty, OfHeaveIsItsFixedPartOrItsShareWhicheverIsMore) {
  UncertaintyBudget budget = perfect();
  budget.heave_m = 0.05;
  budget.heave_share = 0.1;
  budget.expected_heave_m = 0.4;
  EXPECT_CLOSE(tvu(budget), 0.05);
  budget.expected_heave_m = 2.0;
  EXPECT_CLOSE(tvu(budget), 0.2);
}

TEST(Uncertainty, OfPitchHeadingAndTimingMovesTheSoundingAlongTheCourse) {
  UncertaintyBudget budget = perfect();
  budget.pitch = Angle::radians(0.01);
  EXPECT_CLOSE(one_way(budget), kBelow * 0.01);
  budget = perfect();
  budget.heading = Angle::radians(0.01);
  EXPECT_CLOSE(one_way(budget), kAbeam * 0.01);
  budget = perfect();
  budget.timing_s = 0.1;
  EXPECT_CLOSE(one_way(budget), 0.2);
  EXPECT_DOUBLE_EQ(tvu(budget), 0.0);
}

TEST(Uncertainty, OfThePositionCountsInBothDirections) {
  UncertaintyBudget budget = perfect();
  budget.position_m = 0.5;
  EXPECT_CLOSE(sounding_uncertainty(budget, kOblique).thu_m, 2.45 * 0.5);
}

TEST(Uncertainty, AddsUpItsPartsInSquares) {
  UncertaintyBudget budget;
  use_sonar("em2040", budget);
  use_positioning("rtk", budget);
  use_motion_sensor("mru", budget);
  budget.beam_width_along = Angle::degrees(1);
  budget.mean_sound_speed_mps = 1.0;
  budget.head_sound_speed_mps = 0.5;
  budget.draft_m = budget.squat_m = 0.02;
  double sum = 0.0;
  for (const UncertaintyPart& part : depth_parts(budget, kOblique)) {
    sum += part.sigma_m * part.sigma_m;
  }
  EXPECT_NEAR(tvu(budget), std::sqrt(sum), 1e-12);
}

std::string refusal(const UncertaintyBudget& budget) {
  try {
    (void)sounding_uncertainty(budget, kOblique);
  } catch (const UsageError& error) {
    return error.what();
  }
  return {};
}

TEST(Uncertainty, RefusesWhatNobodyGaveByName) {
  UncertaintyBudget budget = perfect();
  budget.roll.reset();
  EXPECT_THAT(missing(budget), ElementsAre("roll uncertainty"));
  EXPECT_THAT(refusal(budget), HasSubstr("not given: <roll uncertainty>; give it, or"));
  budget.water_level_m.reset();
  EXPECT_THAT(refusal(budget),
              HasSubstr("<roll uncertainty>, <water level uncertainty>; give them"));
  EXPECT_EQ(missing(UncertaintyBudget()).size(), 13U);
}

TEST(Uncertainty, RefusesDeviationsOutOfRange) {
  UncertaintyBudget budget = perfect();
  budget.draft_m = -0.1;
  EXPECT_THAT(refusal(budget), HasSubstr("draft uncertainty -0.1; must be"));
  budget = perfect();
  budget.sound_speed_mps = 0.0;
  EXPECT_THAT(refusal(budget), HasSubstr("sound speed 0; must be"));
}

TEST(UncertaintyPresets, FillWhatTheyKnow) {
  UncertaintyBudget budget;
  use_sonar("norbit-iwbms", budget);
  use_positioning("ppk-ins", budget);
  use_motion_sensor("ppk-ins", budget);
  EXPECT_THAT(missing(budget),
              ElementsAre("sound speed uncertainty", "head sound speed uncertainty",
                          "draft uncertainty", "squat uncertainty"));
}

TEST(UncertaintyPresets, LeaveTheWaterLevelToTheGaugeWherePositionsHaveNoHeight) {
  UncertaintyBudget budget;
  use_positioning("dgnss", budget);
  EXPECT_FALSE(budget.water_level_m);
  EXPECT_TRUE(budget.position_m);
}

TEST(UncertaintyPresets, RefuseOtherNames) {
  UncertaintyBudget budget;
  EXPECT_THROW(use_positioning("loran", budget), UsageError);
  EXPECT_THROW(use_motion_sensor("plumb bob", budget), UsageError);
  use_sonar("a sonar of one's own", budget);
  EXPECT_FALSE(budget.range_m);
}

TEST(UncertaintyPresets, HaveARowForEachSonar) {
  for (const Sonar& sonar : sonar_presets()) {
    UncertaintyBudget budget;
    use_sonar(sonar.name, budget);
    EXPECT_TRUE(budget.range_m) << sonar.name;
  }
}

/// The rows '| name | number |' of the example in docs/uncertainty.md.
std::map<std::string, double> example_rows() {
  std::ifstream file(SWATHPLAN_SOURCE_DIR "/docs/uncertainty.md");
  std::map<std::string, double> rows;
  const std::regex row(R"(\| ([a-zA-Z ]+?) +\|.*\| *([0-9.]+) *\|)");
  bool inside = false;
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("## ", 0) == 0) inside = line.find("worked by hand") != std::string::npos;
    std::smatch match;
    if (inside && std::regex_match(line, match, row)) rows[match[1]] = std::stod(match[2]);
  }
  return rows;
}

/// What the example says it is about: em2040, dgnss, mru, 20 m below the sonar at 60 degrees.
UncertaintyBudget example_budget() {
  UncertaintyBudget budget;
  use_sonar("em2040", budget);
  use_positioning("dgnss", budget);
  use_motion_sensor("mru", budget);
  budget.beam_width_along = Angle::degrees(1);
  budget.mean_sound_speed_mps = 1.0;
  budget.head_sound_speed_mps = 0.25;
  budget.draft_m = budget.squat_m = 0.02;
  budget.water_level_m = 0.05;
  return budget;
}

TEST(UncertaintyDocs, ShowAnExampleThatIsRight) {
  const std::map<std::string, double> rows = example_rows();
  const auto parts = depth_parts(example_budget(), kOblique);
  for (const UncertaintyPart& part : parts) {
    ASSERT_EQ(rows.count(std::string(part.source)), 1U) << part.source;
    EXPECT_NEAR(rows.at(std::string(part.source)), part.sigma_m, 0.00051) << part.source;
  }
  const SoundingUncertainty both = sounding_uncertainty(example_budget(), kOblique);
  ASSERT_EQ(rows.count("TVU") + rows.count("THU"), 2U);
  EXPECT_NEAR(rows.at("TVU"), both.tvu_m, 0.00051);
  EXPECT_NEAR(rows.at("THU"), both.thu_m, 0.00051);
}

}  // namespace
}  // namespace swathplan
