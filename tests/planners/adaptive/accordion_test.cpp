#include "planners/adaptive/accordion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "mesh/base/error.h"
#include "mesh/base/random.h"
#include "planners/adaptive/simulated_strips.h"
#include "planners/message_of.h"

namespace swathplan {
namespace {

using testing::HasSubstr;

constexpr double kW = 50.0;
constexpr double kL = 400.0;

AccordionOptions strip_options(double strips, AccordionRule rule = AccordionRule::basic) {
  return {.width_m = strips * kW, .length_m = kL, .spacing_m = kW, .rule = rule};
}

// One object in the middle of each strip listed.
StripWorld chosen_strips(double spacing_m, std::span<const int> strips) {
  StripWorld world;
  for (const int strip : strips) world.objects_m.push_back((strip + 0.5) * spacing_m);
  std::sort(world.objects_m.begin(), world.objects_m.end());
  return world;
}

// Length of one spatial period (four strips wide) of a mission over eight strips.
double period(std::initializer_list<int> strips) {
  const std::vector<int> list(strips);
  const auto mission = sail(chosen_strips(kW, list), strip_options(8));
  return length_until_m(mission.state.sailed, kL, 4 * kW);
}

// Table I. Strips are numbered from the start edge. The planner knows 'behind' and 'ahead'; which
// of the paper's cases that is depends on the vehicle's course, see PortIsLeftOfTheCourse: cases 1,
// 3, 5 meet a track that runs down, 2 one that runs up, 4 and 6 mirror 1 and 5 with a start at the
// top.
TEST(Accordion, TableOfPathLengths) {
  EXPECT_NEAR(period({}), 2 * kL + 4 * kW, 1e-9);            // case 0
  EXPECT_NEAR(period({1}), 3 * kL + 6 * kW, 1e-9);           // 1 and, mirrored, 4
  EXPECT_NEAR(period({0}), 3 * kL + 4 * kW, 1e-9);           // 2
  EXPECT_NEAR(period({2}), 3 * kL + 4 * kW, 1e-9);           // 3
  EXPECT_NEAR(period({1, 2}), 4 * kL + 6 * kW, 1e-9);        // 5 and, mirrored, 6
  EXPECT_NEAR(period({0, 1, 2, 3}), 4 * kL + 4 * kW, 1e-9);  // 7
  EXPECT_NEAR(period({1, 2, 3}), 4 * kL + 6 * kW, 1e-9);     // 8
  const auto lawnmower = overlapping_lawnmower(8 * kW, kW);
  EXPECT_NEAR(length_until_m(lawnmower, kL, 4 * kW), 4 * kL + 4 * kW, 1e-9);
}

std::vector<double> places(const AccordionMission& mission) {
  std::vector<double> result;
  for (const SurveyTrack& t : mission.state.sailed) result.push_back(t.across_m / kW);
  return result;
}

TEST(Accordion, BothSidesLoopsBackFirst) {
  const std::vector<int> both{1, 2};
  EXPECT_THAT(places(sail(chosen_strips(kW, both), strip_options(8))),
              testing::ElementsAre(0, 2, 1, 3, 5, 7));
}

TEST(Accordion, WorstCaseStartsTheNextPeriodOneStripOn) {
  const std::vector<int> three{1, 2, 3};
  const auto mission = sail(chosen_strips(kW, three), strip_options(8));
  EXPECT_THAT(places(mission), testing::ElementsAre(0, 2, 1, 3, 4, 6, 8));
}

TEST(Accordion, NothingIsSweptTwiceWithoutNeed) {
  for (unsigned pattern = 0; pattern < 1U << 10U; ++pattern) {
    std::vector<int> strips;
    for (int s = 0; s < 10; ++s) {
      if ((pattern >> static_cast<unsigned>(s)) & 1U) strips.push_back(s);
    }
    const auto mission = sail(chosen_strips(kW, strips), strip_options(10));
    std::vector<double> where = places(mission);
    std::sort(where.begin(), where.end());
    EXPECT_EQ(std::adjacent_find(where.begin(), where.end()), where.end()) << pattern;
    EXPECT_LE(where.size(), 11U);
    // A track between its two neighbours must serve an object beside it.
    for (std::size_t i = 1; i + 1 < where.size(); ++i) {
      if (where[i + 1] - where[i - 1] > 2.5) continue;
      const auto k = static_cast<unsigned>(where[i]);
      EXPECT_TRUE(((pattern >> (k - 1)) & 3U) != 0) << pattern << " at " << k;
    }
  }
}

TEST(Accordion, DirectionsAlternate) {
  const auto mission = sail(random_strips(40 * kW, kW, 0.4, 9), strip_options(40));
  for (std::size_t i = 0; i < mission.state.sailed.size(); ++i) {
    EXPECT_EQ(mission.state.sailed[i].outbound, i % 2 == 0);
  }
}

// Equation 2 in an empty area, equation 3 where each period is of case 8, over whole periods. The
// paper calls the latter the worst case; EverySecondStripCostsTwiceTheCaseOfEquationThree finds
// a worse one.
TEST(Accordion, EmptyAreasAndCaseEightMeetTheEquations) {
  for (const double alpha : {0.01, 0.1, 0.25, 0.5, 1.0, 2.0}) {
    AccordionOptions o = strip_options(40);
    o.length_m = kW / alpha;
    EXPECT_NEAR(gain(sail({}, o).state).periods_pct, 100.0 / (2.0 * (1.0 + alpha)), 1e-9);
    std::vector<int> worst;
    for (int s = 0; s < 40; ++s) {
      if (s % 4 != 0) worst.push_back(s);
    }
    EXPECT_NEAR(gain(sail(chosen_strips(kW, worst), o).state).periods_pct,
                -100.0 * alpha / (2.0 * (1.0 + alpha)), 1e-9);
  }
}

// Strips whose pattern repeats after `period` of them, from the start edge on.
std::vector<int> repeated(unsigned pattern, unsigned period, int strips) {
  std::vector<int> result;
  for (int s = 0; s < strips; ++s) {
    if ((pattern >> (static_cast<unsigned>(s) % period)) & 1U) result.push_back(s);
  }
  return result;
}

// Each skip then ends in a loop back: a period of four strips takes 4 L + 8 W instead of 4 L + 4 W.
TEST(Accordion, EverySecondStripCostsTwiceTheCaseOfEquationThree) {
  for (const double alpha : {0.01, 0.1, 0.25, 0.5, 1.0, 2.0}) {
    AccordionOptions o = strip_options(40);
    o.length_m = kW / alpha;
    const auto mission = sail(chosen_strips(kW, repeated(2, 2, 40)), o);
    const auto until = [&](double across) {
      return length_until_m(mission.state.sailed, o.length_m, across);
    };
    EXPECT_NEAR(until(24 * kW) - until(20 * kW), 4 * o.length_m + 8 * kW, 1e-9);
    const double lawnmower = 4 * o.length_m + 4 * kW;
    EXPECT_NEAR(1.0 - (until(24 * kW) - until(20 * kW)) / lawnmower, -alpha / (1.0 + alpha), 1e-9);
  }
}

// Of all patterns that repeat after up to eight strips none is worse.
TEST(Accordion, NoPatternUpToEightStripsIsWorseThanEverySecond) {
  AccordionOptions o = strip_options(840);  // a multiple of all periods
  o.length_m = kW;
  double worst = 0.0;
  for (unsigned period = 1; period <= 8; ++period) {
    for (unsigned pattern = 0; pattern < 1U << period; ++pattern) {
      const auto mission = sail(chosen_strips(kW, repeated(pattern, period, 840)), o);
      worst = std::min(worst, gain(mission.state).periods_pct);
    }
  }
  // A pattern may gain or lose a strip at the area's edges.
  EXPECT_NEAR(worst, -50.0, 0.2);
}

TEST(Accordion, IsTheLawnmowerWhereObjectsAreEverywhere) {
  const auto mission = sail(random_strips(12 * kW, kW, 1.0, 4), strip_options(12));
  EXPECT_EQ(mission.state.sailed, overlapping_lawnmower(12 * kW, kW));
}

struct Setting {
  double strips;
  AccordionRule rule;
};
class AccordionAnyWidth : public testing::TestWithParam<Setting> {};

// Every strip and every object: the promise of the mission, for widths that strips do not divide.
TEST_P(AccordionAnyWidth, SeesAllAndObjectsFromBothSides) {
  const AccordionOptions o = strip_options(GetParam().strips, GetParam().rule);
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const double share = static_cast<double>(seed % 11) / 10.0;
    const auto mission = sail(random_strips(o.width_m, kW, share, seed), o);
    EXPECT_EQ(mission.objects_seen_twice, mission.objects) << "seed " << seed;
    IntervalSet seen = mission.state.seen_from_below;
    for (const Interval& s : mission.state.seen_from_above.stretches()) seen.add(s);
    EXPECT_TRUE(seen.covers({0.0, o.width_m})) << "seed " << seed;
    for (const SurveyTrack& t : mission.state.sailed) {
      EXPECT_GE(t.across_m, 0.0);
      EXPECT_LE(t.across_m, o.width_m);
    }
    EXPECT_EQ(next_track(mission.state), std::nullopt);
  }
}
INSTANTIATE_TEST_SUITE_P(
    Widths, AccordionAnyWidth,
    testing::Values(Setting{0.4, AccordionRule::basic}, Setting{1.0, AccordionRule::basic},
                    Setting{1.3, AccordionRule::basic}, Setting{2.0, AccordionRule::basic},
                    Setting{7.77, AccordionRule::basic}, Setting{16.0, AccordionRule::basic},
                    Setting{0.4, AccordionRule::bounded}, Setting{1.0, AccordionRule::bounded},
                    Setting{1.3, AccordionRule::bounded}, Setting{2.0, AccordionRule::bounded},
                    Setting{3.5, AccordionRule::bounded}, Setting{7.77, AccordionRule::bounded},
                    Setting{16.0, AccordionRule::bounded}, Setting{29.1, AccordionRule::bounded}));

double excess_in_tracks(const StripWorld& world, const AccordionOptions& o) {
  const auto mission = sail(world, o);
  const double lawnmower =
      mission_length_m(overlapping_lawnmower(o.width_m, o.spacing_m), o.length_m);
  return (mission.state.sailed_m - lawnmower) / (o.length_m + o.spacing_m);
}

// All patterns of twelve strips, objects at both ends of their strips, several alphas.
TEST(Accordion, BoundedIsNeverLongerThanTheLawnmowerByMoreThanATrack) {
  for (const double alpha : {0.05, 0.3, 0.7, 1.0, 2.0}) {
    for (const double strips : {11.3, 12.0}) {
      AccordionOptions o = strip_options(strips, AccordionRule::bounded);
      o.length_m = kW / alpha;
      for (unsigned pattern = 0; pattern < 1U << 12U; ++pattern) {
        StripWorld world;
        for (unsigned s = 0; s < 12; ++s) {
          if (!((pattern >> s) & 1U)) continue;
          const double x = s * kW + ((pattern >> (s / 2)) & 1U ? 0.1 : 49.9);
          if (x < o.width_m) world.objects_m.push_back(x);
        }
        ASSERT_LE(excess_in_tracks(world, o), 1.0 + 1e-9) << alpha << " " << pattern;
      }
    }
  }
}

// The same with a clearance, for which it goes back farther than the object.
TEST(Accordion, BoundHoldsWithAClearance) {
  for (const double alpha : {0.1, 0.5, 1.0}) {
    AccordionOptions o = strip_options(30.0, AccordionRule::bounded);
    o.length_m = kW / alpha;
    o.clearance_m = 6.0;
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
      const auto world = random_strips(o.width_m, kW, 0.1 * static_cast<double>(seed % 11), seed);
      ASSERT_LE(excess_in_tracks(world, o), 1.0 + 1e-9) << alpha << " " << seed;
      const auto mission = sail(world, o);
      ASSERT_EQ(mission.objects_seen_twice, mission.objects) << alpha << " " << seed;
    }
  }
}

