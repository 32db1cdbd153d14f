#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "mesh/base/angle.h"

namespace swathplan {

/// The value of an option as it was in force.
using OptionValue = std::variant<bool, std::int64_t, double, std::string, std::vector<double>,
                                 std::vector<std::string>>;

/// What made an output, so that it can be made again. Two runs on different machines give the same:
/// it holds no time, no folder and no number of threads.
struct Provenance {
  std::string version;     ///< of swathplan
  std::string command;     ///< the subcommand, as 'plan'
  std::string input_file;  ///< of the seafloor; outputs show its name without the folder
  std::string input_hash;  ///< see file_hash.h
  std::uint64_t seed = 1;
  /// In the order of the command line; a name carries its unit, as 'resolution_m'.
  std::vector<std::pair<std::string, OptionValue>> options;
  /// Names of the options that nobody gave. They follow from other options, as the draft follows
  /// from the vehicle. A run that is repeated from the outputs derives them again.
  std::vector<std::string> derived;
};

/// The options as a configuration file in TOML, one line each. Options that follow from others are
/// comments.
[[nodiscard]] std::string survey_toml(const Provenance& provenance);
/// Writes survey_toml() as 'survey.toml' into the folder. @throws InvalidInput if that fails.
void write_survey_toml(const std::filesystem::path& folder, const Provenance& provenance);

/// Degrees for files. An angle is held in radians, so 120 degrees may come back as
/// 119.99999999999999; this gives 120.
[[nodiscard]] double tidy_degrees(Angle angle);

}  // namespace swathplan
