#include "io/route/route_ros_read.h"

#include <fmt/format.h>

#include "io/files/text.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

/// The words of YAML: keys with their colon, and values. Comments and the marks of lists and
/// mappings are left out.
std::vector<std::string_view> yaml_words(std::string_view text) {
  std::vector<std::string_view> words;
  const auto is_gap = [](char c) {
    return c == ' ' || c == '\n' || c == '\r' || c == '\t' || c == ',' || c == '{' || c == '}' ||
           c == '[' || c == ']';
  };
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] == '#' && (i == 0 || is_gap(text[i - 1]))) {
      i = std::min(text.find('\n', i), text.size());
    } else if (is_gap(text[i])) {
      ++i;
    } else {
      std::size_t end = i;
      while (end < text.size() && !is_gap(text[end])) ++end;
      const std::string_view word = text.substr(i, end - i);
      if (word != "-" && word != "---") words.push_back(word);
      i = end;
    }
  }
  return words;
}

}  // namespace

bool is_ros_path(std::string_view text) {
  const std::string_view head = text.substr(0, 4000);
  const bool begins = head.starts_with('#') || head.starts_with("header:") ||
                      head.starts_with("poses:") || head.starts_with("---");
  const std::size_t at = head.find("poses:");
  return begins && at != std::string_view::npos && (at == 0 || head[at - 1] == '\n');
}

ForeignRoute parse_route_ros(std::string_view text, const std::string& file,
                             double metres_per_unit) {
  ForeignRoute route{.in_degrees = false, .parts = {}, .notes = {}};
  route.parts.emplace_back();
  const auto words = yaml_words(text);
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] != "position:") continue;
    std::optional<double> x, y;
    for (std::size_t k = i + 1;
         k + 1 < words.size() && words[k] != "orientation:" && words[k] != "position:"; ++k) {
      if (words[k] == "x:") x = to_finite_number(words[k + 1]);
      if (words[k] == "y:") y = to_finite_number(words[k + 1]);
    }
    if (!x || !y) {
      throw InvalidInput(fmt::format("'{}', pose {}: its position needs x and y, both numbers",
                                     file, route.parts.back().size() + 1));
    }
    route.parts.back().push_back(
        {.place = Vec2(*x, *y) / metres_per_unit, .line = std::nullopt, .speed_mps = std::nullopt});
  }
  route.notes.emplace_back(
      "poses were taken as metres east and north in the coordinate reference "
      "system of the seafloor's file");
  return route;
}

}  // namespace swathplan
