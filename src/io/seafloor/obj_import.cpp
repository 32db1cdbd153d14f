#include "io/seafloor/obj_import.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <string>

#include "io/files/text.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

[[noreturn]] void bad_line(const std::filesystem::path& path, std::size_t line,
                           std::string_view text, const std::string& why) {
  throw InvalidInput(fmt::format("'{}', line {}: '{}' {}; the file is truncated or garbled",
                                 path.string(), line, quotable(text), why));
}

/// 'v', 'v/t', 'v//n' or 'v/t/n' -> index from 0; false if it is none of them or out of range.
bool read_index(std::string_view field, std::size_t vertices, std::size_t& index) {
  const std::string_view digits = field.substr(0, field.find('/'));
  long long value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size() || value == 0) return false;
  const auto count = static_cast<long long>(vertices);
  if (value < -count) return false;
  index = static_cast<std::size_t>(value > 0 ? value - 1 : count + value);
  return true;
}

}  // namespace

void read_obj(const std::filesystem::path& path, std::vector<Vec3>& vertices,
              std::vector<SoupPolygon>& polygons) {
  std::ifstream in(path, std::ios::binary);
  std::string text;
  for (std::size_t line = 1; std::getline(in, text); ++line) {
    const std::vector<std::string_view> fields = split(text, ' ');
    if (fields.empty()) continue;
    if (fields[0] == "v") {
      Vec3 p;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::optional<double> value =
            i + 1 < fields.size() ? to_number(fields[i + 1]) : std::nullopt;
        if (!value) bad_line(path, line, text, "is no vertex of three numbers");
        if (!std::isfinite(*value)) bad_line(path, line, text, "holds a number that is not finite");
        p[static_cast<Eigen::Index>(i)] = *value;
      }
      vertices.push_back(p);
    } else if (fields[0] == "f") {
      SoupPolygon polygon(fields.size() - 1);
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        if (!read_index(fields[i + 1], vertices.size(), polygon[i])) {
          bad_line(path, line, text, "holds a corner that is no vertex");
        }
      }
      if (polygon.size() < 3) bad_line(path, line, text, "is a face of fewer than three corners");
      polygons.push_back(std::move(polygon));
    }
  }
}

}  // namespace swathplan
