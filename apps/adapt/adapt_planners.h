#pragma once

#include <CLI/CLI.hpp>

// Each adds its planner with simulate, study and live below `adapt`.
namespace swathplan {

void add_adapt_accordion(CLI::App& adapt);
void add_adapt_spacing(CLI::App& adapt);
void add_adapt_quality(CLI::App& adapt);

}  // namespace swathplan
