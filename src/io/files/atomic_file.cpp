#include "io/files/atomic_file.h"

#include <cpl_vsi.h>
#include <fmt/format.h>
#include <unistd.h>

#include <fstream>
#include <memory>

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
  if (fs::exists(path, error) && !fs::is_regular_file(path, error)) {
    throw InvalidInput(
        fmt::format("cannot write '{}': it is there and no file; name another", path.string()));
  }
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

void write_through_memory(const fs::path& path,
                          const std::function<void(const std::string&)>& write) {
  const std::string name =
      fmt::format("/vsimem/{}/{}", static_cast<const void*>(&path), path.filename().string());
  const auto forget = [&](const char*) { VSIUnlink(name.c_str()); };
  const std::unique_ptr<const char, decltype(forget)> guard(name.c_str(), forget);
  write(name);
  vsi_l_offset size = 0;
  const auto* bytes =
      reinterpret_cast<const char*>(VSIGetMemFileBuffer(name.c_str(), &size, FALSE));
  if (bytes == nullptr) {
    throw InvalidInput(fmt::format("cannot write '{}': nothing was made", path.string()));
  }
  write_text_atomically(path, {bytes, static_cast<std::size_t>(size)});
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
