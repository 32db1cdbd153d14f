#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace swathplan {

/// What a child process may use.
struct ChildLimits {
  double seconds = 20.0;                            ///< of processor time and by the clock, > 0
  std::size_t memory_bytes = std::size_t{2} << 30;  ///< of address space
};

/// How a child process ended.
enum class ChildEnd {
  done,       ///< `text` is what the work returned
  failed,     ///< the work threw; `text` is what it said
  too_long,   ///< stopped: out of time
  too_large,  ///< the work found no memory
  crashed     ///< ended by a signal, or without an answer
};

struct ChildResult {
  ChildEnd end = ChildEnd::crashed;
  std::string text;
};

/// Runs `work` in a child process of its own, so that whatever a foreign reader does with a broken
/// file ends in a result: a crash, an endless loop and memory without end stay in the child.
/// What `work` changes in memory is lost; its answer comes back through a pipe.
/// Memory is not limited in builds with a sanitizer, whose shadow takes terabytes of addresses.
/// @throws InvalidInput if the system has no process left.
[[nodiscard]] ChildResult run_in_child(const std::function<std::string()>& work,
                                       const ChildLimits& limits = {});

}  // namespace swathplan
