#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace swathplan {

/// The lines of a text file, one after the other. They end with LF, CR LF or, where the file holds
/// no LF, with CR.
class TextLines {
 public:
  explicit TextLines(const std::filesystem::path& path);

  /// The next line without blanks at both ends and without a byte-order mark; false at the end. The
  /// view holds until the next call.
  bool next(std::string_view& line);
  /// The number of that line, from 1 on.
  [[nodiscard]] std::size_t number() const { return number_; }

 private:
  std::ifstream in_;
  char end_ = '\n';
  std::string text_;
  std::size_t number_ = 0;
};

}  // namespace swathplan
