#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace swathplan {

/// A CSV file with a header. Empty lines are left out.
struct CsvTable {
  struct Row {
    std::size_t line = 0;  ///< in the file, from 1
    std::vector<std::string> fields;
  };
  std::vector<std::string> header;  ///< trimmed, in lower case
  std::vector<Row> rows;
};

/// Reads CSV with quotes (RFC 4180). The separator is the one of comma, semicolon and tab that the
/// first line holds most of.
[[nodiscard]] CsvTable parse_csv(std::string_view text);

}  // namespace swathplan
