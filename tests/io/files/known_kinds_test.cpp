#include "io/files/known_kinds.h"

#include <gmock/gmock.h>

#include "io/import_files.h"

namespace swathplan {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using KnownKinds = ImportFiles;

TEST_F(KnownKinds, AreNamedByTheirFirstBytes) {
  const auto says = [&](const std::string& name, const std::string& bytes) {
    return refusal([&] {
      refuse_foreign(write(name, bytes));
      return 0;
    });
  };
  const std::string tail(64, '\0');
  std::string all("\x10\x00\x00\x00\x02I", 6);
  all += std::string(11, '\0') + '\x03' + tail;
  EXPECT_THAT(says("a.all", all), HasSubstr("Kongsberg ALL"));
  EXPECT_THAT(says("a.kmall", std::string("\x40\x01\x00\x00#IIP", 8) + tail), HasSubstr("KMALL"));
  EXPECT_THAT(says("a.s7k", std::string("\x05\x00\x40\x00\xFF\xFF\x00\x00", 8) + tail),
              HasSubstr("S7K"));
  EXPECT_THAT(says("a.gsf", std::string("\0\0\0\x0C\0\0\0\x0CGSF-v03.09", 18) + tail),
              HasSubstr("GSF"));
  EXPECT_THAT(says("a.grd", std::string("CDF\x01\0\0\0\0", 8) + "side  xysize  x_range" + tail),
              AllOf(HasSubstr("GMT"), HasSubstr("grdconvert")));
  EXPECT_THAT(says("a.csar", tail), HasSubstr("CARIS"));
  EXPECT_THAT(says("a.7z", "7z\xBC\xAF\x27\x1C" + tail), HasSubstr("unpack it first"));
  EXPECT_THAT(says("a.tif", "<!DOCTYPE html><html>"), HasSubstr("web page"));
  EXPECT_THAT(says("a.tif", "version https://git-lfs.github.com/spec/v1\n"), HasSubstr("git lfs"));
}

TEST_F(KnownKinds, TextUnderTheirNamesMayBeSoundings) {
  EXPECT_NO_THROW(refuse_foreign(write("a.all", "500000 4000000 -8\n500010 4000000 -9\n")));
  EXPECT_NO_THROW(refuse_foreign(write("a.xtf", "500000 4000000 -8\n")));
  EXPECT_NO_THROW(refuse_foreign(write("a.kmall", "1")));
}

}  // namespace
}  // namespace swathplan
