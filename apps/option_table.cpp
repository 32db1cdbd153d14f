#include "apps/option_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "mesh/base/error.h"

namespace swathplan {
namespace {

template <class... Visitors>
struct Overloaded : Visitors... {
  using Visitors::operator()...;
};
template <class... Visitors>
Overloaded(Visitors...) -> Overloaded<Visitors...>;

/// The whole text as a number; empty if it is none.
template <class T>
std::optional<T> parsed(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  T value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

[[noreturn]] void refuse(const Option& option, const std::string& text, const std::string& rule) {
  throw UsageError(fmt::format("{} {}; {}", long_flag(option), text.empty() ? "''" : text, rule));
}

/// What may stand behind a speed, and the m/s that one of it makes.
constexpr std::array<std::pair<std::string_view, double>, 6> kSpeedUnits{
    {{"kn", 1852.0 / 3600.0},
     {"kt", 1852.0 / 3600.0},
     {"kts", 1852.0 / 3600.0},
     {"knots", 1852.0 / 3600.0},
     {"km/h", 1.0 / 3.6},
     {"m/s", 1.0}}};

/// '4kn', '4 kn', '7.4km/h' or '2.1m/s' in m/s; empty if it is none.
std::optional<double> speed_in_words(std::string_view text) {
  for (const auto& [unit, factor] : kSpeedUnits) {
    if (!text.ends_with(unit)) continue;
    std::string_view before = text.substr(0, text.size() - unit.size());
    while (before.ends_with(' ')) before.remove_suffix(1);
    if (const auto value = parsed<double>(before)) return *value * factor;
  }
  return std::nullopt;
}

double number(const Option& option, const std::string& text) {
  for (const auto& [word, value] : option.words) {
    if (text == word) return value;
  }
  if (const auto value = parsed<double>(text)) return *value;
  if (option.unit == kMetresPerSecond) {
    if (const auto value = speed_in_words(text)) return *value;
    refuse(option, text, "must be a number of m/s, or a speed as 4kn, 7.4km/h or 2.1m/s");
  }
  if (option.words.empty()) {
    refuse(option, text,
           option.unit.empty() ? "must be a number"
                               : fmt::format("must be a number of {}", option.unit));
  }
  std::vector<std::string> words;
  for (const auto& [word, value] : option.words) words.push_back(word);
  words.push_back(fmt::format("a number of {}", option.unit));
  refuse(option, text, "must be " + either(words));
}

template <class T>
T whole_number(const Option& option, const std::string& text) {
  if (const auto value = parsed<T>(text)) return *value;
  refuse(option, text,
         std::is_signed_v<T> ? "must be a whole number" : "must be a whole number of 0 or more");
}

bool truth(const Option& option, const std::string& text) {
  if (text == "true") return true;
  if (text == "false") return false;
  refuse(option, text, "must be true or false");
}

std::vector<std::string> parts_of(const std::vector<std::string>& typed) {
  std::vector<std::string> parts;
  for (const std::string& text : typed) {
    std::size_t from = 0;
    while (from <= text.size()) {
      const std::size_t to = std::min(text.find(',', from), text.size());
      if (to > from) parts.push_back(text.substr(from, to - from));
      from = to + 1;
    }
  }
  return parts;
}

void check_number(const Option& option, double value) {
  if (!holds(option.rule, value)) {
    refuse(option, fmt::format("{:g}", value), sentence(option.rule, option.unit));
  }
}

void check_text(const Option& option, const std::string& value) {
  if (option.not_empty && value.empty()) {
    throw UsageError(fmt::format("{} is empty; name a folder", long_flag(option)));
  }
  const auto& choices = option.choices;
  if (!choices.empty() && std::find(choices.begin(), choices.end(), value) == choices.end()) {
    refuse(option, value, "must be " + either(choices));
  }
}

/// "--heading 30", or the flag alone of a switch.
std::string as_typed(const Option& option) {
  const std::string value = is_switch(option) ? "" : default_text(option);
  return value.empty() ? long_flag(option) : long_flag(option) + " " + value;
}

}  // namespace

Rule any_number() { return {}; }
Rule at_least(double least) { return {.least = least}; }
Rule above(double least) { return {.least = least, .with_least = false}; }
Rule within(double least, double most) { return {.least = least, .most = most}; }
Rule between(double least, double most, std::string why) {
  return {least, most, false, false, std::move(why)};
}
Rule at_least_under(double least, double most) {
  return {.least = least, .most = most, .with_most = false};
}
Rule above_at_most(double least, double most) {
  return {.least = least, .most = most, .with_least = false};
}

bool holds(const Rule& rule, double value) {
  return std::isfinite(value) && (rule.with_least ? value >= rule.least : value > rule.least) &&
         (rule.with_most ? value <= rule.most : value < rule.most);
}

std::string sentence(const Rule& rule, Unit unit) {
  const std::string in = unit.empty() ? "" : fmt::format(" {}", unit);
  const bool low = std::isfinite(rule.least);
  const bool high = std::isfinite(rule.most);
  std::string text;
  if (!low && !high) {
    text = unit.empty() ? "must be a finite number" : fmt::format("must be a number of {}", unit);
  } else if (!high) {
    text = rule.with_least ? fmt::format("must be {:g}{} or more", rule.least, in)
                           : fmt::format("must be above {:g}{}", rule.least, in);
  } else if (rule.with_least && rule.with_most) {
    text = fmt::format("must be {:g} to {:g}{}", rule.least, rule.most, in);
  } else if (rule.with_least) {
    text = fmt::format("must be at least {:g} and under {:g}{}", rule.least, rule.most, in);
  } else if (rule.with_most) {
    text = fmt::format("must be above {:g} and at most {:g}{}", rule.least, rule.most, in);
  } else {
    text =
        fmt::format("must lie between {:g} and {:g}{}, both excluded", rule.least, rule.most, in);
  }
  return rule.why.empty() ? text : text + ": " + rule.why;
}

Option real(std::string flag, std::string group, double& value, Unit unit, Rule rule,
            std::string help, std::string name) {
  return {.flag = std::move(flag),
          .group = std::move(group),
          .slot = &value,
          .unit = unit,
          .rule = std::move(rule),
          .help = std::move(help),
          .name = std::move(name)};
}

Option real(std::string flag, std::string group, std::optional<double>& value, Unit unit, Rule rule,
            std::string help, std::string name) {
  return {.flag = std::move(flag),
          .group = std::move(group),
          .slot = &value,
          .unit = unit,
          .rule = std::move(rule),
          .help = std::move(help),
          .name = std::move(name)};
}

Option whole(std::string flag, std::string group, int& value, Rule rule, std::string help,
             std::string name) {
  return {.flag = std::move(flag),
          .group = std::move(group),
          .slot = &value,
          .rule = std::move(rule),
          .help = std::move(help),
          .name = std::move(name)};
}

Option whole(std::string flag, std::string group, std::optional<int>& value, Rule rule,
             std::string help, std::string name) {
  return {.flag = std::move(flag),
          .group = std::move(group),
          .slot = &value,
          .rule = std::move(rule),
          .help = std::move(help),
          .name = std::move(name)};
}

Option whole(std::string flag, std::string group, std::uint64_t& value, std::string help,
             std::string name) {
  return {.flag = std::move(flag),
          .group = std::move(group),
          .slot = &value,
          .help = std::move(help),
          .name = std::move(name)};
}

Option choice(std::string flag, std::string group, std::string& value,
              std::vector<std::string> choices, std::string help, std::string name) {
  Option option = text(std::move(flag), std::move(group), value, std::move(help), std::move(name));
  option.choices = std::move(choices);
  return option;
}

Option text(std::string flag, std::string group, std::string& value, std::string help,
            std::string name) {
  return {.flag = std::move(flag),
          .group = std::move(group),
          .slot = &value,
          .help = std::move(help),
          .name = std::move(name)};
}

Option texts(std::string flag, std::string group, std::vector<std::string>& value, std::string help,
             std::string name) {
  return {.flag = std::move(flag),
          .group = std::move(group),
          .slot = &value,
          .help = std::move(help),
          .name = std::move(name)};
}

Option path(std::string flag, std::string group, std::filesystem::path& value, std::string help,
            std::string name) {
  return {.flag = std::move(flag),
          .group = std::move(group),
          .slot = &value,
          .help = std::move(help),
          .name = std::move(name)};
}

Option flag(std::string flag, std::string group, bool& value, std::string help, std::string name) {
  return {.flag = std::move(flag),
          .group = std::move(group),
          .slot = &value,
          .help = std::move(help),
          .name = std::move(name)};
}

Option argument(std::string word, std::filesystem::path& value, std::string help) {
  return required(path(std::move(word), "", value, std::move(help), ""));
}

Option argument(std::string word, std::string& value, std::string help) {
  return required(text(std::move(word), "", value, std::move(help), ""));
}

Option required(Option option) {
  option.required = true;
  return option;
}

Option chooser(Option option) {
  option.chooses = true;
  return option;
}

Option used_by(std::vector<std::string> chosen, Option option) {
  option.used_by = std::move(chosen);
  return option;
}

std::string either(const std::vector<std::string>& words) {
  if (words.size() < 2) return words.empty() ? "" : words.front();
  const std::vector<std::string> all_but_last(words.begin(), words.end() - 1);
  return fmt::format("{} or {}", fmt::join(all_but_last, ", "), words.back());
}

std::vector<std::string> chosen_in(const OptionTable& table) {
  for (const Option& option : table) {
    if (!option.chooses) continue;
    if (const auto* list = std::get_if<std::vector<std::string>*>(&option.slot)) return **list;
    return {*std::get<std::string*>(option.slot)};
  }
  return {};
}

void check_used(const OptionTable& typed, const std::vector<std::string>& chosen) {
  for (const Option& option : typed) {
    const auto uses = [&](const std::string& name) {
      return std::find(option.used_by.begin(), option.used_by.end(), name) != option.used_by.end();
    };
    if (chosen.empty() || option.used_by.empty()) continue;
    if (std::any_of(chosen.begin(), chosen.end(), uses)) continue;
    throw UsageError(fmt::format("{}; {} {} not use it: leave it out, or choose {}",
                                 as_typed(option), fmt::join(chosen, ", "),
                                 chosen.size() == 1 ? "does" : "do", either(option.used_by)));
  }
}

void check_unchosen(const OptionTable& typed, const Option& instead) {
  for (const Option& option : typed) {
    const std::vector<std::string>& kept = *instead.instead_of_choice;
    const bool is_kept = std::find(kept.begin(), kept.end(), long_flag(option)) != kept.end();
    if (is_kept || (!option.chooses && option.used_by.empty())) continue;
    throw UsageError(fmt::format("{}: with {} no planner runs; leave one of them out",
                                 as_typed(option), long_flag(instead)));
  }
}

OptionTable joined(std::vector<OptionTable> tables) {
  OptionTable all;
  for (OptionTable& table : tables) {
    for (Option& option : table) all.push_back(std::move(option));
  }
  return all;
}

OptionTable only(const OptionTable& table, const std::vector<std::string>& flags) {
  OptionTable some;
  for (const Option& option : table) {
    if (std::find(flags.begin(), flags.end(), long_flag(option)) != flags.end()) {
      some.push_back(option);
    }
  }
  return some;
}

OptionTable without(const OptionTable& table, const std::vector<std::string>& flags) {
  OptionTable rest = table;
  std::erase_if(rest, [&](const Option& option) {
    return std::find(flags.begin(), flags.end(), long_flag(option)) != flags.end();
  });
  return rest;
}

std::string long_flag(const Option& option) {
  return option.flag.substr(option.flag.find(',') + 1);
}

std::string field_of(const Option& option) {
  std::string field = long_flag(option);
  field.erase(0, field.find_first_not_of('-'));
  std::replace(field.begin(), field.end(), '-', ' ');
  return field;
}

bool is_argument(const Option& option) { return !option.flag.starts_with('-'); }

bool is_switch(const Option& option) { return std::holds_alternative<bool*>(option.slot); }

bool is_list(const Option& option) {
  return std::holds_alternative<std::vector<std::string>*>(option.slot) ||
         std::holds_alternative<std::vector<double>*>(option.slot);
}

void set(const Option& option, const std::vector<std::string>& typed) {
  const std::string one = fmt::format("{}", fmt::join(typed, ","));
  std::visit(
      Overloaded{[&](double* v) { *v = number(option, one); },
                 [&](std::optional<double>* v) { *v = number(option, one); },
                 [&](int* v) { *v = whole_number<int>(option, one); },
                 [&](std::optional<int>* v) { *v = whole_number<int>(option, one); },
                 [&](std::uint64_t* v) { *v = whole_number<std::uint64_t>(option, one); },
                 [&](bool* v) { *v = truth(option, one); }, [&](std::string* v) { *v = one; },
                 [&](std::filesystem::path* v) { *v = one; },
                 [&](std::vector<std::string>* v) { *v = parts_of(typed); },
                 [&](std::vector<double>* v) {
                   v->clear();
                   for (const std::string& part : parts_of(typed)) {
                     v->push_back(number(option, part));
                   }
                   if (option.count > 0 && !v->empty() && v->size() != option.count) {
                     refuse(option, one, fmt::format("must be {} numbers", option.count));
                   }
                 }},
      option.slot);
}

void check(const Option& option) {
  std::visit(Overloaded{[&](const double* v) { check_number(option, *v); },
                        [&](const std::optional<double>* v) {
                          if (*v) check_number(option, **v);
                        },
                        [&](const int* v) { check_number(option, *v); },
                        [&](const std::optional<int>* v) {
                          if (*v) check_number(option, **v);
                        },
                        [&](const std::uint64_t*) {}, [&](const bool*) {},
                        [&](const std::string* v) { check_text(option, *v); },
                        [&](const std::filesystem::path* v) { check_text(option, v->string()); },
                        [&](const std::vector<std::string>*) {},
                        [&](const std::vector<double>* v) {
                          for (const double x : *v) check_number(option, x);
                        }},
             option.slot);
}

std::optional<OptionValue> value_of(const Option& option) {
  using Value = std::optional<OptionValue>;
  return std::visit(
      Overloaded{
          [](const double* v) -> Value { return *v; },
          [](const std::optional<double>* v) -> Value { return *v ? Value(**v) : std::nullopt; },
          [](const int* v) -> Value { return std::int64_t{*v}; },
          [](const std::optional<int>* v) -> Value {
            return *v ? Value(std::int64_t{**v}) : std::nullopt;
          },
          [](const std::uint64_t* v) -> Value { return static_cast<std::int64_t>(*v); },
          [](const bool* v) -> Value { return *v; },
          [](const std::string* v) -> Value { return *v; },
          [](const std::filesystem::path* v) -> Value { return v->filename().string(); },
          [](const std::vector<std::string>* v) -> Value { return *v; },
          [](const std::vector<double>* v) -> Value { return *v; }},
      option.slot);
}

std::string type_name(const Option& option) {
  if (!option.choices.empty()) return fmt::format("{{{}}}", fmt::join(option.choices, ","));
  if (std::holds_alternative<int*>(option.slot) ||
      std::holds_alternative<std::optional<int>*>(option.slot)) {
    return "INT";
  }
  if (std::holds_alternative<std::uint64_t*>(option.slot)) return "UINT";
  const bool real = std::holds_alternative<double*>(option.slot) ||
                    std::holds_alternative<std::optional<double>*>(option.slot);
  if (real && option.unit == kMetresPerSecond) return "SPEED";
  return real && option.words.empty() ? "FLOAT" : "TEXT";
}

std::string default_text(const Option& option) {
  for (const auto& [word, value] : option.words) {
    if (const auto* slot = std::get_if<double*>(&option.slot); slot != nullptr && **slot == value) {
      return word;
    }
  }
  return std::visit(
      Overloaded{
          [](const double* v) { return fmt::format("{}", *v); },
          [](const std::optional<double>* v) { return *v ? fmt::format("{}", **v) : ""; },
          [](const int* v) { return fmt::format("{}", *v); },
          [](const std::optional<int>* v) { return *v ? fmt::format("{}", **v) : ""; },
          [](const std::uint64_t* v) { return fmt::format("{}", *v); },
          [](const bool*) { return std::string(); }, [](const std::string* v) { return *v; },
          [](const std::filesystem::path* v) { return v->string(); },
          [](const std::vector<std::string>* v) { return fmt::format("{}", fmt::join(*v, ",")); },
          [](const std::vector<double>* v) { return fmt::format("{}", fmt::join(*v, ",")); }},
      option.slot);
}

void record(Provenance& provenance, const OptionTable& typed, const OptionTable& in_force) {
  for (std::size_t i = 0; i < in_force.size(); ++i) {
    const Option& option = in_force[i];
    if (const auto* seed = std::get_if<std::uint64_t*>(&option.slot);
        seed != nullptr && option.name == "seed") {
      provenance.seed = **seed;  // it has a place of its own
      continue;
    }
    auto value = option.name.empty() ? std::nullopt : value_of(option);
    if (!value) continue;
    if (value_of(typed[i]) != value) provenance.derived.push_back(option.name);
    provenance.options.emplace_back(option.name, std::move(*value));
  }
}

}  // namespace swathplan