StripWorld scattered(double width_m, std::uint64_t seed) {
  SeededNumbers numbers(mixed_seed(seed, 31));
  StripWorld world;
  for (std::uint64_t i = 0; i < seed % 12; ++i) {
    world.objects_m.push_back(width_m * numbers.uniform());
  }
  std::sort(world.objects_m.begin(), world.objects_m.end());
  return world;
}

// With a blind strip below the sonar, into which a gap filler looks: an object there is known but
// has been seen from neither side. Objects lie at every place, those strips included.
TEST(Accordion, BlindStripsLoseNoObjectOfEitherRule) {
  for (const AccordionRule rule : {AccordionRule::basic, AccordionRule::bounded}) {
    // The abstract world knows places to 6.25 m: either all lies on that grid, or the clearance
    // takes it in.
    for (const auto& [gap, clearance] : {std::pair(6.25, 0.0), std::pair(5.0, 6.5)}) {
      AccordionOptions o = strip_options(20.6, rule);
      o.length_m = 200.0;
      o.nadir_gap_m = gap;
      o.clearance_m = clearance;
      for (std::uint64_t seed = 0; seed < 400; ++seed) {
        StripWorld world = scattered(o.width_m, seed);
        // At the box's edges no track can pass on the far side of the blind strip.
        std::erase_if(world.objects_m, [&](double x) { return x < 8.0 || x > o.width_m - 8.0; });
        const auto mission = sail(world, o);
        ASSERT_EQ(mission.objects_seen_twice, mission.objects)
            << "seed " << seed << " clearance " << clearance;
        if (rule == AccordionRule::basic) continue;
        ASSERT_LE(excess_in_tracks(world, o), 1.0 + 1e-9) << seed;
      }
    }
  }
}

