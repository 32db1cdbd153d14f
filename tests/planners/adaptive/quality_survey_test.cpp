#include "planners/adaptive/quality_survey.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>

#include "mesh/base/error.h"
#include "planners/adaptive/quality_baselines.h"
#include "planners/message_of.h"

namespace swathplan {
namespace {

using testing::HasSubstr;

struct Case {
  double port_m, starboard_m;
  std::size_t optimum;
};
constexpr Case kCases[] = {{70, 70, 36}, {110, 110, 18}, {150, 0, 19}};

QualitySurveyOptions quality_options(GapConstraint constraint) {
  QualitySurveyOptions o;
  o.constraint = constraint;
  return o;
}

TEST(QualitySurvey, EveryVariantCoversAll) {
  for (const Case& c : kCases) {
    for (const auto constraint :
         {GapConstraint::none, GapConstraint::mild, GapConstraint::strong}) {
      const auto o = quality_options(constraint);
      const auto state = sail(o, true_quality(o, c.port_m, c.starboard_m));
      EXPECT_DOUBLE_EQ(covered_share(state), 1.0) << name(constraint) << " " << c.port_m;
    }
  }
}

TEST(QualitySurvey, StrongConstraintIsWithinATrackOfTheOptimum) {
  for (const Case& c : kCases) {
    const auto o = quality_options(GapConstraint::strong);
    const auto truth = true_quality(o, c.port_m, c.starboard_m);
    EXPECT_EQ(fewest_tracks(o, truth).size(), c.optimum);
    EXPECT_LE(sail(o, truth).sailed.size(), c.optimum + 1);
  }
}

TEST(QualitySurvey, StrongConstraintTravelsLeastInTheFirstTwoCases) {
  for (const Case& c : {kCases[0], kCases[1]}) {
    const auto travel = [&](GapConstraint constraint) {
      const auto o = quality_options(constraint);
      return travel_m(sail(o, true_quality(o, c.port_m, c.starboard_m)).sailed, o.length_m);
    };
    EXPECT_LT(travel(GapConstraint::strong), travel(GapConstraint::mild));
    EXPECT_LT(travel(GapConstraint::strong), travel(GapConstraint::none));
  }
}

TEST(QualitySurvey, RatesAreTheMeanOfTheBetaPosterior) {
  auto state = start_survey({});
  EXPECT_DOUBLE_EQ(success_rate(state, true, 0), 0.5);
  const QualityObservation half = observe_world(true_quality(state.options, 150, 0));
  state = observe(state, *next_track(state), half);
  EXPECT_DOUBLE_EQ(success_rate(state, true, 0), 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(success_rate(state, false, 0), 1.0 / 3.0);
}

TEST(QualitySurvey, TransitCostIsAParabola) {
  const QualitySurveyOptions o;
  EXPECT_DOUBLE_EQ(transit_cost(o, 100, 160), 0.0);
  EXPECT_DOUBLE_EQ(transit_cost(o, 100, 100), 1.0);
  EXPECT_DOUBLE_EQ(transit_cost(o, 280, 100), 4.0);
}

TEST(QualitySurvey, ADeadSonarEndsTheSurvey) {
  QualitySurveyOptions o;
  o.width_m = 200.0;
  const auto state = sail(o, true_quality(o, 0, 0));
  EXPECT_DOUBLE_EQ(covered_share(state), 0.0);
  EXPECT_EQ(state.sailed.size(), 8U);
  EXPECT_TRUE(nothing_gained(state));
}

std::size_t most_sails_of_a_line(const QualitySurveyState& state) {
  std::size_t most = 0;
  for (const SurveyTrack& t : state.sailed) {
    const auto same =
        std::count_if(state.sailed.begin(), state.sailed.end(),
                      [&](const SurveyTrack& other) { return other.across_m == t.across_m; });
    most = std::max(most, static_cast<std::size_t>(same));
  }
  return most;
}

// The sonar sees to 150 m, and to 70 m from half way on.
TEST(QualitySurvey, ADropOfRangeIsNoReasonToSailALineAgainAndAgain) {
  for (const auto constraint : {GapConstraint::none, GapConstraint::mild, GapConstraint::strong}) {
    const auto o = quality_options(constraint);
    auto state = start_survey(o);
    while (const auto track = next_track(state)) {
      const double range = covered_share(state) < 0.5 ? 150.0 : 70.0;
      state = observe(state, *track, observe_world(true_quality(o, range, range)));
    }
    EXPECT_DOUBLE_EQ(covered_share(state), 1.0) << name(constraint);
    EXPECT_FALSE(nothing_gained(state));
    EXPECT_LE(most_sails_of_a_line(state), 4U) << name(constraint);
    EXPECT_LE(state.sailed.size(), 31U) << name(constraint);  // 5 + 18 are the fewest
  }
}

TEST(QualitySurvey, ASonarThatDiesOnTheWayEndsTheSurvey) {
  const auto o = quality_options(GapConstraint::strong);
  auto state = start_survey(o);
  while (const auto track = next_track(state)) {
    const double range = state.sailed.size() < 4 ? 150.0 : 0.0;
    state = observe(state, *track, observe_world(true_quality(o, range, range)));
  }
  EXPECT_TRUE(nothing_gained(state));
  EXPECT_EQ(state.sailed.size(), 12U);
}

TEST(QualitySurvey, RefusesBadObservations) {
  const auto state = start_survey({});
  const SurveyTrack track = *next_track(state);
  QualityObservation good = observe_world(true_quality(state.options, 150, 150));
  const auto refusal = [&](const SurveyTrack& t, const QualityObservation& observation) {
    return message_of<InvalidInput>([&] { (void)observe(state, t, observation); });
  };
  SurveyTrack other = track;
  other.across_m += 10.0;
  EXPECT_THAT(refusal(other, good), HasSubstr("which was not given"));
  auto bad = good;
  bad.port.pop_back();
  EXPECT_THAT(refusal(track, bad), HasSubstr("10 correlations on the port side; give 11"));
  bad = good;
  bad.starboard[4] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal(track, bad), HasSubstr("correlation 4 of the starboard side is nan"));
  bad.starboard[4] = 1.5;
  EXPECT_THAT(refusal(track, bad), HasSubstr("[-1, 1]"));
}

TEST(QualitySurvey, RefusesBadOptions) {
  const auto refusal = [](auto change) {
    QualitySurveyOptions o;
    change(o);
    return message_of<UsageError>([&] { check(o); });
  };
  EXPECT_THAT(refusal([](auto& o) { o.turn_width_m = -60; }), HasSubstr("turning radius"));
  EXPECT_THAT(refusal([](auto& o) { o.width_m = 100; }), HasSubstr("narrower"));
  EXPECT_THAT(refusal([](auto& o) { o.width_m = 2005; }), HasSubstr("multiple of the swath"));
  EXPECT_THAT(refusal([](auto& o) { o.range_max_m = 30; }), HasSubstr("largest range"));
  EXPECT_THAT(refusal([](auto& o) { o.cost_weight = -0.1; }), HasSubstr("cost weight"));
  EXPECT_THAT(refusal([](auto& o) { o.quality = 1.0; }), HasSubstr("quality"));
}

}  // namespace
}  // namespace swathplan
