#include <gmock/gmock.h>

#include "io/report/pictures_internal.h"
#include "io/sample_judged.h"

namespace swathplan {
namespace {

TEST(TvuPicture, ShowsTheWorstCellOfAPixelNorthUp) {
  UncertaintyRaster raster = test::judged_survey().raster;  // 3 x 2 cells
  raster.tvu_share = {0.05F, 0.55F, 1.2F, 0.999F, JudgedCell::kNone, JudgedCell::kNone};
  const internal::TvuPicture fine = internal::tvu_picture(raster, 100);
  EXPECT_THAT(fine.picture.pixels, ::testing::ElementsAre(10, 0, 0, 1, 6, 11));
  EXPECT_EQ(fine.picture.palette.size(), 12U);
  EXPECT_TRUE(fine.box.max.isApprox(Vec2(1.5, 1.0)));
  const internal::TvuPicture coarse = internal::tvu_picture(raster, 2);
  EXPECT_THAT(coarse.picture.pixels, ::testing::ElementsAre(10, 11));
  EXPECT_TRUE(coarse.box.max.isApprox(Vec2(2.0, 1.0)));
}

}  // namespace
}  // namespace swathplan
