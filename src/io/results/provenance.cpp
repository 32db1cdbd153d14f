#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/files/atomic_file.h"
#include "io/results/provenance_json.h"

namespace swathplan {

double tidy_degrees(Angle angle) { return std::round(angle.deg() * 1e9) / 1e9; }

namespace {

nlohmann::ordered_json value_json(const OptionValue& value) {
  return std::visit([](const auto& v) { return nlohmann::ordered_json(v); }, value);
}

/// Numbers, texts and arrays are written alike in TOML and JSON.
std::string one_line(const nlohmann::ordered_json& json) {
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace

std::string survey_toml(const Provenance& p) {
  std::string text = fmt::format(
      "# Options of '{}', swathplan {}, as a configuration file.\n# FILE: {}, {}\nseed = {}\n",
      p.command, p.version, std::filesystem::path(p.input_file).filename().string(), p.input_hash,
      p.seed);
  for (const auto& [name, value] : p.options) {
    const bool derived = std::find(p.derived.begin(), p.derived.end(), name) != p.derived.end();
    text += fmt::format("{}{} = {}{}\n", derived ? "# " : "", name, one_line(value_json(value)),
                        derived ? "  # follows from the others" : "");
  }
  return text;
}

void write_survey_toml(const std::filesystem::path& folder, const Provenance& provenance) {
  write_text_atomically(folder / "survey.toml", survey_toml(provenance));
}

nlohmann::ordered_json provenance_json(const Provenance& provenance) {
  nlohmann::ordered_json options = nlohmann::ordered_json::object();
  for (const auto& [name, value] : provenance.options) {
    options[name] = value_json(value);
  }
  if (!provenance.derived.empty()) options["derived"] = provenance.derived;
  nlohmann::ordered_json json;
  json["program"] = "swathplan";
  json["version"] = provenance.version;
  json["command"] = provenance.command;
  json["input_file"] = std::filesystem::path(provenance.input_file).filename().string();
  json["input_hash"] = provenance.input_hash;
  json["seed"] = provenance.seed;
  json["options"] = std::move(options);
  return json;
}

std::string json_text(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace swathplan
