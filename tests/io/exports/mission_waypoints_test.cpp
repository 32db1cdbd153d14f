#include "io/exports/mission_waypoints.h"

#include <gtest/gtest.h>

#include <sstream>

#include "io/files/lonlat.h"
#include "io/sample_plan.h"
#include "io/sample_route.h"

namespace swathplan {
namespace {

struct Item {
  int index, current, frame, command;
  double parameter[4], latitude, longitude, altitude;
  int goes_on;
};

/// Reads as ground stations do: a first line that names the version, twelve fields with tabs.
std::vector<Item> parse(const std::string& text) {
  std::istringstream in(text);
  std::string line;
  std::getline(in, line);
  EXPECT_EQ(line, "QGC WPL 110");
  std::vector<Item> items;
  while (std::getline(in, line)) {
    EXPECT_EQ(std::count(line.begin(), line.end(), '\t'), 11) << line;
    std::istringstream fields(line);
    Item i{};
    fields >> i.index >> i.current >> i.frame >> i.command >> i.parameter[0] >> i.parameter[1] >>
        i.parameter[2] >> i.parameter[3] >> i.latitude >> i.longitude >> i.altitude >> i.goes_on;
    EXPECT_FALSE(fields.fail()) << line;
    items.push_back(i);
  }
  return items;
}

std::vector<Vec2> path_of(const std::vector<Item>& items, const Frame& frame) {
  std::vector<Vec2> lonlat;
  for (std::size_t i = 1; i < items.size(); ++i) {
    if (items[i].command == 16) lonlat.emplace_back(items[i].longitude, items[i].latitude);
  }
  return LonLat(frame).to_local(lonlat);
}

TEST(MissionWaypoints, LeadAlongTheRouteAtItsSpeeds) {
  const Frame frame = test::utm_frame();
  const Route route = test::lawnmower(4);
  const auto missions = mission_waypoints(geographic_route(route, frame, 0.1));
  ASSERT_EQ(missions.size(), 1U);
  const std::vector<Item> items = parse(missions[0].text);
  ASSERT_EQ(items.size(), missions[0].items);
  EXPECT_EQ(items[0].current, 1);
  EXPECT_EQ(items[0].frame, 0);
  EXPECT_EQ(items[0].command, 16);
  std::vector<double> speeds;
  for (std::size_t i = 0; i < items.size(); ++i) {
    EXPECT_EQ(items[i].index, static_cast<int>(i));
    EXPECT_EQ(items[i].goes_on, 1);
    EXPECT_EQ(items[i].altitude, 0.0);
    if (i == 0) continue;
    EXPECT_EQ(items[i].current, 0);
    EXPECT_EQ(items[i].frame, 3);
    if (items[i].command == 178) {
      EXPECT_EQ(items[i].parameter[0], 1.0) << "ground speed";
      EXPECT_EQ(items[i].parameter[2], -1.0) << "throttle";
      speeds.push_back(items[i].parameter[1]);
    } else {
      EXPECT_EQ(items[i].command, 16);
    }
  }
  EXPECT_EQ(speeds, (std::vector<double>{2.0, 1.5, 2.0, 1.5, 2.0, 1.5, 2.0}));
  const std::vector<Vec2> path = path_of(items, frame);
  EXPECT_LE(test::largest_distance(route, path), 0.101);
  EXPECT_LT((path.front() - route.waypoints.front().position).norm(), 0.001);
  // The speed of a leg is set before the waypoint that it leads to: here the end of line 1.
  EXPECT_EQ(items[1].command, 178);
  EXPECT_EQ(items[4].command, 178);
  EXPECT_NEAR(LonLat(frame).to_local({Vec2(items[3].longitude, items[3].latitude)})[0].y(), 100.0,
              0.001);
}

TEST(MissionWaypoints, PartsJoinAndEndWithLines) {
  const Frame frame = test::utm_frame();
  const Route route = test::lawnmower(9);
  const GeographicRoute whole = geographic_route(route, frame, 0.1);
  for (const std::size_t most : {std::size_t{4}, std::size_t{7}, std::size_t{40}}) {
    const auto missions = mission_waypoints(whole, most);
    ASSERT_GT(missions.size(), 1U);
    std::vector<Vec2> path;
    for (const Mission& mission : missions) {
      EXPECT_LE(mission.items, most);
      const std::vector<Item> items = parse(mission.text);
      ASSERT_EQ(items.size(), mission.items);
      ASSERT_EQ(items[1].command, 178);
      const std::vector<Vec2> part = path_of(items, frame);
      ASSERT_GE(part.size(), 2U);
      if (!path.empty()) {
        EXPECT_LT((part.front() - path.back()).norm(), 1e-6);
      }
      path.insert(path.end(), part.begin() + (path.empty() ? 0 : 1), part.end());
      if (most == 40) {
        const double y = part.back().y();
        EXPECT_LT(std::min(std::abs(y), std::abs(y - 100.0)), 0.001) << "ends a line";
      }
    }
    ASSERT_EQ(path.size(), whole.lonlat.size());
    EXPECT_LE(test::largest_distance(route, path), 0.101);
  }
  EXPECT_EQ(mission_waypoints(whole, 100000).size(), 1U);
}

}  // namespace
}  // namespace swathplan
