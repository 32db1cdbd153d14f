#pragma once

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string>

#include "temporary_folder.h"

namespace swathplan::test {

/// What a run of the program gave.
struct Run {
  int code = -1;
  std::string out;  ///< stdout
  std::string err;  ///< stderr
};

inline std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

inline nlohmann::json json_of(const std::filesystem::path& file) {
  return nlohmann::json::parse(text_of(file));
}

inline std::string with_profile(const std::string& arguments) {
  const std::string command = arguments.substr(0, arguments.find(' '));
  const bool plans = command == "plan" || command == "compare" || command == "score";
  const auto names = [&](const char* flag) { return arguments.find(flag) != std::string::npos; };
  const bool own = names("--profile") || names("--config") || names("--help");
  return plans && !own ? arguments + " --profile paper" : arguments;
}

/// A folder of its own for each test, and the program run in it.
class Folder {
 public:
  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const {
    return path() / name;
  }
  [[nodiscard]] const std::filesystem::path& path() const { return folder_.path(); }

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(path() / name, std::ios::binary) << text;
    return path() / name;
  }

  /// Runs `swathplan ARGUMENTS` with this folder as the working directory; 60 s at most. Plans and
  /// scores are those of the papers' profile, whose figures have closed forms and known values,
  /// unless the arguments name a profile or a configuration file.
  [[nodiscard]] Run run(const std::string& arguments) const {
    return run_in(path().string(), arguments);
  }

  /// The same with another working directory.
  [[nodiscard]] Run run_in(const std::string& directory, const std::string& arguments) const {
    const std::string out = (path() / ".out").string();
    const std::string err = (path() / ".err").string();
    const std::string command = "cd '" + directory + "' && timeout 60 '" SWATHPLAN_PROGRAM "' " +
                                with_profile(arguments) + " >'" + out + "' 2>'" + err +
                                "' </dev/null";
    const int status = std::system(command.c_str());
    Run result;
    result.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128;
    result.out = text_of(out);
    result.err = text_of(err);
    std::filesystem::remove(out);
    std::filesystem::remove(err);
    return result;
  }

 private:
  TemporaryFolder folder_;
};

inline std::string dataset(const std::string& name) {
  return std::string(SWATHPLAN_SOURCE_DIR) + "/datasets/" + name;
}

}  // namespace swathplan::test
