#include "io/files/unpacked.h"

#include <cpl_vsi.h>
#include <gmock/gmock.h>

#include "io/files/text.h"
#include "io/import_files.h"

namespace swathplan {
namespace {

using testing::HasSubstr;
using UnpackedFiles = ImportFiles;

/// Writes through one of GDAL's virtual file systems.
void put(const std::string& target, const std::string& text) {
  VSILFILE* file = VSIFOpenL(target.c_str(), "wb");
  ASSERT_NE(file, nullptr) << target;
  EXPECT_EQ(VSIFWriteL(text.data(), 1, text.size(), file), text.size());
  EXPECT_EQ(VSIFCloseL(file), 0);
}

std::filesystem::path zip(const std::filesystem::path& path,
                          const std::vector<std::string>& names) {
  const std::string whole = "/vsizip/" + path.string();
  VSILFILE* archive = VSIFOpenL(whole.c_str(), "wb");
  for (const std::string& name : names) put(whole + "/" + name, "1 2 3 " + name);
  if (archive != nullptr) VSIFCloseL(archive);
  return path;
}

TEST_F(UnpackedFiles, GzipHoldsOneFileAndLeavesNothingBeside) {
  put("/vsigzip/" + path("a.xyz.gz").string(), "1 2 3");
  ASSERT_TRUE(is_packed(path("a.xyz.gz")));
  std::filesystem::path inside;
  {
    const Unpacked unpacked(path("a.xyz.gz"), "");
    inside = unpacked.file();
    EXPECT_EQ(inside.filename(), "a.xyz");
    EXPECT_EQ(read_text(inside), "1 2 3");
    EXPECT_EQ(unpacked.in_words("'" + inside.string() + "' is odd"),
              "'" + path("a.xyz.gz").string() + "/a.xyz' is odd");
  }
  EXPECT_FALSE(std::filesystem::exists(inside));
  EXPECT_FALSE(std::filesystem::exists(path("a.xyz.gz.properties")));
}

TEST_F(UnpackedFiles, CompanionsDoNotCount) {
  const Unpacked unpacked(zip(path("a.zip"), {"in/a.asc", "in/a.prj", "readme.txt"}), "");
  EXPECT_EQ(read_text(unpacked.file()), "1 2 3 in/a.asc");
  EXPECT_TRUE(std::filesystem::exists(unpacked.file().parent_path() / "a.prj"));
}

TEST_F(UnpackedFiles, SeveralFilesAreListedAndOneIsChosen) {
  const auto file = zip(path("a.zip"), {"g.xyz", "plain.asc"});
  EXPECT_THAT(refusal([&] { return Unpacked(file, "").file(); }),
              HasSubstr("holds 2 files (g.xyz, plain.asc); choose one with <layer>"));
  EXPECT_EQ(Unpacked(file, "other, plain").file().filename(), "plain.asc");
  EXPECT_EQ(Unpacked(file, "g.xyz").file().filename(), "g.xyz");
}

TEST_F(UnpackedFiles, UpdatesOfACellGoWithIt) {
  const Unpacked set(zip(path("set.zip"), {"ENC_ROOT/CATALOG.031", "ENC_ROOT/C/0/C.000",
                                           "ENC_ROOT/C/1/C.001", "ENC_ROOT/README.TXT"}),
                     "");
  EXPECT_EQ(read_text(set.file()), "1 2 3 ENC_ROOT/C/0/C.000");
  std::filesystem::path update = set.file();
  EXPECT_EQ(read_text(update.replace_extension(".001")), "1 2 3 ENC_ROOT/C/1/C.001");
  // Of two cells one is to be named; updates are none to choose.
  const auto two = zip(path("two.zip"), {"A.000", "A.001", "B.000"});
  EXPECT_THAT(refusal([&] { return Unpacked(two, "").file(); }),
              HasSubstr("holds 2 files (A.000, B.000)"));
  EXPECT_EQ(Unpacked(two, "B").file().filename(), "B.000");
}

TEST_F(UnpackedFiles, CutOffFilesAreRefused) {
  put("/vsigzip/" + path("a.xyz.gz").string(), garbage(5000));
  std::filesystem::resize_file(path("a.xyz.gz"), 2000);
  EXPECT_THAT(refusal([&] { return Unpacked(path("a.xyz.gz"), "").file(); }),
              HasSubstr("cannot be unpacked"));
  EXPECT_THAT(
      refusal([&] { return Unpacked(write("b.zip", "PK\x03\x04" + garbage(100)), "").file(); }),
      HasSubstr("b.zip"));
  EXPECT_FALSE(is_packed(write("c.gz", "no gzip")));
}

}  // namespace
}  // namespace swathplan
