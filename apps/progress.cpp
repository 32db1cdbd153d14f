#include "apps/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace swathplan {
namespace {

constexpr int kBarWidth = 28;
constexpr std::chrono::milliseconds kInterval{150};

}  // namespace

ProgressBar::ProgressBar(std::string label, bool quiet)
    : label_(std::move(label)),
      active_(!quiet && isatty(STDERR_FILENO) != 0),
      start_(std::chrono::steady_clock::now()),
      shown_(start_) {}

ProgressBar::~ProgressBar() {
  if (active_) fmt::print(stderr, "\r\x1b[K");
}

void ProgressBar::show(double share, std::uint64_t rays) {
  const auto now = std::chrono::steady_clock::now();
  if (!active_ || now - shown_ < kInterval) return;
  shown_ = now;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const auto filled = static_cast<int>(share * kBarWidth);
  fmt::print(stderr, "\r\x1b[K{:<16} [{}{}] {:3.0f} %  {:5.1f} M rays/s  {:4.0f} s left", label_,
             std::string(static_cast<std::size_t>(filled), '#'),
             std::string(static_cast<std::size_t>(kBarWidth - filled), '.'), 100.0 * share,
             static_cast<double>(rays) / seconds / 1e6,
             share > 0.0 ? seconds * (1.0 - share) / share : 0.0);
  std::fflush(stderr);
}

}  // namespace swathplan