// Places known to columns of 6.25 m: coarser and finer than the blind strip, with and without a
// clearance. Where they contradict each other a look may be lost, the bound may not.
TEST(Accordion, BoundHoldsWithPlacesKnownRoughly) {
  for (const double gap : {0.0, 2.0, 5.0, 6.25, 8.0, 12.5}) {
    for (const double clearance : {0.0, 1.0, 6.5}) {
      for (const double length : {30.0, 200.0, 1000.0}) {
        AccordionOptions o = strip_options(20.6, AccordionRule::bounded);
        o.length_m = length;
        o.nadir_gap_m = gap;
        o.clearance_m = clearance;
        for (std::uint64_t seed = 0; seed < 400; ++seed) {
          const auto world = scattered(o.width_m, seed);
          ASSERT_LE(excess_in_tracks(world, o), 1.0 + 1e-9)
              << gap << " " << clearance << " " << length << " " << seed;
        }
      }
    }
  }
}

TEST(Accordion, BasicBreaksThatBound) {  // or the test above would prove nothing
  AccordionOptions o = strip_options(40);
  o.length_m = kW;
  std::vector<int> worst;
  for (int s = 0; s < 40; ++s) {
    if (s % 4 != 0) worst.push_back(s);
  }
  EXPECT_GT(excess_in_tracks(chosen_strips(kW, worst), o), 5.0);
}

