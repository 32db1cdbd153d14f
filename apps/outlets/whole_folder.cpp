#include "apps/outlets/whole_folder.h"

#include <fmt/format.h>
#include <unistd.h>

#include <string>
#include <vector>

#include "mesh/base/error.h"

namespace swathplan {
namespace fs = std::filesystem;

namespace {

/// A folder that is gone at the end, and those above it that were made for it and stayed empty.
class Staging {
 public:
  explicit Staging(const fs::path& folder)
      : path_(folder / fmt::format(".swathplan.part{}", ::getpid())) {
    std::error_code error;
    fs::create_directories(path_, error);
    if (error) {
      throw InvalidInput(fmt::format("cannot create the folder '{}': {}; choose another with -o",
                                     folder.string(), error.message()));
    }
  }
  ~Staging() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Staging(const Staging&) = delete;
  Staging& operator=(const Staging&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// `text` with each `from` replaced by `to`.
std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at)) {
    text.replace(at, from.size(), to);
    at += to.size();
  }
  return text;
}

void move_files(const fs::path& from, const fs::path& to) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(from)) {
    if (entry.is_regular_file()) files.push_back(fs::relative(entry.path(), from));
  }
  for (const fs::path& file : files) {
    std::error_code error;
    fs::create_directories((to / file).parent_path(), error);
    if (!error) fs::rename(from / file, to / file, error);
    if (!error) continue;
    throw InvalidInput(fmt::format("cannot write '{}': {}", (to / file).string(), error.message()));
  }
}

}  // namespace

void write_all_or_none(const fs::path& folder, const std::function<void(const fs::path&)>& write) {
  const fs::path where = folder.empty() ? fs::path(".") : folder;
  const Staging staging(where);
  try {
    write(staging.path());
  } catch (const InvalidInput& e) {
    throw InvalidInput(
        fmt::format("{}; no file of this run was written to '{}'",
                    replaced(e.what(), (staging.path() / "").string(), (folder / "").string()),
                    where.string()));
  }
  move_files(staging.path(), where);
}

}  // namespace swathplan
