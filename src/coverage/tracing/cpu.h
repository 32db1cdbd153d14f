#pragma once

#include <cstdint>

/// Hot loops in one build for every processor: the widest instructions are chosen at run time. The
/// results are the same bits, for no multiply-add is ever contracted. The sanitizers cannot stand
/// code that is chosen before they start.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define SWATHPLAN_EVERY_CPU __attribute__((target_clones("avx2", "default")))
#else
#define SWATHPLAN_EVERY_CPU
#endif

namespace swathplan {

/// Floor without a library call, so that loops over it become vector code. |x| < 2^31.
[[nodiscard]] inline std::int32_t floor_to_int(float x) {
  const auto i = static_cast<std::int32_t>(x);
  return i - static_cast<std::int32_t>(x < static_cast<float>(i));
}

/// Bands of grid rows: 32 rows make a strip, strips are dealt to the bands in turn, and one task
/// counts one band, so that no word of the grid is ever written by two. A power of two.
struct Bands {
  static constexpr int kStripShift = 5;
  std::uint32_t count = 1;
  [[nodiscard]] std::uint32_t of_row(std::uint32_t row) const {
    return (row >> kStripShift) & (count - 1U);
  }
};

}  // namespace swathplan
