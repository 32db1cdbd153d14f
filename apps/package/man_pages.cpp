#include "apps/package/man_pages.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace swathplan {
namespace {

/// Text as roff prints it: no hyphens in place of minus signs, no escapes. Only a line's first
/// character can begin a request, so a zero-width character goes before a dot or a quote there.
std::string roff(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (out.empty() && (c == '.' || c == '\'')) out += "\\&";
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else {
      out += c;
    }
  }
  return out;
}

std::string bold(const std::string& text) { return "\\fB" + roff(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + roff(text) + "\\fR"; }

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

std::string head(const std::string& page, const std::string& version, const std::string& what) {
  return fmt::format(
      ".\\\" Written from the table of options by 'swathplan man'.\n"
      ".TH {} 1 \"\" \"swathplan {}\" \"swathplan\"\n.SH NAME\n{} \\- {}\n",
      roff(upper(page)), roff(version), roff(page), roff(what));
}

/// A paragraph with a hanging label.
std::string entry(const std::string& label, const std::string& text) {
  return fmt::format(".TP\n{}\n{}\n", label, roff(text));
}

std::string with_full_stop(std::string text) {
  if (!text.empty() && text.back() != '.') text += '.';
  return text;
}

std::string label_of(const Option& option) {
  if (is_argument(option)) return italic(option.flag);
  std::string label = option.flag;
  if (const auto comma = label.find(','); comma != std::string::npos) label.insert(comma + 1, " ");
  label = bold(label);
  return is_switch(option) ? label : label + " " + italic(type_name(option));
}

/// The help, the rule of a number, the default.
std::string description_of(const Option& option) {
  std::string text = with_full_stop(option.help);
  const Rule& rule = option.rule;
  if (std::isfinite(rule.least) || std::isfinite(rule.most)) {
    std::string must = sentence(rule, option.unit);
    must.front() = 'M';
    text += " " + with_full_stop(must);
  }
  if (option.required && !is_argument(option)) text += " It must be given.";
  const std::string value = is_argument(option) ? "" : default_text(option);
  return value.empty() ? text : text + fmt::format(" Default: {}.", value);
}

std::string arguments_of(const Command& command) {
  std::string text;
  for (const Option& option : command.options) {
    if (is_argument(option)) text += " " + italic(option.flag);
  }
  return text;
}

/// The rows under their headings. A heading stands where the help has it: where it comes first.
std::string options_text(const Command& command) {
  std::vector<std::string> groups;
  std::string text;
  for (const Option& option : command.options) {
    if (is_argument(option)) text += entry(label_of(option), description_of(option));
    if (std::find(groups.begin(), groups.end(), option.group) == groups.end()) {
      groups.push_back(option.group);
    }
  }
  for (const std::string& group : groups) {
    std::string rows;
    for (const Option& option : command.options) {
      if (is_argument(option) || option.group != group) continue;
      rows += entry(label_of(option), description_of(option));
    }
    if (rows.empty()) continue;
    text += fmt::format(".SS {}\n{}", group.empty() ? "General" : roff(group), rows);
  }
  return text;
}

constexpr const char* kConfig =
    ".TP\n\\fB\\-\\-config\\fR \\fIFILE\\fR\n"
    "Take options that are not typed from this file: TOML, as the survey.toml that stands beside\n"
    "results, or a score.json or plan.json.\n"
    ".TP\n\\fB\\-h\\fR, \\fB\\-\\-help\\fR\nPrint the options and end.\n";

constexpr const char* kExitStatus =
    ".SH EXIT STATUS\n"
    ".TP\n0\nThe command did its work.\n"
    ".TP\n1\nData cannot be used as they are. The message names the file and what to do.\n"
    ".TP\n2\nAn option breaks its rule. The message names the option, its value and the rule.\n"
    ".TP\n3\nThe survey is predicted to fail the criterion that it was required to pass.\n"
    ".TP\n130\nCtrl-C stopped the work. A first one ends a search, whose best plan is kept.\n";

std::string page_of(const NamedCommand& named, const std::string& version) {
  const std::string page = fmt::format("swathplan-{}", fmt::join(named.words, "-"));
  return head(page, version, named.command->what) +
         fmt::format(".SH SYNOPSIS\n{}{} [{}]\n.SH OPTIONS\n{}{}{}.SH SEE ALSO\n{}(1)\n",
                     bold(fmt::format("swathplan {}", fmt::join(named.words, " "))),
                     arguments_of(*named.command), italic("OPTIONS"), options_text(*named.command),
                     kConfig, kExitStatus, bold("swathplan"));
}

std::string main_page(const std::string& what, const std::string& version,
                      const std::vector<NamedCommand>& commands) {
  std::string text = head("swathplan", version, what) +
                     fmt::format(".SH SYNOPSIS\n{} {} [{}]\n.SH COMMANDS\n", bold("swathplan"),
                                 italic("COMMAND"), italic("OPTIONS"));
  for (const NamedCommand& named : commands) {
    std::string words = fmt::format("{}", fmt::join(named.words, " "));
    text += entry(bold(words) + arguments_of(*named.command), with_full_stop(named.command->what));
  }
  text +=
      ".SH OPTIONS\n"
      ".TP\n\\fB\\-h\\fR, \\fB\\-\\-help\\fR\nPrint the commands, or the options of a command.\n"
      ".TP\n\\fB\\-\\-version\\fR\nPrint the versions of the program and of its libraries.\n";
  text += kExitStatus;
  text += ".SH SEE ALSO\n";
  for (std::size_t k = 0; k < commands.size(); ++k) {
    text += fmt::format(".BR swathplan\\-{} (1){}\n",
                        roff(fmt::format("{}", fmt::join(commands[k].words, "-"))),
                        k + 1 < commands.size() ? "," : "");
  }
  return text;
}

void add_named(const std::vector<Command>& commands, const std::vector<std::string>& before,
               std::vector<NamedCommand>& named) {
  for (const Command& command : commands) {
    if (command.hidden) continue;
    std::vector<std::string> words = before;
    words.push_back(command.name);
    if (command.commands.empty()) {
      named.push_back({words, &command});
    } else {
      add_named(command.commands, words, named);
    }
  }
}

}  // namespace

std::vector<NamedCommand> named_commands(const std::vector<Command>& commands) {
  std::vector<NamedCommand> named;
  add_named(commands, {}, named);
  return named;
}

std::vector<WrittenPage> man_pages(const std::string& what, const std::string& version,
                                   const std::vector<Command>& commands) {
  const std::vector<NamedCommand> named = named_commands(commands);
  std::vector<WrittenPage> pages{{"swathplan.1", main_page(what, version, named)}};
  for (const NamedCommand& n : named) {
    pages.push_back({fmt::format("swathplan-{}.1", fmt::join(n.words, "-")), page_of(n, version)});
  }
  return pages;
}

}  // namespace swathplan
