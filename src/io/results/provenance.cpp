#include <cmath>

#include "io/results/provenance_json.h"

namespace swathplan {

double tidy_degrees(Angle angle) { return std::round(angle.deg() * 1e9) / 1e9; }

namespace internal {

nlohmann::ordered_json to_json(const Provenance& provenance) {
  nlohmann::ordered_json options = nlohmann::ordered_json::object();
  for (const auto& [name, value] : provenance.options) {
    options[name] = std::visit([](const auto& v) { return nlohmann::ordered_json(v); }, value);
  }
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

}  // namespace internal
}  // namespace swathplan
