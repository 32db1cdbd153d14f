#pragma once

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace swathplan::test {

/// The program with a terminal of its own, as someone at a keyboard runs it. It is killed at the
/// end of its scope.
class TerminalRun {
 public:
  TerminalRun(const std::filesystem::path& folder, std::vector<std::string> arguments)
      : start_(std::chrono::steady_clock::now()) {
    arguments.insert(arguments.begin(), SWATHPLAN_PROGRAM);
    std::vector<char*> words;
    for (std::string& word : arguments) words.push_back(word.data());
    words.push_back(nullptr);
    winsize size{};
    size.ws_row = 24;
    size.ws_col = 120;
    child_ = forkpty(&terminal_, nullptr, nullptr, &size);
    if (child_ < 0) throw std::runtime_error("no terminal");
    if (child_ == 0) {
      if (chdir(folder.c_str()) == 0) execv(words[0], words.data());
      _exit(127);
    }
  }
  ~TerminalRun() {
    if (!done_) {
      kill(child_, SIGKILL);
      waitpid(child_, nullptr, 0);
    }
    close(terminal_);
  }
  TerminalRun(const TerminalRun&) = delete;
  TerminalRun& operator=(const TerminalRun&) = delete;

  /// Waits until the terminal has shown the text; false if it did not within these seconds.
  bool shows(const std::string& text, double seconds = 60.0) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    while (shown_.find(text) == std::string::npos) {
      if (std::chrono::steady_clock::now() > end || !read_some()) return false;
    }
    return true;
  }
  /// Seconds since the start.
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  void press_ctrl_c() const {
    constexpr char kCtrlC = 3;
    if (write(terminal_, &kCtrlC, 1) != 1) throw std::runtime_error("no terminal");
  }
  /// Waits for the end; the exit code, or 128 for a signal.
  int code() {
    while (read_some()) {
    }
    int status = 0;
    waitpid(child_, &status, 0);
    done_ = true;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
  }
  [[nodiscard]] const std::string& shown() const { return shown_; }

 private:
  /// False at the end of the program.
  bool read_some() {
    pollfd ready{terminal_, POLLIN, 0};
    constexpr int kMilliseconds = 50;
    if (poll(&ready, 1, kMilliseconds) == 0) return true;
    std::array<char, 4096> block{};
    const ssize_t n = read(terminal_, block.data(), block.size());
    if (n <= 0) return false;
    shown_.append(block.data(), static_cast<std::size_t>(n));
    return true;
  }

  std::chrono::steady_clock::time_point start_;
  pid_t child_ = -1;
  int terminal_ = -1;
  bool done_ = false;
  std::string shown_;
};

}  // namespace swathplan::test
