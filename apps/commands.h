#pragma once

#include <CLI/CLI.hpp>

// Each adds its subcommand to the program. Callbacks throw UsageError and InvalidInput; main turns
// them into exit codes.
namespace swathplan {

void add_inspect_command(CLI::App& app);
void add_synth_command(CLI::App& app);
void add_plan_command(CLI::App& app);
void add_compare_command(CLI::App& app);
void add_lines_command(CLI::App& app);
void add_score_command(CLI::App& app);
void add_export_command(CLI::App& app);

}  // namespace swathplan
