#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace swathplan {

/// What is read of pipes and devices, bytes: some of them never end.
inline constexpr std::size_t kMostStreamed = std::size_t{64} << 20;

/// The whole file.
/// @throws InvalidInput if it cannot be read, is empty or is not text, or if it is no regular file
///   and gives more than kMostStreamed.
[[nodiscard]] std::string read_text(const std::filesystem::path& path);

/// How deep brackets and braces stand in one another in JSON, texts between quotation marks aside.
[[nodiscard]] std::size_t nesting_of_json(std::string_view text);

/// JSON of files and messages is nested no deeper than this: what is deeper is no file of this
/// trade, and readers that call themselves for each level would run out of stack.
inline constexpr std::size_t kMostNesting = 64;

/// `text` without the blanks at both ends. A view into `text`.
[[nodiscard]] std::string_view trim(std::string_view text);

/// `text` with the letters A to Z in lower case. Other characters stay.
[[nodiscard]] std::string lower(std::string_view text);

/// The fields of a line. Runs of blanks separate them if `separator` is ' '. Any other separator
/// stands between two fields; then each field loses its blanks and its quotation marks at both
/// ends. Views into `line`.
[[nodiscard]] std::vector<std::string_view> split(std::string_view line, char separator);

/// The number that the whole field spells, 'nan' and 'inf' included; empty if it spells none. An
/// exponent may have Fortran's D for E.
/// Blanks are not allowed.
[[nodiscard]] std::optional<double> to_number(std::string_view field);

/// The finite number that the whole text spells; empty if it spells none. Blanks at both ends do
/// not count.
[[nodiscard]] std::optional<double> to_finite_number(std::string_view text);

/// `value` with at most `decimals` decimals, without trailing zeros and without '-0'.
[[nodiscard]] std::string decimal(double value, int decimals);

/// What an error message may quote: at most `most` characters, unprintable ones as '?'.
[[nodiscard]] std::string quotable(std::string_view text, std::size_t most = 60);

}  // namespace swathplan
