#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "mesh/base/error.h"

namespace swathplan {

/// A folder for one test's files, gone with the test.
class ImportFiles : public testing::Test {
 protected:
  ImportFiles() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() /
              ("swathplan_" + std::string(test->test_suite_name()) + "_" + test->name() + "_" +
               std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
  }
  ~ImportFiles() override {
    std::error_code error;
    std::filesystem::remove_all(folder_, error);
  }

  [[nodiscard]] std::filesystem::path path(const std::string& name) const { return folder_ / name; }

  std::filesystem::path write(const std::string& name, std::string_view bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
  }

 private:
  std::filesystem::path folder_;
};

/// A file of the shared datasets, which not every checkout has beside it.
inline std::filesystem::path shared_dataset(const std::string& name) {
  return std::filesystem::path(SWATHPLAN_SOURCE_DIR) / ".." / "shared" / "datasets" / name;
}

/// What InvalidInput says when `call` is made; 'accepted' if it says nothing.
template <class Call>
std::string refusal(Call call) {
  try {
    (void)call();
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "accepted";
}

/// Noise that is no file of any kind, the same at each call.
inline std::string garbage(std::size_t length) {
  std::string bytes;
  unsigned state = 12345;
  for (std::size_t i = 0; i < length; ++i) {
    state = state * 1664525U + 1013904223U;
    bytes.push_back(static_cast<char>(state >> 24));
  }
  return bytes;
}

}  // namespace swathplan
