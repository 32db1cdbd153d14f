#include "io/exports/route_export.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <stdexcept>

#include "io/exports/exported.h"
#include "io/sample_plan.h"
#include "io/sample_route.h"
#include "mesh/base/error.h"
#include "temporary_folder.h"

namespace swathplan {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::string export_refusal(const std::function<void()>& act) {
  try {
    act();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(ExportRoute, RefusesDegreesWithoutACrsAndWritesNothing) {
  const test::TemporaryFolder folder;
  const PlacedRoute placed{test::lawnmower(2), {}, nullptr};
  const auto act = [&] {
    (void)export_route(folder.path(), "route", placed, placed,
                       {{ExportFormat::lnw, ExportFormat::gpx}, 0.1, 0});
  };
  EXPECT_THROW(act(), InvalidInput);
  EXPECT_THAT(export_refusal(act),
              testing::AllOf(HasSubstr("gpx"), HasSubstr("<CRS>"), HasSubstr("lnw")));
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(ExportRoute, NamesOptionsThatBreakTheirRules) {
  EXPECT_THROW(check(ExportOptions{{}, 0.0, 0}), UsageError);
  EXPECT_THROW(check(ExportOptions{{}, -1.0, 0}), UsageError);
  EXPECT_THROW(check(ExportOptions{{}, std::nan(""), 0}), UsageError);
  EXPECT_THROW(check(ExportOptions{{}, 0.1, 3}), UsageError);
  EXPECT_NO_THROW(check(ExportOptions{{}, 0.1, 4}));
  EXPECT_THAT(export_refusal([] { (void)export_format("shp"); }),
              testing::AllOf(HasSubstr("shp"), HasSubstr("waypoints, plan, gpx, rtz")));
  for (const ExportFormat format : all_export_formats()) {
    EXPECT_EQ(export_format(name(format)), format);
  }
}

TEST(ExportRoute, NoOtherFormatStandsInForAnUnknownOne) {
  const auto unknown = static_cast<ExportFormat>(99);
  EXPECT_THROW((void)name(unknown), std::logic_error);
  EXPECT_THROW((void)is_geographic(unknown), std::logic_error);
  const test::TemporaryFolder folder;
  const PlacedRoute placed{test::lawnmower(2), test::utm_frame(), nullptr};
  EXPECT_THROW((void)export_route(folder.path(), "route", placed, placed, {{unknown}, 0.1, 0}),
               std::logic_error);
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(ExportRoute, WarnsOfMissionsThatAutopilotsCannotHold) {
  const Route many = test::lawnmower(120);
  const test::Exported mission(ExportFormat::waypoints, many);
  ASSERT_EQ(mission.done.warnings.size(), 1U);
  EXPECT_THAT(mission.done.warnings[0], testing::AllOf(HasSubstr("724"), HasSubstr("tolerance")));
  EXPECT_TRUE(test::Exported(ExportFormat::waypoints).done.warnings.empty());
}

TEST(ExportRoute, RemovesOlderExportsAndNothingElse) {
  const test::TemporaryFolder folder;
  const PlacedRoute placed{test::lawnmower(9), test::utm_frame(), nullptr};
  (void)export_route(folder.path(), "route", placed, placed,
                     {{ExportFormat::waypoints, ExportFormat::gpx}, 0.1, 20});
  for (const char* other : {"route.csv", "route-old.waypoints", "other.gpx", "route-1.txt"}) {
    std::ofstream(folder.path() / other) << "kept";
  }
  EXPECT_TRUE(fs::exists(folder.path() / "route-1.waypoints") ||
              fs::exists(folder.path() / "route-01.waypoints"));
  remove_exports(folder.path(), "route", all_export_formats());
  std::set<std::string> left;
  for (const auto& entry : fs::directory_iterator(folder.path())) {
    left.insert(entry.path().filename().string());
  }
  EXPECT_EQ(left, (std::set<std::string>{"route.csv", "route-old.waypoints", "other.gpx",
                                         "route-1.txt"}));
}

}  // namespace
}  // namespace swathplan
