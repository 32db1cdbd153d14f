#include "io/files/atomic_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

#include "mesh/base/error.h"
#include "temporary_folder.h"

namespace swathplan {
namespace {

std::string bytes_in(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::ptrdiff_t files_in(const std::filesystem::path& folder) {
  return std::distance(std::filesystem::directory_iterator(folder), {});
}

TEST(AtomicFile, MakesTheFolderAndKeepsEveryByte) {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "a" / "b" / "c.txt";
  const std::string text("one\r\n\0two", 9);
  write_text_atomically(file, text);
  EXPECT_EQ(bytes_in(file), text);
  write_text_atomically(file, "");
  EXPECT_EQ(bytes_in(file), "");
  EXPECT_EQ(files_in(file.parent_path()), 1);
}

TEST(AtomicFile, TheTemporaryFileLiesBesideAndKeepsTheExtension) {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "c.tif";
  write_atomically(file, [&](const std::filesystem::path& part) {
    EXPECT_NE(part, file);
    EXPECT_EQ(part.parent_path(), file.parent_path());
    EXPECT_EQ(part.extension(), ".tif");
    EXPECT_FALSE(std::filesystem::exists(file));
    std::ofstream(part) << "x";
  });
  EXPECT_EQ(bytes_in(file), "x");
}

TEST(AtomicFile, KeepsTheOldFileWhenTheWriterThrows) {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "c.txt";
  write_text_atomically(file, "old");
  EXPECT_THROW(write_atomically(file,
                                [](const std::filesystem::path& part) {
                                  std::ofstream(part) << "half";
                                  throw std::runtime_error("stop");
                                }),
               std::runtime_error);
  EXPECT_EQ(bytes_in(file), "old");
  EXPECT_EQ(files_in(folder.path()), 1);
}

TEST(AtomicFile, RefusesAFolderThatCannotBe) {
  const test::TemporaryFolder folder;
  write_text_atomically(folder.path() / "file", "x");
  EXPECT_THROW(write_text_atomically(folder.path() / "file" / "c.txt", "x"), InvalidInput);
}

}  // namespace
}  // namespace swathplan
