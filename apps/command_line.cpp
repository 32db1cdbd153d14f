// The one file that knows CLI11.
#include "apps/command_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <set>
#include <span>

#include "apps/config_file.h"
#include "apps/profiles.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

constexpr int kTypingError = 2;

/// A row and its option in CLI11.
struct Registered {
  Option row;
  CLI::Option* typed;
};

CLI::Option* registered(CLI::App& app, const Option& row) {
  // CLI11 hides options without a group.
  const std::string group = row.group.empty() ? "Options" : row.group;
  if (is_switch(row)) return app.add_flag(row.flag, row.help)->group(group);
  CLI::Option* option = app.add_option(
      row.flag, [](const CLI::results_t&) { return true; }, row.help);
  option->type_name(type_name(row))->required(row.required);
  if (!is_argument(row)) option->group(group)->default_str(default_text(row));
  if (is_list(row)) {
    option->delimiter(',');
    if (row.count > 0) {
      option->expected(static_cast<int>(row.count));
    } else {
      // Each flag takes one text, so that the argument behind it stays one.
      option->expected(1, CLI::detail::expected_max_vector_size)->allow_extra_args(false);
    }
  }
  return option;
}

/// The row that a configuration file calls by its name in outputs or by its flag.
const Option* row_called(const OptionTable& options, const std::string& name) {
  for (const Option& option : options) {
    if (is_argument(option) || option.flag == "--config") continue;
    if ((!option.name.empty() && option.name == name) || "--" + name == long_flag(option)) {
      return &option;
    }
  }
  return nullptr;
}

/// Files that outputs name without their folder are looked for beside the configuration file.
void set_from_config(const Option& option, const ConfigEntry& entry,
                     const std::filesystem::path& config) {
  set(option, entry.texts);
  auto* const* slot = std::get_if<std::filesystem::path*>(&option.slot);
  if (slot == nullptr || option.name.empty() || (*slot)->empty()) return;
  const std::filesystem::path beside = config.parent_path() / **slot;
  if (!std::filesystem::exists(beside)) {
    throw UsageError(
        fmt::format("'{}' names the file '{}', which is not beside it; copy it there or give it "
                    "with {}",
                    config.string(), (*slot)->string(), long_flag(option)));
  }
  **slot = beside;
}

/// Fills options that were not typed, and returns their names. It ignores options of other
/// commands, so that one file can serve several commands.
std::set<std::string> read_config_into(const std::vector<Registered>& rows,
                                       const OptionTable& of_all_commands,
                                       const std::filesystem::path& config) {
  std::set<std::string> names;
  OptionTable table;
  for (const Registered& r : rows) table.push_back(r.row);
  std::set<const Option*> filled;
  for (const ConfigEntry& entry : read_config(config)) {
    const Option* row = row_called(table, entry.name);
    if (row == nullptr) {
      if (row_called(of_all_commands, entry.name) != nullptr) continue;
      throw UsageError(fmt::format("'{}': there is no option '{}'", config.string(), entry.name));
    }
    if (!filled.insert(row).second) {
      throw UsageError(fmt::format("'{}': {} is given twice, once as '{}'", config.string(),
                                   long_flag(*row), entry.name));
    }
    if (rows[static_cast<std::size_t>(row - table.data())].typed->count() > 0) continue;
    set_from_config(*row, entry, config);
    names.insert(row->name);
  }
  return names;
}

/// Fills the rows of a profile that were neither typed nor stand in the configuration file.
void apply_rows(const std::vector<Registered>& rows, const std::set<std::string>& configured,
                std::span<const ProfileRow> profile) {
  for (const ProfileRow& line : profile) {
    for (const Registered& r : rows) {
      const bool given = r.typed->count() > 0 || configured.count(r.row.name) > 0;
      if (r.row.name == line.name && !given) set(r.row, {std::string(line.value)});
    }
  }
}

bool names_a_chart(const std::vector<Registered>& rows) {
  return std::any_of(rows.begin(), rows.end(), [](const Registered& r) {
    auto* const* slot = std::get_if<std::filesystem::path*>(&r.row.slot);
    return slot != nullptr && r.row.flag == "FILE" && (*slot)->extension() == kChartExtension;
  });
}

void apply_profile(const std::vector<Registered>& rows, const std::set<std::string>& configured) {
  if (names_a_chart(rows)) apply_rows(rows, configured, kChartRows);
  const auto chosen = std::find_if(rows.begin(), rows.end(),
                                   [](const Registered& r) { return r.row.flag == "--profile"; });
  if (chosen == rows.end()) return;
  check(chosen->row);
  const std::string& name = *std::get<std::string*>(chosen->row.slot);
  for (const Profile& profile : kProfiles) {
    if (profile.name == name) apply_rows(rows, configured, profile.rows);
  }
}

void check_excludes(const OptionTable& options) {
  const auto given = [](const Option& option) { return value_of(option).has_value(); };
  for (const Option& option : options) {
    if (option.excludes.empty() || !given(option)) continue;
    for (const Option& other : only(options, option.excludes)) {
      if (!given(other)) continue;
      throw UsageError(fmt::format("{} and {} exclude each other; give one of them",
                                   long_flag(option), long_flag(other)));
    }
  }
}

