#pragma once

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include "mesh/base/error.h"

namespace swathplan::fuzz {

/// The input as text.
inline std::string text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// The input as a file in memory, which readers of files take. Always the same name, so that a
/// million runs leave one file.
inline std::filesystem::path file_of(const std::uint8_t* data, std::size_t size,
                                     const std::string& extension) {
  const std::filesystem::path path =
      "/dev/shm/swathplan-fuzz-" + std::to_string(::getpid()) + extension;
  std::ofstream out(path, std::ios::binary | std::ios::trunc);
  out.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  return path;
}

/// What a reader may do with a broken file is to say so. Anything else ends the fuzzer.
template <class Read>
void expect_sentence(Read read) {
  try {
    read();
  } catch (const InvalidInput&) {
  } catch (const UsageError&) {
  }
}

}  // namespace swathplan::fuzz