TEST(Accordion, BoundedIsNoWorseOnAverage) {
  for (const double alpha : {0.01, 0.1, 0.25, 0.5, 1.0, 2.0}) {
    double basic = 0.0;
    double bounded = 0.0;
    for (std::uint64_t i = 0; i < 210; ++i) {
      AccordionOptions o = strip_options(40);
      o.length_m = kW / alpha;
      const auto world =
          random_strips(o.width_m, kW, static_cast<double>(i % 21) / 20.0, mixed_seed(5, i));
      basic += gain(sail(world, o).state).whole_pct;
      o.rule = AccordionRule::bounded;
      bounded += gain(sail(world, o).state).whole_pct;
    }
    EXPECT_GE(bounded, basic) << alpha;
  }
}

AccordionObservation empty_observation() {
  const CostMap map{2, 5, 0.0, 10.0, std::vector<float>(10, 0.1F)};
  return {map, map};
}

TEST(Accordion, ThresholdDecidesWhatIsAnObject) {
  AccordionState state = start_accordion(strip_options(8));
  auto observation = empty_observation();
  observation.ahead.values[7] = 0.6F;
  const auto hit = observe(state, *next_track(state), observation);
  EXPECT_DOUBLE_EQ(next_track(hit)->across_m, kW);
  state.options.threshold = 0.7;
  const auto miss = observe(state, *next_track(state), observation);
  EXPECT_DOUBLE_EQ(next_track(miss)->across_m, 2 * kW);
}

TEST(Accordion, NadirObjectsNeedBothNeighbours) {
  AccordionOptions o = strip_options(8);
  o.nadir_gap_m = 10.0;
  AccordionState state = start_accordion(o);
  CostMap map{1, 6, 0.0, 10.0, std::vector<float>(6, 0.1F)};
  state = observe(state, *next_track(state), {map, map});
  const auto second = *next_track(state);
  EXPECT_DOUBLE_EQ(second.across_m, 2 * kW);
  CostMap below = map;
  below.values[0] = 1.0F;  // within the gap, so seen by neither side of this track
  state = observe(state, second, {map, below});
  EXPECT_DOUBLE_EQ(next_track(state)->across_m, kW);
  state = observe(state, *next_track(state), {map, map});
  EXPECT_DOUBLE_EQ(next_track(state)->across_m, 3 * kW);
}

