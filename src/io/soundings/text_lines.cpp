#include "io/soundings/text_lines.h"

#include "io/files/text.h"

namespace swathplan {

TextLines::TextLines(const std::filesystem::path& path) : in_(path, std::ios::binary) {
  std::string head(std::size_t{1} << 16, '\0');
  in_.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(in_.gcount()));
  const bool line_feeds = head.find('\n') != std::string::npos;
  if (!line_feeds && head.find('\r') != std::string::npos) end_ = '\r';
  in_.clear();
  in_.seekg(0);
}

bool TextLines::next(std::string_view& line) {
  if (!std::getline(in_, text_, end_)) return false;
  ++number_;
  line = text_;
  if (number_ == 1 && line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
  line = trim(line);
  return true;
}

}  // namespace swathplan
