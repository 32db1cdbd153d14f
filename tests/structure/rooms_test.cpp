// The source tree is what cmake/rooms.cmake says it is: arrows, cellars, sizes of rooms.
#include <gmock/gmock.h>

#include <filesystem>
#include <map>

#include "structure/include_rules.h"

namespace swathplan::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kRoot = SWATHPLAN_SOURCE_DIR;
constexpr int kMostFiles = 30;  // in a room

Arrows declared() { return read_arrows(SWATHPLAN_ROOMS_FILE); }

std::vector<std::string> sources(const std::string& folder) {
  std::vector<std::string> found;
  for (const auto& entry : fs::recursive_directory_iterator(kRoot + "/" + folder)) {
    const fs::path& path = entry.path();
    if (path.extension() != ".h" && path.extension() != ".cpp") continue;
    found.push_back(fs::relative(path, kRoot).generic_string());
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<std::string> faults_below(const std::string& folder) {
  const Arrows arrows = declared();
  std::vector<std::string> found;
  for (const std::string& file : sources(folder)) {
    for (const Include& include : read_includes(kRoot, file)) {
      if (std::string what = fault(include, arrows); !what.empty()) found.push_back(what);
    }
  }
  return found;
}

TEST(Rooms, FilesIncludeAlongDeclaredArrowsOnly) {
  EXPECT_THAT(faults_below("src"), IsEmpty());
  EXPECT_THAT(faults_below("apps"), IsEmpty());
}

TEST(Rooms, TestsLookIntoTheirOwnRoomOnly) { EXPECT_THAT(faults_below("tests"), IsEmpty()); }

TEST(Rooms, ArrowsFormNoCircleAndPointOneWay) { EXPECT_THAT(faults(declared()), IsEmpty()); }

TEST(Rooms, EveryFolderOfSourcesIsDeclared) {
  const Arrows arrows = declared();
  for (const std::string folder : {"src", "apps"}) {
    for (const std::string& file : sources(folder)) {
      EXPECT_EQ(arrows.count(room_of(file)), 1U) << file;
    }
  }
}

TEST(Rooms, NoRoomHoldsMoreThanThirtyFiles) {
  std::map<std::string, int> files;
  for (const std::string folder : {"src", "apps"}) {
    for (const std::string& file : sources(folder)) ++files[room_of(file)];
  }
  for (const auto& [room, count] : files) EXPECT_LE(count, kMostFiles) << room;
}

const Arrows kSmall{{"mesh", {}}, {"mesh/plane", {}}, {"coverage", {"mesh"}}};

TEST(IncludeRules, KnowRoomsByTheirFolders) {
  EXPECT_EQ(room_of("src/mesh/plane/box.h"), "mesh/plane");
  EXPECT_EQ(room_of("mesh/seafloor.h"), "mesh");
  EXPECT_EQ(room_of("tests/mesh/plane/box_test.cpp"), "mesh/plane");
  EXPECT_EQ(room_of("apps/main.cpp"), "apps");
  EXPECT_EQ(room_of("seafloor.h"), "");
}

TEST(IncludeRules, AllowDeclaredArrowsAndTheOwnRoom) {
  EXPECT_EQ(fault({"src/coverage/score.cpp", 3, "mesh/seafloor.h", true}, kSmall), "");
  EXPECT_EQ(fault({"src/mesh/seafloor.cpp", 1, "mesh/needles_internal.h", true}, kSmall), "");
}

TEST(IncludeRules, NameAnArrowThatWasNotDeclared) {
  EXPECT_THAT(fault({"src/mesh/seafloor.cpp", 7, "coverage/score.h", true}, kSmall),
              HasSubstr("src/mesh/seafloor.cpp:7: mesh may not use coverage"));
  EXPECT_THAT(fault({"src/io/crs.cpp", 1, "mesh/seafloor.h", true}, kSmall),
              HasSubstr("no room 'io'"));
}

TEST(IncludeRules, KeepInternalHeadersInTheirRoom) {
  const std::string why = "mesh/needles_internal.h is internal to mesh";
  EXPECT_THAT(fault({"src/coverage/score.cpp", 9, "mesh/needles_internal.h", true}, kSmall),
              HasSubstr(why));
  EXPECT_THAT(fault({"tests/coverage/score_test.cpp", 9, "mesh/needles_internal.h", true}, kSmall),
              HasSubstr(why));
  EXPECT_EQ(fault({"tests/mesh/needles_test.cpp", 9, "mesh/needles_internal.h", true}, kSmall), "");
}

TEST(IncludeRules, KeepForeignHeadersOutOfPublicOnes) {
  EXPECT_THAT(fault({"src/mesh/seafloor.h", 4, "CGAL/Surface_mesh.h", false}, kSmall),
              HasSubstr("belongs into .cpp files"));
  EXPECT_EQ(fault({"src/mesh/seafloor.cpp", 4, "CGAL/Surface_mesh.h", false}, kSmall), "");
  EXPECT_EQ(fault({"src/mesh/seafloor.h", 4, "vector", false}, kSmall), "");
}

TEST(IncludeRules, FindCirclesAndArrowsAgainstTheOrder) {
  EXPECT_THAT(faults({{"mesh", {"mesh/plane"}}, {"mesh/plane", {"mesh"}}}), testing::SizeIs(2));
  EXPECT_THAT(faults({{"mesh", {"coverage"}}}), testing::ElementsAre(HasSubstr("against")));
  EXPECT_THAT(faults({{"planners/adaptive", {"planners/nuc"}}}),
              testing::ElementsAre(HasSubstr("adaptive")));
  EXPECT_THAT(faults(kSmall), IsEmpty());
}

}  // namespace
}  // namespace swathplan::test
