#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#include "cli/program.h"

namespace swathplan::test {

inline bool has_chromium() { return std::system("command -v chromium >/dev/null") == 0; }

/// Debian's Chromium without a window, on one page, in a folder of its own.
class Chromium {
 public:
  explicit Chromium(const Folder& folder) : folder_(folder) {}

  /// The page as its scripts left it in a window of 1280 pixels; empty where the browser failed.
  [[nodiscard]] std::string dom(const std::filesystem::path& page) const {
    run("--window-size=1280,900 --dump-dom", page, "dump.html");
    return text_of(folder_ / "dump.html");
  }
  /// The page as it is printed.
  [[nodiscard]] std::string pdf(const std::filesystem::path& page) const {
    run("--no-pdf-header-footer --print-to-pdf='" + (folder_ / "page.pdf").string() + "'", page,
        "print.txt");
    return text_of(folder_ / "page.pdf");
  }
  /// What the page told the console in the last run, line by line.
  [[nodiscard]] std::string console() const {
    std::istringstream log(text_of(folder_ / "chromium.log"));
    std::string said;
    for (std::string line; std::getline(log, line);) {
      if (line.find("CONSOLE") != std::string::npos) said += line + "\n";
    }
    return said;
  }

 private:
  void run(const std::string& task, const std::filesystem::path& page,
           const std::string& out) const {
    const std::string command =
        "timeout 120 chromium --headless --no-sandbox --disable-gpu --virtual-time-budget=4000 "
        "--enable-logging=stderr --v=0 --user-data-dir='" +
        (folder_ / "profile").string() + "' " + task + " 'file://" + page.string() + "' >'" +
        (folder_ / out).string() + "' 2>'" + (folder_ / "chromium.log").string() + "'";
    if (std::system(command.c_str()) != 0) std::filesystem::remove(folder_ / out);
  }

  const Folder& folder_;
};

}  // namespace swathplan::test
