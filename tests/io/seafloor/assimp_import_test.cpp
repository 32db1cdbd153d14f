#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "io/import_files.h"
#include "io/seafloor/assimp_internal.h"

namespace swathplan {
namespace {

using AssimpImport = ImportFiles;

TEST_F(AssimpImport, GltfIsTurnedUpright) {
  // y up: x east, y up, z south. The triangle (0,-5,0), (10,-6,0), (0,-7,-10).
  const float corners[9] = {0, -5, 0, 10, -6, 0, 0, -7, -10};
  std::string buffer(sizeof corners, '\0');
  std::memcpy(buffer.data(), corners, sizeof corners);
  write("a.bin", buffer);
  const SurfaceData data = read_with_assimp(write(
      "a.gltf",
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],)"
      R"("nodes":[{"mesh":0,"translation":[100,0,0]}],)"
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
      R"("buffers":[{"uri":"a.bin","byteLength":36}],"bufferViews":[{"buffer":0,"byteLength":36}],)"
      R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",)"
      R"("min":[0,-7,-10],"max":[10,-5,0]}]})"));
  ASSERT_EQ(data.vertices.size(), 3U);
  EXPECT_THAT(data.vertices,
              testing::UnorderedElementsAre(Vec3(100, 0, -5), Vec3(110, 0, -6), Vec3(100, 10, -7)));
  EXPECT_THAT(data.notes, testing::Contains(testing::HasSubstr("y up")));
}

TEST_F(AssimpImport, RefusesGarbageAndNamesTheFile) {
  EXPECT_THAT(refusal([&] { return read_with_assimp(write("g.glb", garbage(3000))); }),
              testing::HasSubstr("g.glb"));
}

}  // namespace
}  // namespace swathplan
