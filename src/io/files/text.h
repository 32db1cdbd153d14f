#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace swathplan::internal {

/// The whole file.
/// @throws InvalidInput if it cannot be read, is empty or is not text.
[[nodiscard]] std::string read_text(const std::filesystem::path& path);

/// `value` with at most `decimals` decimals, without trailing zeros and without '-0'.
[[nodiscard]] std::string decimal(double value, int decimals);

/// The number that the whole of `text` (blanks around it aside) spells; empty if it is none or not
/// finite.
[[nodiscard]] std::optional<double> number(std::string_view text);

}  // namespace swathplan::internal
