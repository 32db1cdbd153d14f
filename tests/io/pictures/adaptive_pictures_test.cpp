#include "io/pictures/adaptive_pictures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "mesh/base/error.h"
#include "temporary_folder.h"

namespace swathplan {
namespace {

std::string png_bytes(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

TEST(AdaptivePictures, AWaterfallComesBackAsFarAsEightBitsHoldIt) {
  const test::TemporaryFolder folder;
  SideScanImage image{.rows = 2,
                      .columns = 3,
                      .pixel_m = 0.1,
                      .row_m = 0.2,
                      .nadir_gap_m = 1.0,
                      .port = {0.0F, 0.1F, 0.2F, 0.3F, 0.4F, 0.5F},
                      .starboard = {0.6F, 0.7F, 0.8F, 0.9F, 1.0F, 0.05F}};
  write_waterfall_png(folder.path() / "w.png", image);
  const SideScanImage back = read_waterfall_png(folder.path() / "w.png", 0.1, 0.2, 1.0);
  ASSERT_EQ(back.rows, image.rows);
  ASSERT_EQ(back.columns, image.columns);
  EXPECT_EQ(back.nadir_gap_m, 1.0);
  for (std::size_t i = 0; i < image.port.size(); ++i) {
    // One of 256 tones is at most 2.5 / 255 of intensity.
    EXPECT_NEAR(back.port[i], image.port[i], 0.011) << i;
    EXPECT_NEAR(back.starboard[i], image.starboard[i], 0.011) << i;
  }
}

TEST(AdaptivePictures, RefusesWhatIsNoWaterfall) {
  const test::TemporaryFolder folder;
  EXPECT_THROW((void)read_waterfall_png(folder.path() / "none.png", 0.1, 0.2, 0.0), InvalidInput);
  std::ofstream(folder.path() / "text.png") << "no picture";
  EXPECT_THROW((void)read_waterfall_png(folder.path() / "text.png", 0.1, 0.2, 0.0), InvalidInput);
}

TEST(AdaptivePictures, TheSameChartGivesTheSameBytes) {
  const test::TemporaryFolder folder;
  const Chart chart{"Cover",
                    "passes",
                    "share",
                    {{"a", {0, 1, 2}, {0, 0.5, 0.75}, false}, {"b", {0, 2}, {0.1, 0.2}, true}}};
  write_chart_png(folder.path() / "a.png", chart);
  write_chart_png(folder.path() / "b.png", chart);
  const std::string bytes = png_bytes(folder.path() / "a.png");
  EXPECT_TRUE(bytes.starts_with("\x89PNG"));
  EXPECT_TRUE(bytes == png_bytes(folder.path() / "b.png"));
}

TEST(AdaptivePictures, TracksOfSeveralBoxesStandInOnePicture) {
  const test::TemporaryFolder folder;
  TrackPicture picture;
  picture.title = "Box";
  picture.width_m = 100.0;
  picture.length_m = 50.0;
  picture.tracks = {{0, 10.0, true}, {1, 30.0, false}};
  write_tracks_png(folder.path() / "one.png", {picture});
  write_tracks_png(folder.path() / "two.png", {picture, picture});
  // Bytes 20 to 23 of a PNG hold its height.
  const auto height = [&](const char* name) {
    const std::string bytes = png_bytes(folder.path() / name);
    return 256 * static_cast<unsigned char>(bytes.at(22)) +
           static_cast<unsigned char>(bytes.at(23));
  };
  EXPECT_EQ(height("two.png"), 2 * height("one.png"));
}

TEST(AdaptivePictures, TracksKeepTheirProportions) {
  const test::TemporaryFolder folder;
  const auto height = [&](double width_m, double length_m) {
    TrackPicture picture;
    picture.width_m = width_m;
    picture.length_m = length_m;
    picture.tracks = {{0, 10.0, true}};
    write_tracks_png(folder.path() / "p.png", {picture});
    const std::string bytes = png_bytes(folder.path() / "p.png");
    return 256 * static_cast<unsigned char>(bytes.at(22)) +
           static_cast<unsigned char>(bytes.at(23));
  };
  const int margins = 2 * height(200.0, 50.0) - height(200.0, 100.0);
  EXPECT_GT(margins, 0);
  // 716 pixels are left for the longer side.
  EXPECT_EQ(height(200.0, 100.0) - margins, 358);
  EXPECT_EQ(height(100.0, 200.0), height(200.0, 100.0));  // lies on its side
}

}  // namespace
}  // namespace swathplan
