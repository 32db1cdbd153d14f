#pragma once

#include <string>
#include <vector>

#include "apps/command_line.h"

namespace swathplan {

/// A file that is written from the table of options.
struct WrittenPage {
  std::string name;  ///< of the file: swathplan-plan.1
  std::string text;
};

/// The manual in roff: one page of the program, then one for each command that does something
/// itself. Hidden commands have none. The same commands and version give the same bytes.
[[nodiscard]] std::vector<WrittenPage> man_pages(const std::string& what,
                                                 const std::string& version,
                                                 const std::vector<Command>& commands);

/// A command that does something itself, and the words that call it: {"adapt", "spacing", "live"}.
struct NamedCommand {
  std::vector<std::string> words;
  const Command* command = nullptr;
};
/// All of them but the hidden ones, in the order of the list. They point into it.
[[nodiscard]] std::vector<NamedCommand> named_commands(const std::vector<Command>& commands);

}  // namespace swathplan
