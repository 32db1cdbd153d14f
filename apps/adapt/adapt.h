#pragma once

#include <CLI/CLI.hpp>

namespace swathplan {

/// Adds `adapt accordion|spacing|quality simulate|study|live`.
void add_adapt_command(CLI::App& app);

}  // namespace swathplan
