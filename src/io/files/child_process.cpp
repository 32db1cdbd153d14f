#include "io/files/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <new>

#include "mesh/base/error.h"

namespace swathplan {
namespace {

constexpr char kDone = 'd', kFailed = 'f', kNoMemory = 'm';

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define SWATHPLAN_SHADOW_MEMORY
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || \
    defined(SWATHPLAN_SHADOW_MEMORY)
constexpr bool kLimitsMemory = false;
#else
constexpr bool kLimitsMemory = true;
#endif

/// A pipe whose ends close by themselves.
class Pipe {
 public:
  Pipe() {
    if (pipe2(ends_.data(), O_CLOEXEC) != 0) throw InvalidInput("no pipe to a child process");
  }
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  [[nodiscard]] int reader() const { return ends_[0]; }
  [[nodiscard]] int writer() const { return ends_[1]; }
  void close_end(std::size_t end) {
    if (ends_[end] >= 0) close(ends_[end]);
    ends_[end] = -1;
  }

 private:
  std::array<int, 2> ends_{-1, -1};
};

void limit(int resource, rlim_t most) {
  rlimit value{};
  getrlimit(static_cast<__rlimit_resource>(resource), &value);
  value.rlim_cur = value.rlim_max == RLIM_INFINITY ? most : std::min(most, value.rlim_max);
  setrlimit(static_cast<__rlimit_resource>(resource), &value);
}

void write_all(int file, char kind, const std::string& text) {
  const std::string message = kind + text;
  for (std::size_t at = 0; at < message.size();) {
    const ssize_t n = write(file, message.data() + at, message.size() - at);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return;  // the parent has given up
    at += static_cast<std::size_t>(n);
  }
}

/// The child's life. It must not return: what the parent registered for its end is not the child's.
[[noreturn]] void live(const std::function<std::string()>& work, const ChildLimits& limits,
                       int answer) {
  std::signal(SIGINT, SIG_DFL);  // the parent's handler tells nothing here
  limit(RLIMIT_CPU, static_cast<rlim_t>(std::ceil(limits.seconds)));
  limit(RLIMIT_CORE, 0);
  if (kLimitsMemory) limit(RLIMIT_AS, limits.memory_bytes);
  try {
    write_all(answer, kDone, work());
  } catch (const std::bad_alloc&) {
    write_all(answer, kNoMemory, {});
  } catch (const std::exception& e) {
    write_all(answer, kFailed, e.what());
  } catch (...) {
    write_all(answer, kFailed, "an unknown error");
  }
  _exit(0);
}

/// All that the child writes; false if time ran out before its end.
bool read_until_end(int file, double seconds, std::string& answer) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  std::array<char, 1 << 16> block{};
  for (;;) {
    const std::chrono::duration<double, std::milli> left = end - std::chrono::steady_clock::now();
    if (left.count() <= 0.0) return false;
    pollfd wait{file, POLLIN, 0};
    const int ready = poll(&wait, 1, static_cast<int>(std::min(left.count() + 1.0, 1e6)));
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) continue;
    const ssize_t n = read(file, block.data(), block.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return true;
    answer.append(block.data(), static_cast<std::size_t>(n));
  }
}

int wait_for(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

ChildResult result_of(const std::string& answer, int status) {
  if (!answer.empty() && WIFEXITED(status)) {
    const std::string text = answer.substr(1);
    if (answer[0] == kDone) return {ChildEnd::done, text};
    if (answer[0] == kFailed) return {ChildEnd::failed, text};
    if (answer[0] == kNoMemory) return {ChildEnd::too_large, {}};
  }
  const bool out_of_time =
      WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL);
  return {out_of_time ? ChildEnd::too_long : ChildEnd::crashed, {}};
}

}  // namespace

ChildResult run_in_child(const std::function<std::string()>& work, const ChildLimits& limits) {
  Pipe answer_pipe;
  const pid_t child = fork();
  if (child < 0) throw InvalidInput("no child process can be started; close other programs");
  if (child == 0) {
    answer_pipe.close_end(0);
    live(work, limits, answer_pipe.writer());
  }
  answer_pipe.close_end(1);
  std::string answer;
  const bool in_time = read_until_end(answer_pipe.reader(), limits.seconds, answer);
  if (!in_time) kill(child, SIGKILL);
  const int status = wait_for(child);
  if (!in_time) return {ChildEnd::too_long, {}};
  return result_of(answer, status);
}

}  // namespace swathplan
