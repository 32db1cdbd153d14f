#pragma once

#ifdef __SANITIZE_THREAD__
#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>
#else
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#endif

namespace swathplan {

/// Calls `body(i)` once for each i in [begin, end), in no fixed order, on all threads of the
/// caller's arena. An empty range calls nothing. The result is the same for any number of threads
/// as long as each call writes to a place of its own. If a call throws, its exception is thrown
/// again here.
template <class Index, class Body>
void for_each_index(Index begin, Index end, const Body& body) {
#ifdef __SANITIZE_THREAD__
  // The thread sanitizer does not see how Debian's TBB orders its tasks and takes each hand-over
  // for a race. Plain threads let it watch the bodies themselves.
  constexpr int kThreads = 4;
  std::atomic<Index> next{begin};
  std::mutex guard;
  std::exception_ptr failure;
  std::vector<std::thread> threads;
  for (int t = 0; t < kThreads && begin < end; ++t) {
    threads.emplace_back([&] {
      try {
        for (Index i = next++; i < end; i = next++) body(i);
      } catch (...) {
        const std::lock_guard lock(guard);
        if (!failure) failure = std::current_exception();
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  if (failure) std::rethrow_exception(failure);
#else
  tbb::parallel_for(begin, end, body);
#endif
}

/// Runs both at once on the threads of the caller's arena; neither may touch what the other writes.
template <class First, class Second>
void run_both(const First& first, const Second& second) {
#ifdef __SANITIZE_THREAD__
  for_each_index(0, 2, [&](int i) { i == 0 ? first() : second(); });
#else
  tbb::parallel_invoke(first, second);
#endif
}

}  // namespace swathplan
