#pragma once

#include <string>
#include <vector>

#include "apps/command_line.h"

namespace swathplan {

/// A script that completes commands, options and the words that an option allows in bash. Files
/// are completed where an option or an argument takes one. Hidden commands are left out.
[[nodiscard]] std::string bash_completion(const std::vector<Command>& commands);

}  // namespace swathplan
