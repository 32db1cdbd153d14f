#include "io/grids/no_data_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace swathplan {
namespace {

/// No seafloor is as deep, in any unit.
constexpr double kNoHeight = 1e9;

/// The nines of a number that is written with nines only, at the precision of 32-bit floats; 0 if
/// it has other digits.
std::size_t nines_of(double size) {
  const std::string text = fmt::format("{:.7g}", size);
  const bool only = text.find_first_not_of("9.") == std::string::npos;
  return only ? static_cast<std::size_t>(std::count(text.begin(), text.end(), '9')) : 0;
}

double gap_of(const SuspectValue& suspect) {
  return std::max(suspect.value - suspect.high, suspect.low - suspect.value);
}

}  // namespace

NoDataSign no_data_sign(double value) {
  constexpr std::array kLimits = {32767.0, 32768.0, 1e6};
  constexpr std::size_t kHardlyADepth = 3;
  const double size = std::abs(value);
  if (!std::isfinite(size)) return NoDataSign::none;
  if (size >= kNoHeight || std::find(kLimits.begin(), kLimits.end(), size) != kLimits.end()) {
    return NoDataSign::strong;
  }
  const std::size_t nines = nines_of(size);
  if (nines >= kHardlyADepth) return NoDataSign::strong;
  const bool weak = value == 0.0 || value == -1.0 || nines == 2;
  return weak ? NoDataSign::weak : NoDataSign::none;
}

bool is_no_data(const SuspectValue& suspect) {
  return no_data_sign(suspect.value) == NoDataSign::strong &&
         (std::abs(suspect.value) >= kNoHeight || gap_of(suspect) > suspect.high - suspect.low);
}

bool is_worth_a_word(const SuspectValue& suspect) {
  constexpr std::size_t kShare = 50;  // one in so many
  constexpr double kGap = 0.25;       // of the span of all others
  if (is_no_data(suspect)) return true;
  const double gap = gap_of(suspect);
  if (no_data_sign(suspect.value) == NoDataSign::strong) return gap > 0.0 && suspect.count > 1;
  return suspect.count * kShare >= suspect.of && gap > kGap * (suspect.high - suspect.low);
}

std::string no_data_warning(const SuspectValue& suspect, const std::string& what) {
  const std::string found = fmt::format(
      "{} of {} {} hold {}{:.7g}, {} all other values ({:.6g} to {:.6g})", suspect.count,
      suspect.of, what, is_no_data(suspect) ? "" : "exactly ", suspect.value,
      is_no_data(suspect) ? "far outside" : "apart from", suspect.low, suspect.high);
  return is_no_data(suspect) ? found + ": taken as no data, though the file does not say so"
                             : fmt::format("{}: if that means no data, set <nodata value> {:.7g}",
                                           found, suspect.value);
}

}  // namespace swathplan
