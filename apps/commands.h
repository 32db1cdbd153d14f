#pragma once

#include <stdexcept>

#include "apps/command_line.h"

// The subcommands. They throw UsageError and InvalidInput; main turns these into exit codes.
namespace swathplan {

/// A survey had to pass its criterion and is predicted to fail it (exit code 3).
class PredictedToFail : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

[[nodiscard]] Command inspect_command();
[[nodiscard]] Command synth_command();
[[nodiscard]] Command plan_command();
[[nodiscard]] Command compare_command();
[[nodiscard]] Command lines_command();
[[nodiscard]] Command score_command();
[[nodiscard]] Command export_command();
/// `adapt accordion|spacing|quality simulate|study|live`.
[[nodiscard]] Command adapt_command();

/// `demo`: runs `compare` on a seafloor that comes with the program.
[[nodiscard]] Command demo_command(Command compare);
/// `man`: writes the manual and the bash completion of the other commands. Hidden.
[[nodiscard]] Command man_command(const std::string& what, const std::vector<Command>& commands);

/// The program's version, and those of the libraries that it runs with, one a line.
[[nodiscard]] std::string version_text();

}  // namespace swathplan
