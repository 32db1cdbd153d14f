#pragma once

#include <functional>
#include <string>
#include <vector>

#include "apps/option_table.h"

namespace swathplan {

/// A subcommand: its rows, and what it does once they are filled and checked. What the rows point
/// to must live as long as the command.
struct Command {
  std::string name, what;
  OptionTable options;
  std::function<void()> run;
  std::vector<Command> commands;  ///< below this one, which then does nothing itself
  bool hidden = false;            ///< not in the help: for those who build the program
};

/// Fills and checks the options of the command that is asked for and runs it. What is typed goes
/// before what --config says. `version` is asked for --version only. Returns 0, or what the help or
/// a mistake in typing gives.
/// @throws UsageError that names flag, value and rule; whatever the command throws.
int run_commands(const std::string& what, const std::function<std::string()>& version,
                 const std::vector<Command>& commands, int argc, const char* const* argv);

}  // namespace swathplan
