#include "io/files/gdal_at_home.h"

#include <gmock/gmock.h>

#include <fstream>
#include <string>

#include "io/files/crs.h"
#include "mesh/base/error.h"
#include "temporary_folder.h"

namespace swathplan {
namespace {

using testing::HasSubstr;

class GdalAtHome : public testing::Test {
 protected:
  std::filesystem::path written(const std::string& name, const std::string& text) {
    std::filesystem::create_directories((folder_.path() / name).parent_path());
    std::ofstream(folder_.path() / name) << text;
    return folder_.path() / name;
  }
  std::filesystem::path virtual_raster(const std::string& source, const std::string& name) {
    return written(name,
                   "<VRTDataset><VRTRasterBand><SimpleSource><SourceFilename "
                   "relativeToVRT=\"1\">" +
                       source + "</SourceFilename></SimpleSource></VRTRasterBand></VRTDataset>");
  }
  static std::string verdict(const std::filesystem::path& file) {
    try {
      check_sources_stay_beside(file);
    } catch (const InvalidInput& e) {
      return e.what();
    }
    return "accepted";
  }

 private:
  test::TemporaryFolder folder_;
};

TEST_F(GdalAtHome, AVirtualFileMayDrawOnFilesBesideIt) {
  EXPECT_EQ(verdict(virtual_raster("tile.tif", "a.vrt")), "accepted");
  EXPECT_EQ(verdict(virtual_raster("tiles/1.tif", "b.vrt")), "accepted");
  EXPECT_EQ(verdict(written("plain.asc", "ncols 3")), "accepted");
}

TEST_F(GdalAtHome, AVirtualFileMayNotReachElsewhere) {
  for (const char* source :
       {"/etc/passwd", "../up.tif", "tiles/../../up.tif", "/vsicurl/http://127.0.0.1/x.tif",
        "http://127.0.0.1/x.tif", "PG:host=127.0.0.1", "vsi/vsicurl/x", "&#47;etc/passwd"}) {
    EXPECT_THAT(verdict(virtual_raster(source, "a.vrt")),
                HasSubstr("may only draw on files beside"))
        << source;
  }
  EXPECT_THAT(verdict(written("raw.vrt",
                              "<VRTDataset><VRTRasterBand subClass=\"VRTRawRasterBand\">"
                              "<SourceFilename>x</SourceFilename>")),
              HasSubstr("raw bytes"));
}

TEST_F(GdalAtHome, SourcesOfSourcesAreHeldToTheSame) {
  virtual_raster("/etc/passwd", "inner.vrt");
  EXPECT_THAT(verdict(virtual_raster("inner.vrt", "outer.vrt")), HasSubstr("inner.vrt"));
  EXPECT_THAT(verdict(virtual_raster("loop.vrt", "loop.vrt")), HasSubstr("itself"));
}

TEST(Crs, TextThatNamesAnAddressOrAFileIsNotFollowed) {
  EXPECT_THROW(static_cast<void>(parse_crs("http://127.0.0.1:9/4326")), UsageError);
  EXPECT_THROW(static_cast<void>(parse_crs("/etc/hostname")), UsageError);
}

}  // namespace
}  // namespace swathplan
