#include "io/files/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <system_error>

#include "mesh/base/error.h"

namespace swathplan {
namespace {

constexpr std::string_view kBlanks = " \t\r\n\v\f";

/// The bytes of what is no regular file.
std::string streamed(std::istream& in, const std::filesystem::path& path) {
  std::string text;
  std::array<char, 1 << 16> buffer;
  while (in.read(buffer.data(), buffer.size()) || in.gcount() > 0) {
    text.append(buffer.data(), static_cast<std::size_t>(in.gcount()));
    if (text.size() <= kMostStreamed) continue;
    throw InvalidInput(
        fmt::format("'{}' is no regular file and gives more than {} MiB; save what it gives to a "
                    "file and name that",
                    path.string(), kMostStreamed >> 20));
  }
  return text;
}

}  // namespace

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
  std::string text = std::filesystem::is_regular_file(path, error)
                         ? std::string{std::istreambuf_iterator<char>(in), {}}
                         : streamed(in, path);
  if (trim(text).empty()) throw InvalidInput(fmt::format("'{}' is empty", path.string()));
  if (text.find('\0') != std::string::npos) {
    throw InvalidInput(fmt::format("'{}' is not a text file", path.string()));
  }
  return text;
}

std::size_t nesting_of_json(std::string_view text) {
  std::size_t depth = 0, deepest = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted && c == '\\') {
      ++i;
    } else if (c == '"') {
      quoted = !quoted;
    } else if (!quoted && (c == '[' || c == '{')) {
      deepest = std::max(deepest, ++depth);
    } else if (!quoted && (c == ']' || c == '}') && depth > 0) {
      --depth;
    }
  }
  return deepest;
}

std::string_view trim(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return result;
}

std::vector<std::string_view> split(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
  if (separator == ' ') {
    for (std::size_t at = line.find_first_not_of(kBlanks); at != std::string_view::npos;) {
      const std::size_t end = std::min(line.find_first_of(kBlanks, at), line.size());
      fields.push_back(line.substr(at, end - at));
      at = line.find_first_not_of(kBlanks, end);
    }
    return fields;
  }
  for (std::size_t at = 0; at <= line.size();) {
    const std::size_t end = std::min(line.find(separator, at), line.size());
    std::string_view field = trim(line.substr(at, end - at));
    if (field.size() > 1 && field.front() == '"' && field.back() == '"') {
      field = trim(field.substr(1, field.size() - 2));
    }
    fields.push_back(field);
    at = end + 1;
  }
  return fields;
}

std::optional<double> to_number(std::string_view field) {
  if (field.size() > 1 && field.front() == '+') field.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (field.empty() || error != std::errc()) return {};
  if (end == field.data() + field.size()) return value;
  // Fortran writes 1.5D+03. What stands before the letter has been read, so there is no second one.
  if (*end != 'D' && *end != 'd') return {};
  std::string with_e(field);
  with_e[static_cast<std::size_t>(end - field.data())] = 'e';
  return to_number(with_e);
}

std::optional<double> to_finite_number(std::string_view text) {
  const std::optional<double> value = to_number(trim(text));
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::string decimal(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string quotable(std::string_view text, std::size_t most) {
  std::string result(text.substr(0, most));
  std::replace_if(
      result.begin(), result.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return text.size() > most ? result + "..." : result;
}

}  // namespace swathplan
