#pragma once

#include <cstdint>
#include <string>

namespace swathplan::test {

/// The bytes that a text in base 64 stands for.
inline std::string bytes_of(const std::string& base64) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  std::uint32_t bits = 0;
  int have = 0;
  for (const char c : base64) {
    if (c == '=') break;
    bits = (bits << 6) | static_cast<std::uint32_t>(digits.find(c));
    have += 6;
    if (have >= 8) out += static_cast<char>((bits >> (have -= 8)) & 0xFFU);
  }
  return out;
}

}  // namespace swathplan::test
