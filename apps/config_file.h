#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace swathplan {

/// One option of a configuration file, as it would be typed; a list has several texts.
struct ConfigEntry {
  std::string name;
  std::vector<std::string> texts;
};

/// The options of a configuration file: TOML, a line 'name = value' each, without sections; or
/// JSON, as our own outputs, of which the member 'options' is read. What outputs call derived is
/// left out. @throws UsageError that names the file, the line and what is wrong with it.
[[nodiscard]] std::vector<ConfigEntry> read_config(const std::filesystem::path& file);

}  // namespace swathplan
