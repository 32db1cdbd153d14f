// What comes with the installed program.
#include <gmock/gmock.h>

#include "cli/program.h"

namespace swathplan {
namespace {

using test::Folder;
using testing::ContainsRegex;
using testing::StartsWith;

TEST(Version, NamesTheProgramAndItsLibraries) {
  const Folder folder;
  const auto run = folder.run("--version");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, StartsWith("swathplan "));
  for (const char* library : {"assimp", "Boost", "CGAL", "CLI11", "Clipper", "Eigen", "Embree",
                              "fmt", "GDAL", "Ipopt", "JSON", "oneTBB", "OpenCV", "PROJ"}) {
    EXPECT_THAT(run.out, ContainsRegex(std::string(library) + " +[0-9]+\\.[0-9]+"));
  }
}

}  // namespace
}  // namespace swathplan
