#include "planners/adaptive/track_spacing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "mesh/base/error.h"
#include "planners/adaptive/intervals.h"
#include "planners/adaptive/spacing_missions.h"
#include "planners/message_of.h"

namespace swathplan {
namespace {

using testing::HasSubstr;

TrackSpacingOptions spacing_options(double range, bool adapt = true, bool careful = true) {
  return {.range_m = range, .adapt = adapt, .careful = careful};
}

// Cells of 0.1 m that a layout of `count` tracks covers: the oracle for tracks_needed.
bool layout_covers(double width, double r, double rn, int count) {
  IntervalSet covered;
  for (int i = 0; i < count; ++i) {
    const double x = (i / 2) * (3 * r - rn) + r + (i % 2) * (r - rn);
    covered.add({x - r, x - rn});
    covered.add({x + rn, x + r});
  }
  return covered.covers({0.0, width});
}

TEST(TrackSpacing, TracksNeededIsTheFewestThatCover) {
  for (double width = 50.0; width < 1500.0; width += 37.0) {
    for (double r = 120.0; r <= 150.0; r += 5.0) {
      const int n = tracks_needed(width, r, 40.0);
      EXPECT_TRUE(layout_covers(width, r, 40.0, n)) << width << " " << r;
      EXPECT_FALSE(layout_covers(width, r, 40.0, n - 1)) << width << " " << r;
    }
  }
}

TEST(TrackSpacing, PolygonAdaptationReproducesThePaper) {
  EXPECT_DOUBLE_EQ(adapted_range_m(1212, 145, 40), 138.0);
  EXPECT_EQ(tracks_needed(1212, 138, 40), 7);
  EXPECT_DOUBLE_EQ(adapted_range_m(1212, 130, 40), 120.0);
  EXPECT_EQ(tracks_needed(1212, 120, 40), 8);
  EXPECT_DOUBLE_EQ(adapted_range_m(1212, 120, 40), 120.0);
}

TEST(TrackSpacing, AdaptedRangeIsTheSmallestOfTheFewest) {
  for (double width = 100.0; width < 2000.0; width += 53.0) {
    const double r = adapted_range_m(width, 150, 40);
    for (int i = 120; i <= 150; ++i) {
      EXPECT_GE(tracks_needed(width, i, 40), tracks_needed(width, r, 40));
      if (i < r) {
        EXPECT_GT(tracks_needed(width, i, 40), tracks_needed(width, r, 40));
      }
    }
  }
}

struct Experiment {
  double start_m, first_m;
  std::size_t tracks;
};
class TrackSpacingExperiments : public testing::TestWithParam<std::tuple<Experiment, bool, int>> {};

TEST_P(TrackSpacingExperiments, RangesAndTracksAreThePapers) {
  const auto& [experiment, careful, trials] = GetParam();
  const auto mission =
      sail(spacing_options(experiment.start_m, true, careful), SpacingWorld{.trials = trials});
  EXPECT_EQ(mission.state.sailed.size(), experiment.tracks);
  EXPECT_DOUBLE_EQ(mission.state.ranges_m.front(), experiment.first_m);
  for (std::size_t i = 2; i < mission.state.ranges_m.size(); ++i) {
    EXPECT_DOUBLE_EQ(mission.state.ranges_m[i], 120.0);
  }
  if (careful) {
    EXPECT_LT(uncovered_share(mission.risk), 0.002);
  }
}
INSTANTIATE_TEST_SUITE_P(All, TrackSpacingExperiments,
                         testing::Combine(testing::Values(Experiment{145, 138, 8},
                                                          Experiment{120, 120, 8},
                                                          Experiment{130, 120, 8}),
                                          testing::Bool(), testing::Values(0, 2000)));

// Gaps of the control at r = 145 with data to 130 m: 15 m four times a pair, by intervals.
TEST(TrackSpacing, ControlLeavesWhatGeometryGives) {
  const auto mission = sail(spacing_options(145, false), SpacingWorld{});
  ASSERT_EQ(mission.state.sailed.size(), 7U);
  IntervalSet covered;
  for (const SurveyTrack& t : mission.state.sailed) {
    covered.add({t.across_m - 130, t.across_m - 40});
    covered.add({t.across_m + 40, t.across_m + 130});
  }
  const double gaps = 1.0 - covered.covered_m({0, 1212}) / 1212;
  EXPECT_NEAR(gaps, 195.0 / 1212.0, 1e-9);
  EXPECT_NEAR(uncovered_share(mission.risk), gaps, 2 * 5.0 / 1212);
}

TEST(TrackSpacing, WorstComponentIsBetterThanTheControlsInExperimentThree) {
  const auto worst = [](bool adapt) {
    const auto mission = sail(spacing_options(130, adapt), SpacingWorld{});
    return fitted_mixture(looked_at(without_border(mission.risk, 20)), 2).back().mean;
  };
  EXPECT_LT(worst(true), worst(false));
}

TEST(TrackSpacing, AShortRangeIsAnsweredNotFatal) {
  auto state = start_spacing(spacing_options(145));
  const DetectionCurve weak{{40, 70, 90}, {0.3, 0.4, 0.0}};
  state = observe(state, *next_track(state), weak);
  EXPECT_TRUE(state.range_too_short);
  EXPECT_DOUBLE_EQ(state.good_range_m, 120.0);
  EXPECT_TRUE(next_track(state).has_value());
}

DetectionCurve good_to(double range) { return {{40, 70, range}, {0.3, 0.4, 0.1}}; }
const DetectionCurve kDead{{40, 150}, {0.0, 0.0}};

// Sails with curves by the number of the track.
TrackSpacingState sailed(const TrackSpacingOptions& o,
                         const std::function<SideCurves(int)>& curves) {
  auto state = start_spacing(o);
  while (const auto track = next_track(state)) {
    state = observe(state, *track, curves(track->number));
    if (state.sailed.size() > 200) break;
  }
  return state;
}

// What is really covered: each track by its own ranges.
double really_uncovered_m(const TrackSpacingState& state,
                          const std::function<SideCurves(int)>& curves) {
  IntervalSet covered;
  for (const SurveyTrack& t : state.sailed) {
    const auto reach = [&](const DetectionCurve& curve) {
      return admissible_range_m(curve, 0.05).value_or(0.0);
    };
    const SideCurves c = curves(t.number);
    const bool port_back = t.outbound == state.options.port_looks_back;
    covered.add({t.across_m - reach(port_back ? c.port : c.starboard), t.across_m - 40});
    covered.add({t.across_m + 40, t.across_m + reach(port_back ? c.starboard : c.port)});
  }
  return state.options.width_m - covered.covered_m({0, state.options.width_m});
}

TEST(TrackSpacing, StripesOfADropOfRangeAreClosed) {
  for (const double start : {130.0, 140.0, 150.0}) {
    for (int from = 0; from < 7; ++from) {
      const auto curves = [&](int track) {
        const auto curve = good_to(track < from ? start : 124.0);
        return SideCurves{curve, curve};
      };
      const auto state = sailed(spacing_options(start), curves);
      EXPECT_FALSE(next_track(state).has_value());
      EXPECT_NEAR(uncovered_m(state), really_uncovered_m(state, curves), 1e-6);
      EXPECT_LT(uncovered_m(state), 5.0) << start << " " << from;
      EXPECT_LE(state.sailed.size(), 10U) << start << " " << from;
    }
  }
}

TEST(TrackSpacing, ShortRangesOfTwoTracksAreSaidToTheEndAndCovered) {
  const auto curves = [](int track) {
    const auto curve = good_to(track < 2 ? 90.0 : 150.0);
    return SideCurves{curve, curve};
  };
  const auto state = sailed(spacing_options(150), curves);
  EXPECT_TRUE(state.range_too_short);
  EXPECT_NEAR(uncovered_m(state), really_uncovered_m(state, curves), 1e-6);
  EXPECT_LT(uncovered_m(state), 5.0);
  // As published it goes on, but tells what it left.
  const auto published = sailed(spacing_options(150, true, false), curves);
  EXPECT_TRUE(published.range_too_short);
  EXPECT_NEAR(uncovered_m(published), really_uncovered_m(published, curves), 1e-6);
  EXPECT_GT(uncovered_m(published), 100.0);
}

TEST(TrackSpacing, ADeadSideIsToldFromALiveOne) {
  for (const bool port_back : {true, false}) {
    auto o = spacing_options(150);
    o.port_looks_back = port_back;
    const auto curves = [](int) { return SideCurves{good_to(150.0), kDead}; };
    const auto state = sailed(o, curves);
    EXPECT_TRUE(state.range_too_short);
    EXPECT_DOUBLE_EQ(state.good_range_m, 120.0);  // the worse side's
    EXPECT_NEAR(uncovered_m(state), really_uncovered_m(state, curves), 1e-6);
    EXPECT_LT(uncovered_m(state), 5.0 * 12) << port_back;
    EXPECT_LE(state.sailed.size(), 30U) << port_back;
  }
}

TEST(TrackSpacing, ADeadSonarEndsTheSurveyAndCoversNothing) {
  const auto state = sailed(spacing_options(150), [](int) { return SideCurves{kDead, kDead}; });
  EXPECT_FALSE(next_track(state).has_value());
  EXPECT_DOUBLE_EQ(uncovered_m(state), 1212.0);
  EXPECT_LE(state.sailed.size(), 8U);
}

TEST(TrackSpacing, RefusesBadOptions) {
  const auto refusal = [](auto change) {
    TrackSpacingOptions o;
    change(o);
    return message_of<UsageError>([&] { (void)start_spacing(o); });
  };
  EXPECT_THAT(refusal([](auto& o) { o.range_m = 119; }), HasSubstr("r >= 3 r_n = 120"));
  EXPECT_THAT(refusal([](auto& o) { o.width_m = 30; }), HasSubstr("narrower"));
  EXPECT_THAT(refusal([](auto& o) { o.nadir_m = 0; }), HasSubstr("nadir gap"));
  EXPECT_THAT(refusal([](auto& o) { o.threshold = 1; }), HasSubstr("threshold"));
  EXPECT_THAT(refusal([](auto& o) { o.length_m = -1; }), HasSubstr("length"));
}

TEST(TrackSpacing, RefusesBadObservations) {
  const auto state = start_spacing(spacing_options(145));
  const SurveyTrack track = *next_track(state);
  const auto refusal = [&](const SurveyTrack& t, const DetectionCurve& curve) {
    return message_of<InvalidInput>([&] { (void)observe(state, t, curve); });
  };
  EXPECT_THAT(refusal({5, 0, true}, example_curve()), HasSubstr("track 5"));
  EXPECT_THAT(refusal(track, {{40, 50}, {0.5, 1.2}}), HasSubstr("[0, 1]"));
  EXPECT_THAT(refusal(track, {{50, 40}, {0.5, 0.2}}), HasSubstr("sort the ranges"));
  EXPECT_THAT(refusal(track, {}), HasSubstr("at least one"));
  EXPECT_THAT(refusal(track, {{40, 50}, {0.5}}), HasSubstr("as many"));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal(track, {{40, 50}, {0.5, nan}}), HasSubstr("probability 1 is nan"));
  EXPECT_THAT(refusal(track, {{40, nan}, {0.5, 0.4}}), HasSubstr("range 1 is nan"));
}

}  // namespace
}  // namespace swathplan
