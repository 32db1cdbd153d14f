#include "apps/package/bash_completion.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/package/man_pages.h"

namespace swathplan {
namespace {

constexpr const char* kHead =
    R"(# Completion of swathplan in bash, written from the table of options by 'swathplan man'.
_swathplan() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}
  local called= words= k
  COMPREPLY=()
  for ((k = 1; k < COMP_CWORD; ++k)); do
    case "$called/${COMP_WORDS[k]}" in
)";

constexpr const char* kTail =
    R"(  esac
  # Where no word fits, bash completes files.
  COMPREPLY=($(compgen -W "$words" -- "$current"))
}
complete -o default -F _swathplan swathplan
)";

using Words = std::vector<std::string>;

std::string joined_words(const Words& words) { return fmt::format("{}", fmt::join(words, " ")); }

std::string called(const std::string& before, const std::string& name) {
  return before.empty() ? name : before + " " + name;
}

/// Patterns that recognise the words of a call: "adapt/spacing".
void add_calls(const std::vector<Command>& commands, const std::string& before, Words& patterns) {
  for (const Command& command : commands) {
    if (command.hidden) continue;
    patterns.push_back(fmt::format("'{}/{}'", before, command.name));
    add_calls(command.commands, called(before, command.name), patterns);
  }
}

Words names_of(const std::vector<Command>& commands) {
  Words names;
  for (const Command& command : commands) {
    if (!command.hidden) names.push_back(command.name);
  }
  return names;
}

/// Where a word that leads to further commands was typed: these are offered.
std::string choice_of_commands(const std::string& call, const std::vector<Command>& commands,
                               const std::string& more) {
  return fmt::format("    '{}') words='{} {}' ;;\n", call, joined_words(names_of(commands)), more);
}

Words flags_of(const Command& command) {
  Words flags;
  for (const Option& option : command.options) {
    if (!is_argument(option)) flags.push_back(long_flag(option));
  }
  flags.insert(flags.end(), {"--config", "--help"});
  return flags;
}

std::string pattern_of(const Option& option) {
  std::string pattern = option.flag;
  if (const auto comma = pattern.find(','); comma != std::string::npos) pattern[comma] = '|';
  return pattern;
}

/// The words that may follow a flag: those that it allows, files (none here), or nothing.
std::string values_of(const Command& command) {
  std::string text;
  Words files{"--config"}, others;
  for (const Option& option : command.options) {
    if (is_argument(option) || is_switch(option)) continue;
    Words words = option.choices;
    for (const auto& [word, value] : option.words) words.push_back(word);
    if (!words.empty()) {
      text += fmt::format("        {}) words='{}' ;;\n", pattern_of(option), joined_words(words));
    } else if (std::holds_alternative<std::filesystem::path*>(option.slot)) {
      files.push_back(pattern_of(option));
    } else {
      others.push_back(pattern_of(option));
    }
  }
  text += fmt::format("        {}) return ;;\n", fmt::join(files, "|"));
  if (!others.empty()) {
    text += fmt::format("        {}) compopt +o default; return ;;\n", fmt::join(others, "|"));
  }
  return text;
}

std::string case_of(const NamedCommand& named) {
  return fmt::format(
      "    '{}')\n      case \"$previous\" in\n{}        *) [[ $current == -* ]] && words='{}' "
      ";;\n      esac\n      ;;\n",
      joined_words(named.words), values_of(*named.command), joined_words(flags_of(*named.command)));
}

void add_choices(const std::vector<Command>& commands, const std::string& before,
                 std::string& text) {
  for (const Command& command : commands) {
    if (command.hidden || command.commands.empty()) continue;
    const std::string call = called(before, command.name);
    text += choice_of_commands(call, command.commands, "--help");
    add_choices(command.commands, call, text);
  }
}

}  // namespace

std::string bash_completion(const std::vector<Command>& commands) {
  Words patterns;
  add_calls(commands, "", patterns);
  std::string text = kHead;
  text += fmt::format("      {})\n", fmt::join(patterns, "|"));
  text +=
      "        called=${called:+$called }${COMP_WORDS[k]} ;;\n    esac\n  done\n"
      "  case \"$called\" in\n";
  text += choice_of_commands("", commands, "--help --version");
  add_choices(commands, "", text);
  for (const NamedCommand& named : named_commands(commands)) text += case_of(named);
  return text + kTail;
}

}  // namespace swathplan
