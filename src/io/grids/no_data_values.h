#pragma once

#include <cstddef>
#include <string>

namespace swathplan {

/// How sure a number that no one declared stands for 'no data'.
enum class NoDataSign {
  none,
  weak,   ///< 0, -1, 99, -99.9: programs fill with them, but a depth may be so too
  strong  ///< -9999, 999.9, 32767, 1e30: hardly a depth
};
[[nodiscard]] NoDataSign no_data_sign(double value);

/// Values that hold anything at all, and how many of them are the suspect one.
struct SuspectValue {
  double value = 0.0;
  std::size_t count = 0;
  std::size_t of = 0;
  double low = 0.0, high = 0.0;  ///< of all others
};
/// True if it is to be taken as no data: a strong sign, farther off all others than they span.
[[nodiscard]] bool is_no_data(const SuspectValue& suspect);
/// True if it lies so far off, or is so frequent, that it must be said.
[[nodiscard]] bool is_worth_a_word(const SuspectValue& suspect);
/// The warning of such a value. `what`: 'cells', 'soundings'.
[[nodiscard]] std::string no_data_warning(const SuspectValue& suspect, const std::string& what);

}  // namespace swathplan
