#pragma once

#include <cstdint>

/// A function with this attribute is compiled for several processors, and the widest instructions
/// are chosen at run time. Results are the same bits, because no multiply-add is ever contracted.
/// Sanitizers are left out: they crash on code that is chosen before they start.
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

/// Bands of grid rows. 32 rows make a strip, and strips are dealt to the bands in turn. One task
/// counts one band, so no two tasks ever write the same word of the grid.
struct Bands {
  static constexpr int kStripShift = 5;
  std::uint32_t count = 1;  ///< a power of two
  [[nodiscard]] std::uint32_t of_row(std::uint32_t row) const {
    return (row >> kStripShift) & (count - 1U);
  }
};

}  // namespace swathplan
