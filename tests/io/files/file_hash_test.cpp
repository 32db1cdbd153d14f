#include "io/files/file_hash.h"

#include "io/import_files.h"

namespace swathplan {
namespace {

using FileHash = ImportFiles;

TEST_F(FileHash, IsTheSha1OfTheBytes) {
  EXPECT_EQ(file_hash(write("abc", "abc")), "sha1:a9993e364706816aba3e25717850c26c9cd0d89d");
  EXPECT_EQ(file_hash(write("none", "")), "sha1:da39a3ee5e6b4b0d3255bfef95601890afd80709");
  // Longer than one read.
  EXPECT_EQ(file_hash(write("many", std::string(1'000'000, 'a'))),
            "sha1:34aa973cd4c4daa4f61eeb2bdbad27316534016f");
  EXPECT_THROW((void)file_hash(path("missing")), InvalidInput);
}

}  // namespace
}  // namespace swathplan
