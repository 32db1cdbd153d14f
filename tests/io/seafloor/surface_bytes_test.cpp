#include "io/seafloor/surface_bytes.h"

#include <gtest/gtest.h>

#include "mesh/base/error.h"

namespace swathplan {
namespace {

SurfaceData a_surface() {
  SurfaceData data;
  data.vertices = {{0.1, 4797000.456, -1e-300}, {1, 2, 3}, {-0.0, 5, 6}};
  data.faces = {{0, 1, 2}, {2, 1, 0}};
  data.crs_wkt = "LOCAL_CS[\"x\"]";
  data.format = "PLY";
  data.z_is_depth = true;
  data.spacing = 0.3;
  data.float_step = 0.0625;
  data.notes = {"one", ""};
  data.warnings = {"careful"};
  return data;
}

TEST(SurfaceBytes, ComeBackBitForBit) {
  const SurfaceData data = a_surface();
  const std::string bytes = to_bytes(data);
  const SurfaceData back = surface_from_bytes(bytes);
  EXPECT_EQ(to_bytes(back), bytes);
  EXPECT_EQ(back.vertices[0].y(), 4797000.456);
  EXPECT_EQ(back.faces, data.faces);
  EXPECT_EQ(back.notes, data.notes);
  EXPECT_EQ(back.warnings, data.warnings);
  EXPECT_TRUE(back.z_is_depth);
  EXPECT_FALSE(back.is_clean);
}

TEST(SurfaceBytes, AreRefusedWhereverTheyAreCutShort) {
  const std::string bytes = to_bytes(a_surface());
  for (std::size_t n = 0; n < bytes.size(); ++n) {
    EXPECT_THROW(static_cast<void>(surface_from_bytes(std::string_view(bytes).substr(0, n))),
                 InvalidInput)
        << n;
  }
}

}  // namespace
}  // namespace swathplan
