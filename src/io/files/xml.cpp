#include "io/files/xml.h"

#include <cpl_string.h>

namespace swathplan {

std::string xml_escaped(std::string_view text) {
  const bool utf8 = CPLIsUTF8(text.data(), static_cast<int>(text.size())) != FALSE;
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool blank = c == '\t' || c == '\n' || c == '\r';
    if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else if (c == '"') {
      out += "&quot;";
    } else if (c == '\'') {
      out += "&apos;";
    } else if ((byte < 0x20 && !blank) || (byte >= 0x80 && !utf8)) {
      out += '?';
    } else {
      out += c;
    }
  }
  return out;
}

}  // namespace swathplan
