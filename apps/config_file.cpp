#include "apps/config_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "io/files/text.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

using Json = nlohmann::ordered_json;

std::string trimmed(const std::string& text) {
  const std::size_t from = text.find_first_not_of(" \t\r");
  if (from == std::string::npos) return {};
  return text.substr(from, text.find_last_not_of(" \t\r") - from + 1);
}

/// The line without its comment; a '#' between quotes starts none.
std::string without_comment(const std::string& line) {
  char quote = '\0';
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quote == '"' && c == '\\') {
      ++i;
    } else if (quote != '\0') {
      if (c == quote) quote = '\0';
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '#') {
      return line.substr(0, i);
    }
  }
  return line;
}

/// The values of TOML that options need are written as in JSON, but for texts between ''.
Json toml_value(const std::string& text) {
  if (nesting_of_json(text) > kMostNesting) return Json(Json::value_t::discarded);
  if (text.size() >= 2 && text.front() == '\'' && text.back() == '\'') {
    return text.substr(1, text.size() - 2);
  }
  return Json::parse(text, nullptr, false);
}

Json read_toml(const std::string& text, const std::string& file) {
  Json options = Json::object();
  std::istringstream lines(text);
  std::string line;
  for (int n = 1; std::getline(lines, line); ++n) {
    line = trimmed(without_comment(line));
    if (line.empty()) continue;
    const std::size_t equals = line.find('=');
    const std::string name = trimmed(line.substr(0, equals));
    if (equals == std::string::npos || name.empty()) {
      throw UsageError(fmt::format("'{}' line {}: '{}' is not 'name = value'", file, n, line));
    }
    Json value = toml_value(trimmed(line.substr(equals + 1)));
    if (value.is_discarded()) {
      throw UsageError(
          fmt::format("'{}' line {}: the value of '{}' is no number, true, false, list or text "
                      "between quotes",
                      file, n, name));
    }
    if (options.contains(name)) {
      throw UsageError(fmt::format("'{}' line {}: '{}' is given twice", file, n, name));
    }
    options[name] = std::move(value);
  }
  return options;
}

Json read_json(const std::string& text, const std::string& file) {
  Json json = nesting_of_json(text) > kMostNesting ? Json() : Json::parse(text, nullptr, false);
  if (!json.is_object()) {
    throw UsageError(
        fmt::format("'{}' is no JSON object with options, as score.json and plan.json are", file));
  }
  if (!json.contains("options") || !json["options"].is_object()) return json;
  Json options = json["options"];
  if (json.contains("seed")) options["seed"] = json["seed"];
  return options;
}

std::string as_typed(const Json& value, const std::string& name, const std::string& file) {
  if (value.is_structured()) {
    throw UsageError(
        fmt::format("'{}': '{}' must be a number, a text or a list of them", file, name));
  }
  return value.is_string() ? value.get<std::string>() : value.dump();
}

ConfigEntry entry(const std::string& name, const Json& value, const std::string& file) {
  ConfigEntry result{name, {}};
  if (!value.is_array()) {
    result.texts.push_back(as_typed(value, name, file));
    return result;
  }
  for (const Json& part : value) result.texts.push_back(as_typed(part, name, file));
  return result;
}

}  // namespace

std::vector<ConfigEntry> read_config(const std::filesystem::path& file) {
  const std::string shown = file.string();
  std::ifstream in(file, std::ios::binary);
  if (!in || !std::filesystem::is_regular_file(file)) {
    throw UsageError(fmt::format("the configuration file '{}' cannot be read", shown));
  }
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const bool json = first != std::string::npos && text[first] == '{';
  const Json options = json ? read_json(text, shown) : read_toml(text, shown);
  std::vector<std::string> derived;
  if (options.contains("derived") && options["derived"].is_array()) {
    for (const Json& name : options["derived"]) derived.push_back(as_typed(name, "derived", shown));
  }
  std::vector<ConfigEntry> entries;
  for (const auto& [name, value] : options.items()) {
    const bool left_out = name == "derived" || value.is_null() ||
                          std::find(derived.begin(), derived.end(), name) != derived.end();
    if (!left_out) entries.push_back(entry(name, value, shown));
  }
  return entries;
}

}  // namespace swathplan