TEST(Accordion, RefusesBadObservations) {
  const AccordionState state = start_accordion(strip_options(8));
  const SurveyTrack track = *next_track(state);
  const auto refusal = [&](const SurveyTrack& t, const AccordionObservation& observation) {
    return message_of<InvalidInput>([&] { (void)observe(state, t, observation); });
  };
  EXPECT_THAT(refusal({3, 150.0, true}, empty_observation()), HasSubstr("track 3"));
  auto wrong = empty_observation();
  wrong.back.values.pop_back();
  EXPECT_THAT(refusal(track, wrong), HasSubstr("9 values"));
  wrong = empty_observation();
  wrong.ahead.values[3] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THAT(refusal(track, wrong), HasSubstr("cost 3 of the ahead side"));
  wrong = empty_observation();
  wrong.ahead.step_m = 1.0;
  EXPECT_THAT(refusal(track, wrong), HasSubstr("reach the sonar range"));
}

TEST(Accordion, RefusesObservationsThatDoNotSpanTheStrip) {
  AccordionOptions o = strip_options(8);
  o.nadir_gap_m = 5.0;
  const AccordionState state = start_accordion(o);
  const SurveyTrack track = *next_track(state);
  const auto refusal = [&](const CostMap& map) {
    return message_of<InvalidInput>([&] { (void)observe(state, track, {map, map}); });
  };
  // One column at the far end of the strip.
  EXPECT_THAT(refusal({1, 1, 49.0, 6.0, {0.1F}}), HasSubstr("beyond the nadir gap of 5 m"));
  // To the strip's width, but not into the neighbour's nadir gap.
  EXPECT_THAT(refusal({1, 1, 0.0, 50.0, {0.1F}}), HasSubstr("reaches 50 m"));
  CostMap map{1, 1, 0.0, 55.0, {0.1F}};
  map.along_m = 0.01 * kL;
  EXPECT_THAT(refusal(map), HasSubstr("span 4 m along the track; the track is 400 m long"));
  map.along_m = 100.0 * kL;
  EXPECT_THAT(refusal(map), HasSubstr("span 40000 m"));
  map.along_m = 0.97 * kL;
  EXPECT_NO_THROW((void)observe(state, track, {map, map}));
}

// Maps that begin at the nadir gap: no skip may leave the strip below a track unseen.
TEST(Accordion, BlindStripsAreSeenFromNeighbours) {
  for (const AccordionRule rule : {AccordionRule::basic, AccordionRule::bounded}) {
    for (const double first : {5.0, 0.0}) {
      AccordionOptions o{.width_m = 440.0, .length_m = 370.0, .spacing_m = 45.0};
      o.nadir_gap_m = 5.0;
      o.rule = rule;
      AccordionState state = start_accordion(o);
      IntervalSet seen;
      while (const auto track = next_track(state)) {
        CostMap map{1, 10, first, (50.0 - first) / 10.0, std::vector<float>(10, 0.1F)};
        state = observe(state, *track, {map, map});
        seen.add({track->across_m - 50.0, track->across_m - first});
        seen.add({track->across_m + first, track->across_m + 50.0});
        ASSERT_LT(state.sailed.size(), 30U);
      }
      EXPECT_NEAR(seen.covered_m({0.0, 440.0}), 440.0, 1e-6) << first;
      EXPECT_EQ(state.sailed.size() > 8U, first > 0.0) << first;  // a gap filler lets it skip
    }
  }
}

TEST(Accordion, RefusesBadOptions) {
  const auto refusal = [](const AccordionOptions& o) {
    return message_of<UsageError>([&] { check(o); });
  };
  AccordionOptions o = strip_options(8);
  o.width_m = -1.0;
  EXPECT_THAT(refusal(o), HasSubstr("width -1"));
  o = strip_options(8);
  o.spacing_m = 0.0;
  EXPECT_THAT(refusal(o), HasSubstr("spacing 0"));
  o = strip_options(8);
  o.clearance_m = 25.0;
  EXPECT_THAT(refusal(o), HasSubstr("clearance 25"));
  o = strip_options(8);
  o.nadir_gap_m = kW;
  EXPECT_THAT(refusal(o), HasSubstr("nadir gap"));
  o = strip_options(8);
  o.length_m = std::numeric_limits<double>::infinity();
  EXPECT_THAT(refusal(o), HasSubstr("length"));
  o = strip_options(8);
  o.threshold = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal(o), HasSubstr("threshold"));
}

}  // namespace
}  // namespace swathplan
