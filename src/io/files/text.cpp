#include "io/files/text.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "io/files/text_fields.h"
#include "mesh/base/error.h"

namespace swathplan::internal {

std::string read_text(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) {
    throw InvalidInput(fmt::format("'{}' is a folder; name the file in it", path.string()));
  }
  std::ifstream in(path, std::ios::binary);
  if (!in) {
    throw InvalidInput(
        fmt::format("cannot read '{}': check the name and the permissions", path.string()));
  }
  std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (trim(text).empty()) throw InvalidInput(fmt::format("'{}' is empty", path.string()));
  if (text.find('\0') != std::string::npos) {
    throw InvalidInput(fmt::format("'{}' is not a text file", path.string()));
  }
  return text;
}

std::string decimal(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::optional<double> number(std::string_view text) {
  const std::optional<double> value = to_number(trim(text));
  return value && std::isfinite(*value) ? value : std::nullopt;
}

}  // namespace swathplan::internal
