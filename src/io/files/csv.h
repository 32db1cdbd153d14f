#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace swathplan::internal {

/// A CSV file with a header. Empty lines are left out.
struct CsvTable {
  struct Row {
    std::size_t line = 0;  ///< in the file, from 1
    std::vector<std::string> fields;
  };
  std::vector<std::string> header;  ///< trimmed, in lower case
  std::vector<Row> rows;
};

/// RFC 4180 with quotes; the separator (comma, semicolon or tab) is that of the first line.
[[nodiscard]] CsvTable parse_csv(std::string_view text);

}  // namespace swathplan::internal
