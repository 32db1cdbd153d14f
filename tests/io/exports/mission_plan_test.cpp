#include "io/exports/mission_plan.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "io/exports/exported.h"
#include "io/files/lonlat.h"

namespace swathplan {
namespace {

using PlanJson = nlohmann::json;

std::set<std::string> members(const PlanJson& node) {
  std::set<std::string> names;
  for (const auto& [name, value] : node.items()) names.insert(name);
  return names;
}

using Names = std::set<std::string>;

/// Reads as a strict ground station: these members, no others, each of its type.
struct StrictPlan {
  explicit StrictPlan(const PlanJson& plan) {
    EXPECT_EQ(members(plan), (Names{"fileType", "version", "groundStation", "mission", "geoFence",
                                    "rallyPoints"}));
    EXPECT_EQ(plan.at("fileType"), "Plan");
    EXPECT_EQ(plan.at("version"), 1);
    EXPECT_EQ(plan.at("geoFence"), PlanJson::parse(R"({"circles":[],"polygons":[],"version":2})"));
    EXPECT_EQ(plan.at("rallyPoints"), PlanJson::parse(R"({"points":[],"version":2})"));
    const PlanJson& mission = plan.at("mission");
    EXPECT_EQ(members(mission),
              (Names{"version", "firmwareType", "vehicleType", "globalPlanAltitudeMode",
                     "cruiseSpeed", "hoverSpeed", "plannedHomePosition", "items"}));
    EXPECT_EQ(mission.at("version"), 2);
    EXPECT_EQ(mission.at("firmwareType"), 3) << "MAV_AUTOPILOT_ARDUPILOTMEGA";
    EXPECT_EQ(mission.at("vehicleType"), 11) << "MAV_TYPE_SURFACE_BOAT";
    home = mission.at("plannedHomePosition").get<std::vector<double>>();
    EXPECT_EQ(home.size(), 3U);
    double speed = 0.0;
    int number = 0;
    for (const PlanJson& item : mission.at("items")) {
      EXPECT_EQ(item.at("type"), "SimpleItem");
      EXPECT_EQ(item.at("doJumpId"), ++number);
      EXPECT_EQ(item.at("autoContinue"), true);
      const PlanJson& params = item.at("params");
      EXPECT_EQ(params.size(), 7U);
      if (item.at("command") == 178) {
        EXPECT_EQ(params.at(0), 1) << "ground speed";
        EXPECT_EQ(params.at(2), -1) << "throttle as it is";
        speed = params.at(1).get<double>();
        continue;
      }
      EXPECT_EQ(item.at("command"), 16);
      EXPECT_EQ(item.at("frame"), 3);
      EXPECT_TRUE(params.at(3).is_null()) << "no heading asked for";
      lonlat.emplace_back(params.at(5).get<double>(), params.at(4).get<double>());
      speeds.push_back(speed);
    }
  }
  std::vector<double> home;
  std::vector<Vec2> lonlat;
  std::vector<double> speeds;  ///< on the way to each
};

TEST(MissionPlan, IsWhatAStrictReaderAsksFor) {
  const test::Exported exported(ExportFormat::plan);
  const StrictPlan plan(PlanJson::parse(test::text_of(exported.file())));
  EXPECT_EQ(plan.lonlat.size(), exported.done.waypoints);
  EXPECT_EQ(plan.home[0], plan.lonlat[0].y());
  EXPECT_EQ(plan.home[1], plan.lonlat[0].x());
  EXPECT_LE(test::largest_distance(exported.route, LonLat(exported.frame).to_local(plan.lonlat)),
            0.101);
  EXPECT_EQ(plan.speeds[0], 2.0) << "set before the first";
  EXPECT_EQ(plan.speeds[1], 2.0);
  EXPECT_EQ(plan.speeds[2], 1.5) << "in the turn";
  EXPECT_EQ(plan.speeds.back(), 2.0);
}

}  // namespace
}  // namespace swathplan
