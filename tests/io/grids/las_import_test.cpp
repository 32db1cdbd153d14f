#include "io/grids/las_import.h"

#include <gmock/gmock.h>

#include <cstdint>
#include <cstring>

#include "io/files/crs.h"
#include "io/import_files.h"

namespace swathplan {
namespace {

using testing::Contains;
using testing::HasSubstr;
using LasImport = ImportFiles;

struct Point {
  std::int32_t x, y, z;
  std::uint8_t type = 0;
};

template <class T>
void put(std::string& bytes, std::size_t at, T value) {
  std::memcpy(&bytes[at], &value, sizeof(T));
}

/// LAS 1.2, point format 0, in centimetres from 500000, 4000000, in EPSG:32633.
std::string las(const std::vector<Point>& points, std::uint8_t format = 0) {
  constexpr std::size_t kHeader = 227, kKeys = 16, kRecord = 54 + kKeys, kSize = 20;
  std::string bytes(kHeader + kRecord + kSize * points.size(), '\0');
  bytes.replace(0, 4, "LASF");
  put<std::uint8_t>(bytes, 24, 1);
  put<std::uint8_t>(bytes, 25, 2);
  put<std::uint16_t>(bytes, 94, kHeader);
  put<std::uint32_t>(bytes, 96, kHeader + kRecord);
  put<std::uint32_t>(bytes, 100, 1);
  put<std::uint8_t>(bytes, 104, format);
  put<std::uint16_t>(bytes, 105, kSize);
  put<std::uint32_t>(bytes, 107, static_cast<std::uint32_t>(points.size()));
  for (std::size_t i = 0; i < 3; ++i) put<double>(bytes, 131 + 8 * i, 0.01);
  put<double>(bytes, 155, 500000.0);
  put<double>(bytes, 163, 4000000.0);
  bytes.replace(kHeader + 2, 15, "LASF_Projection");
  put<std::uint16_t>(bytes, kHeader + 18, 34735);
  put<std::uint16_t>(bytes, kHeader + 20, kKeys);
  put<std::uint16_t>(bytes, kHeader + 54 + 8, 3072);
  put<std::uint16_t>(bytes, kHeader + 54 + 14, 32633);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t at = kHeader + kRecord + kSize * i;
    put(bytes, at, points[i].x);
    put(bytes, at + 4, points[i].y);
    put(bytes, at + 8, points[i].z);
    put(bytes, at + 15, points[i].type);
  }
  return bytes;
}

const std::vector<Point> kFour = {
    {0, 0, -800}, {1000, 0, -900}, {0, 1000, -1000}, {1000, 1000, -1}};

TEST_F(LasImport, ReadsPlacesAndCrs) {
  const auto file = write("a.las", las(kFour));
  ASSERT_TRUE(is_las(file));
  const SurfaceData data = read_las(file, false);
  ASSERT_EQ(data.vertices.size(), 4U);
  EXPECT_EQ(data.vertices[1], Vec3(500010, 4000000, -9));
  EXPECT_THAT(crs_name(data.crs_wkt), HasSubstr("EPSG:32633"));
}

TEST_F(LasImport, LeavesOutNoiseAndWhatIsNotBathymetric) {
  auto points = kFour;
  points[3].type = 7;
  const SurfaceData data = read_las(write("a.las", las(points)), false);
  EXPECT_EQ(data.vertices.size(), 3U);
  EXPECT_THAT(data.notes, Contains(HasSubstr("1 of 4 points were left out")));
}

TEST_F(LasImport, NamesCompressedAndCutOffFiles) {
  const std::string bytes = las(kFour);
  EXPECT_THAT(refusal([&] { return read_las(write("a.laz", las(kFour, 128)), false); }),
              HasSubstr("compressed points (LAZ)"));
  for (const std::size_t length : {4UL, 10UL, 120UL, 230UL, bytes.size() - 1}) {
    EXPECT_THAT(refusal([&] { return read_las(write("b.las", bytes.substr(0, length)), false); }),
                HasSubstr("cut off"))
        << length;
  }
}

}  // namespace
}  // namespace swathplan
