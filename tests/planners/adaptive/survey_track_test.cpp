#include "planners/adaptive/survey_track.h"

#include <gtest/gtest.h>

namespace swathplan {
namespace {

SurveyBox box(StartCorner corner) {
  return {Vec2(100.0, 200.0), Angle::degrees(0), 300.0, 50.0, corner};
}

TEST(SurveyTrack, StartsInTheCornerThatIsNamed) {
  EXPECT_TRUE(box_point(box(StartCorner::south_west), 0, 0).isApprox(Vec2(100, 200)));
  EXPECT_TRUE(box_point(box(StartCorner::south_east), 0, 0).isApprox(Vec2(400, 200)));
  EXPECT_TRUE(box_point(box(StartCorner::north_west), 0, 0).isApprox(Vec2(100, 250)));
  EXPECT_TRUE(box_point(box(StartCorner::north_east), 0, 0).isApprox(Vec2(400, 250)));
}

TEST(SurveyTrack, RotatesWithTheAzimuth) {
  SurveyBox turned = box(StartCorner::south_west);
  turned.azimuth = Angle::degrees(90);  // tracks run east, the next one lies south
  EXPECT_TRUE(box_point(turned, 10, 20).isApprox(Vec2(120, 190), 1e-12));
}

// The vehicle's own left hand, from the course and the positions alone.
TEST(SurveyTrack, PortIsLeftOfTheCourse) {
  for (const StartCorner corner : {StartCorner::south_west, StartCorner::south_east,
                                   StartCorner::north_west, StartCorner::north_east}) {
    for (const bool outbound : {true, false}) {
      const SurveyBox b = box(corner);
      const SurveyTrack track{0, 60.0, outbound};
      const Vec2 from = box_point(b, 60.0, outbound ? 0.0 : b.length_m);
      const Vec2 course = box_point(b, 60.0, outbound ? b.length_m : 0.0) - from;
      const Vec2 back = box_point(b, 50.0, outbound ? 0.0 : b.length_m) - from;
      const double left = course.x() * back.y() - course.y() * back.x();
      EXPECT_EQ(port_looks_back(b, track), left > 0.0) << name(corner) << outbound;
    }
  }
}

TEST(SurveyTrack, RouteIsValidAndAsLongAsTheMission) {
  const std::vector<SurveyTrack> tracks{{0, 0, true}, {1, 100, false}, {2, 50, true}};
  const Route route = mission_route(box(StartCorner::north_east), tracks);
  EXPECT_EQ(fault(route), std::nullopt);
  EXPECT_NEAR(length_m(route), mission_length_m(tracks, 50.0), 1e-9);
  EXPECT_NEAR(mission_length_m(tracks, 50.0), 3 * 50.0 + 100.0 + 50.0, 1e-9);
  EXPECT_TRUE(mission_route(box(StartCorner::south_west), {}).waypoints.empty());
}

TEST(SurveyTrack, WayBackCountsWhenATrackRunsTheSameWay) {
  const std::vector<SurveyTrack> tracks{{0, 0, true}, {1, 30, true}};
  EXPECT_NEAR(mission_length_m(tracks, 40.0), 40.0 + 50.0 + 40.0, 1e-9);
}

TEST(SurveyTrack, CornerNamesReadBack) {
  for (const char* text : {"sw", "se", "nw", "ne"}) EXPECT_EQ(name(*start_corner(text)), text);
  EXPECT_EQ(start_corner("south"), std::nullopt);
}

}  // namespace
}  // namespace swathplan
