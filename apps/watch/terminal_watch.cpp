#include "apps/watch/terminal_watch.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <system_error>
#include <vector>

namespace swathplan {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds kTick{50};
constexpr int kTicksOfDrawing = 4;
constexpr int kStopped = 130;
/// A share under this tells nothing of the time that is left.
constexpr double kTelling = 0.02;
constexpr std::size_t kUsualColumns = 80;

/// Counts Ctrl-C. It is all that a handler of signals touches.
std::atomic<int> interrupts{0};
static_assert(std::atomic<int>::is_always_lock_free);

extern "C" void count_interrupt(int) { interrupts.fetch_add(1, std::memory_order_relaxed); }

bool handle(void (*handler)(int)) {
  struct sigaction now {};
  sigaction(SIGINT, nullptr, &now);
  if (now.sa_handler == SIG_IGN) return false;
  now = {};
  now.sa_handler = handler;
  now.sa_flags = SA_RESTART;
  sigemptyset(&now.sa_mask);
  return sigaction(SIGINT, &now, nullptr) == 0;
}

/// To the terminal itself: the stream's lock may be held by whoever is being stopped.
void put(const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t n = ::write(STDERR_FILENO, text.data() + done, text.size() - done);
    if (n <= 0) return;
    done += static_cast<std::size_t>(n);
  }
}

std::size_t columns_of_terminal() {
  winsize size{};
  const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1;
  return known ? size.ws_col - 1U : kUsualColumns - 1;
}

/// '0:34', '1:02:03'.
std::string clock_text(double seconds) {
  const auto s = static_cast<long>(std::lround(std::min(seconds, 1e8)));
  return s < 3600 ? fmt::format("{}:{:02}", s / 60, s % 60)
                  : fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
}

/// Half a number would say something else, so the text is cut between its parts if it can be.
std::string cut_to_columns(std::string text, std::size_t columns) {
  if (text.size() <= columns) return text;
  std::size_t end = 0;
  for (const char* between : {" | ", ", "}) {
    const std::size_t at = text.rfind(between, columns);
    if (at != std::string::npos) end = std::max(end, at);
  }
  if (end == 0) {
    end = columns;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  }
  text.resize(end);
  return text;
}

/// Removes files and folders that carry the name of this process's unfinished outputs.
void remove_unfinished(const fs::path& folder) {
  const std::string mark = fmt::format(".part{}", ::getpid());
  std::vector<fs::path> found;
  std::error_code error;
  for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end;
       it.increment(error)) {
    if (it->path().filename().string().find(mark) == std::string::npos) continue;
    found.push_back(it->path());
    it.disable_recursion_pending();
  }
  for (const fs::path& path : found) fs::remove_all(path, error);
}

}  // namespace

std::string line_of(const Showing& s, std::size_t columns) {
  std::string text = s.phase;
  double share = s.share;
  if (s.of > 0) {
    text += fmt::format(": {} of {} tried", s.tried, s.of);
    share = static_cast<double>(s.tried) / static_cast<double>(s.of);
  } else if (s.tried > 0) {
    text += fmt::format(": {} tried", s.tried);
  } else if (share > 0.0) {
    text += fmt::format(": {:.0f} %", 100.0 * share);
  }
  text += fmt::format(" | {} gone", clock_text(s.gone.count()));
  if (share > kTelling && share <= 1.0) {
    text += fmt::format(", {} left", clock_text(s.of_phase.count() * (1.0 - share) / share));
  }
  if (!s.best.empty()) text += " | best " + s.best;
  return cut_to_columns(std::move(text), columns);
}

TerminalWatch::TerminalWatch(bool quiet, fs::path folder)
    : shows_(!quiet && ::isatty(STDERR_FILENO) != 0),
      folder_(std::move(folder)),
      start_(std::chrono::steady_clock::now()),
      phase_start_(start_) {
  interrupts = 0;
  handle(&count_interrupt);
  thread_ = std::thread([this] { watch(); });
}

TerminalWatch::~TerminalWatch() {
  {
    const std::lock_guard lock(state_);
    over_ = true;
  }
  wake_.notify_all();
  thread_.join();
  handle(SIG_DFL);
}

void TerminalWatch::phase(const std::string& what) {
  const std::lock_guard lock(state_);
  showing_ = {};
  showing_.phase = title_ + what;
  phase_start_ = std::chrono::steady_clock::now();
}

void TerminalWatch::under(const std::string& title) {
  const std::lock_guard lock(state_);
  title_ = title.empty() ? title : title + ": ";
}

void TerminalWatch::share(double done) {
  const std::lock_guard lock(state_);
  showing_.share = done;
}

void TerminalWatch::tried(std::size_t count, std::size_t of, const std::string& best) {
  const std::lock_guard lock(state_);
  showing_.tried = count;
  showing_.of = std::max(of, of > 0 ? count : of);
  showing_.best = best;
}

bool TerminalWatch::ended() const { return interrupts.load(std::memory_order_relaxed) > 0; }

void TerminalWatch::search() {
  const std::lock_guard lock(state_);
  searches_ = true;
}

void TerminalWatch::rest() {
  const std::lock_guard lock(state_);
  clear();
  showing_ = {};
}

std::unique_lock<std::mutex> TerminalWatch::writing() { return std::unique_lock(writing_); }

void TerminalWatch::watch() {
  std::unique_lock lock(state_);
  for (int tick = 1; !over_; ++tick) {
    wake_.wait_for(lock, kTick);
    const int count = interrupts.load(std::memory_order_relaxed);
    if (count >= (searches_ ? 2 : 1)) {
      lock.unlock();
      stop();
    }
    if (count == 1 && !said_) {
      said_ = true;
      clear();
      if (shows_) put("Ctrl-C: ending with the best so far; once more stops at once\n");
    }
    if (tick % kTicksOfDrawing == 0) draw();
  }
  clear();
}

void TerminalWatch::draw() {
  if (!shows_ || showing_.phase.empty()) return;
  const auto now = std::chrono::steady_clock::now();
  showing_.gone = now - start_;
  showing_.of_phase = now - phase_start_;
  put("\r\x1b[K" + line_of(showing_, columns_of_terminal()));
  drawn_ = true;
}

void TerminalWatch::clear() {
  if (drawn_) put("\r\x1b[K");
  drawn_ = false;
}

void TerminalWatch::stop() {
  const std::lock_guard whole(writing_);
  const std::lock_guard lock(state_);
  clear();
  if (!folder_.empty()) remove_unfinished(folder_);
  if (shows_) put("swathplan: stopped by Ctrl-C\n");
  std::_Exit(kStopped);
}

}  // namespace swathplan
