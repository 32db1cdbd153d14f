#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "mesh/base/angle.h"

namespace swathplan {

/// The value of an option as it was in force.
using OptionValue = std::variant<bool, std::int64_t, double, std::string, std::vector<double>>;

/// What made an output, so that it can be made again. It holds nothing that differs between two
/// runs or machines: no time, no folder, no number of threads.
struct Provenance {
  std::string version;     ///< of swathplan
  std::string command;     ///< the subcommand, as 'plan'
  std::string input_file;  ///< of the seafloor; outputs show its name without the folder
  std::string input_hash;  ///< see file_hash.h
  std::uint64_t seed = 1;
  /// In the order of the command line; a name carries its unit, as 'resolution_m'.
  std::vector<std::pair<std::string, OptionValue>> options;
};

/// Degrees for files: 120 and not 119.99999999999999, as angles come back from radians.
[[nodiscard]] double tidy_degrees(Angle angle);

}  // namespace swathplan