void fill_and_check(const std::vector<Registered>& rows, const OptionTable& of_all_commands,
                    const std::filesystem::path& config) {
  for (const Registered& r : rows) {
    if (r.typed->count() == 0) continue;
    set(r.row, is_switch(r.row) ? std::vector<std::string>{"true"} : r.typed->results());
  }
  std::set<std::string> configured;
  if (!config.empty()) configured = read_config_into(rows, of_all_commands, config);
  apply_profile(rows, configured);
  OptionTable table, typed;
  for (const Registered& r : rows) {
    check(r.row);
    table.push_back(r.row);
    // A configuration file may serve several planners, so only what was typed must be of use.
    if (r.typed->count() > 0) typed.push_back(r.row);
  }
  check_excludes(table);
  const auto instead = std::find_if(table.begin(), table.end(), [](const Option& option) {
    return option.instead_of_choice && value_of(option) != OptionValue(std::string());
  });
  if (instead != table.end()) {
    check_unchosen(typed, *instead);
  } else {
    check_used(typed, chosen_in(table));
  }
}

/// Runs the command. An error about a field of its rows names the row's flag.
void run_in_flags(const std::vector<Registered>& rows, const std::function<void()>& run) {
  try {
    run();
  } catch (const UsageError& error) {
    for (const Registered& r : rows) {
      if (is_argument(r.row) || field_of(r.row) != error.field()) continue;
      throw UsageError(long_flag(r.row) + std::string(error.what()).substr(error.field().size()));
    }
    throw;
  }
}

void add(CLI::App& app, const Command& command, const OptionTable& of_all_commands) {
  CLI::App* sub = app.add_subcommand(command.name, command.what);
  if (command.hidden) sub->group("");
  if (!command.commands.empty()) {
    sub->require_subcommand(1);
    for (const Command& below : command.commands) add(*sub, below, of_all_commands);
    return;
  }
  std::vector<Registered> rows;
  for (const Option& row : command.options) rows.push_back({row, registered(*sub, row)});
  CLI::Option* config = sub->add_option(
      "--config", [](const CLI::results_t&) { return true; },
      "Options from this file, where they are not typed: TOML (survey.toml beside the results), "
      "or score.json, plan.json");
  config->type_name("FILE");
  sub->callback([rows, config, run = command.run, &of_all_commands] {
    fill_and_check(rows, of_all_commands, config->count() > 0 ? config->results().front() : "");
    run_in_flags(rows, run);
  });
}

OptionTable options_of(const std::vector<Command>& commands) {
  OptionTable all;
  for (const Command& command : commands) {
    all = joined({std::move(all), command.options, options_of(command.commands)});
  }
  return all;
}

/// @throws UsageError for a first word that is no command, which CLI11 would not name.
void check_command(const std::vector<Command>& commands, int argc, const char* const* argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::vector<std::string> names;
  for (const Command& command : commands) {
    if (command.name == argv[1]) return;
    if (!command.hidden) names.push_back(command.name);
  }
  throw UsageError(
      fmt::format("'{}' is not a command; choose one of {}", argv[1], fmt::join(names, ", ")));
}

bool has_flag(const Command& command, const std::string& flag) {
  return std::any_of(command.options.begin(), command.options.end(),
                     [&](const Option& option) { return long_flag(option) == flag; });
}

/// The command that is called, and the words before its own.
const Command* called_command(const std::vector<Command>& commands, int argc,
                              const char* const* argv) {
  const std::vector<Command>* level = &commands;
  const Command* called = nullptr;
  for (int i = 1; i < argc; ++i) {
    const auto found = std::find_if(level->begin(), level->end(),
                                    [&](const Command& c) { return c.name == argv[i]; });
    if (found == level->end()) break;
    called = &*found;
    level = &found->commands;
  }
  return called;
}

/// @throws UsageError for a flag that other commands have and the one that is called has not.
void refuse_foreign_flag(const std::vector<Command>& commands, int argc, const char* const* argv) {
  const Command* called = called_command(commands, argc, argv);
  if (called == nullptr || !called->commands.empty()) return;
  for (int i = 2; i < argc; ++i) {
    const std::string word = argv[i];
    const std::string flag = word.substr(0, word.find('='));
    if (!flag.starts_with("--") || has_flag(*called, flag)) continue;
    std::vector<std::string> others;
    for (const Command& command : commands) {
      if (!command.hidden && has_flag(command, flag)) others.push_back(command.name);
    }
    if (others.empty()) continue;
    throw UsageError(fmt::format("{}; '{}' does not use it, but {} {}: leave it out", flag,
                                 called->name, fmt::join(others, ", "),
                                 others.size() == 1 ? "does" : "do"));
  }
}

}  // namespace

int run_commands(const std::string& what, const std::function<std::string()>& version,
                 const std::vector<Command>& commands, int argc, const char* const* argv) {
  check_command(commands, argc, argv);
  const OptionTable all = options_of(commands);
  CLI::App app{what};
  app.set_version_flag("--version", version);
  app.require_subcommand(1);
  for (const Command& command : commands) add(app, command, all);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ExtrasError& e) {
    refuse_foreign_flag(commands, argc, argv);
    app.exit(e);
    return kTypingError;
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : kTypingError;
  }
  return 0;
}

}  // namespace swathplan
