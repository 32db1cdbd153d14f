#include "io/files/atomic_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>

#include "mesh/base/error.h"

namespace swathplan {
namespace fs = std::filesystem;

namespace {

fs::path temporary_name(const fs::path& path) {
  fs::path stem = path.stem();
  stem += fmt::format(".part{}", ::getpid());
  stem += path.extension();
  return path.parent_path() / stem;
}

}  // namespace

void write_atomically(const fs::path& path, const std::function<void(const fs::path&)>& write) {
  std::error_code error;
  if (const fs::path folder = path.parent_path(); !folder.empty()) {
    fs::create_directories(folder, error);
    if (error) {
      throw InvalidInput(fmt::format("cannot create the folder '{}': {}; choose another with -o",
                                     folder.string(), error.message()));
    }
  }
  const fs::path part = temporary_name(path);
  try {
    write(part);
  } catch (...) {
    fs::remove(part, error);
    throw;
  }
  fs::rename(part, path, error);
  if (error) {
    const std::string why = error.message();
    fs::remove(part, error);
    throw InvalidInput(fmt::format("cannot write '{}': {}", path.string(), why));
  }
}

void write_text_atomically(const fs::path& path, std::string_view text) {
  write_atomically(path, [&](const fs::path& part) {
    std::ofstream out(part, std::ios::binary);
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
    out.flush();
    if (!out) {
      throw InvalidInput(
          fmt::format("cannot write '{}': check that the folder is writable and the disk has room",
                      path.string()));
    }
  });
}

}  // namespace swathplan
