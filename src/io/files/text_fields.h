#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace swathplan {

/// A whole field as a number, 'nan' and 'inf' included; empty if it is none.
[[nodiscard]] std::optional<double> to_number(std::string_view field);
/// Fields between separators: runs of blanks for ' ', else one field per separator, trimmed of
/// blanks and quotation marks. Views into `line`.
[[nodiscard]] std::vector<std::string_view> split(std::string_view line, char separator);
[[nodiscard]] std::string_view trim(std::string_view text);
[[nodiscard]] std::string lower(std::string_view text);
/// What an error message may quote: at most `most` characters, unprintable ones as '?'.
[[nodiscard]] std::string quotable(std::string_view text, std::size_t most = 60);

}  // namespace swathplan
