#include "apps/outlets/streams.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <iostream>

#include "mesh/base/error.h"

namespace swathplan {
namespace {

/// The lowest free number is the one that open takes: so they are looked at in their order.
void open_if_closed(int stream, int flags) {
  if (::fcntl(stream, F_GETFD) == -1 && errno == EBADF) {
    static_cast<void>(::open("/dev/null", flags));
  }
}

/// Writes to the real stderr as far as it can; says that it took all.
ssize_t write_to_stderr(void*, const char* text, std::size_t size) {
  for (std::size_t done = 0; done < size;) {
    const ssize_t written = ::write(STDERR_FILENO, text + done, size - done);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) break;
    done += static_cast<std::size_t>(written);
  }
  return static_cast<ssize_t>(size);
}

}  // namespace

void prepare_streams() {
  open_if_closed(STDIN_FILENO, O_RDONLY);
  open_if_closed(STDOUT_FILENO, O_RDONLY);  // printing must fail
  open_if_closed(STDERR_FILENO, O_WRONLY);
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  // glibc's standard streams are variables that a program may set.
  if (FILE* patient = ::fopencookie(nullptr, "w", {nullptr, &write_to_stderr, nullptr, nullptr})) {
    std::setvbuf(patient, nullptr, _IONBF, 0);
    stderr = patient;
  }
}

void throw_unprinted(const std::string& why) {
  throw InvalidInput(fmt::format(
      "cannot write to standard output ({}): what was printed is not complete; files that were "
      "asked for are written",
      why));
}

void finish_stdout() {
  errno = 0;
  const bool flushed = std::fflush(stdout) == 0;
  const int why = errno;
  const bool streamed = static_cast<bool>(std::cout.flush());
  if (streamed && flushed && std::ferror(stdout) == 0) return;
  throw_unprinted(why == 0 ? "an earlier part is lost" : std::strerror(why));
}

}  // namespace swathplan
