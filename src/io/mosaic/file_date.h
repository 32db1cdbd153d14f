#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace swathplan {

/// When the data of a file were made, as 'YYYYMMDD': the date that the file itself states (an S-57
/// cell's issue, the date of a TIFF), else the last date in its name. Never the time at which the
/// file was copied. Empty where there is none.
[[nodiscard]] std::optional<std::string> file_date(const std::filesystem::path& path);

/// The last date between 1900 and 2099 in a text, as '20250923', '2025-09-23' or '2025_09_23'.
[[nodiscard]] std::optional<std::string> last_date_in(const std::string& text);

}  // namespace swathplan
