#include "io/files/child_process.h"

#include <gtest/gtest.h>

#include <atomic>
#include <csignal>
#include <new>
#include <stdexcept>

namespace swathplan {
namespace {

TEST(ChildProcess, HandsBackWhatTheWorkReturned) {
  const std::string large(3 << 20, 'x');  // more than a pipe holds
  const ChildResult result = run_in_child([&] { return large; });
  EXPECT_EQ(result.end, ChildEnd::done);
  EXPECT_EQ(result.text, large);
}

TEST(ChildProcess, SaysWhatTheWorkThrew) {
  const ChildResult result =
      run_in_child([]() -> std::string { throw std::runtime_error("a broken header"); });
  EXPECT_EQ(result.end, ChildEnd::failed);
  EXPECT_EQ(result.text, "a broken header");
}

TEST(ChildProcess, KeepsACrashToItself) {
  const ChildResult result = run_in_child([]() -> std::string {
    std::signal(SIGSEGV, SIG_DFL);
    std::raise(SIGSEGV);
    return "not reached";
  });
  EXPECT_EQ(result.end, ChildEnd::crashed);
}

TEST(ChildProcess, EndsWorkWithoutAnEnd) {
  const ChildResult result = run_in_child(
      []() -> std::string {
        for (std::atomic<int> i = 0;;) ++i;
      },
      {.seconds = 0.3});
  EXPECT_EQ(result.end, ChildEnd::too_long);
}

TEST(ChildProcess, SaysWhenMemoryRanOut) {
  const ChildResult result = run_in_child([]() -> std::string { throw std::bad_alloc(); });
  EXPECT_EQ(result.end, ChildEnd::too_large);
}

TEST(ChildProcess, LeavesTheCallersMemoryAlone) {
  int value = 1;
  const ChildResult result = run_in_child([&] {
    value = 2;
    return std::to_string(value);
  });
  EXPECT_EQ(result.text, "2");
  EXPECT_EQ(value, 1);
}

}  // namespace
}  // namespace swathplan
