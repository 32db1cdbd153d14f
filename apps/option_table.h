#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "io/results/provenance.h"

// The table of options. A row is all that the program knows of an option: how it is typed, where
// its value goes, its unit and rule, its help, and its name in outputs and configuration files. The
// command line, the checks, the help, the provenance and the configuration file all read the rows.
namespace swathplan {

/// The unit of a value, as messages write it; empty for a pure number.
using Unit = std::string_view;
inline constexpr Unit kNoUnit = {}, kMetres = "metres", kSquareMetres = "square metres",
                      kDegrees = "degrees", kMetresPerSecond = "m/s", kHertz = "Hz",
                      kHours = "hours", kPerCent = "per cent", kWatts = "watts";

/// The numbers that a row allows; never those that are not finite.
struct Rule {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  bool with_least = true, with_most = true;  ///< the ends are allowed themselves
  std::string why = {};                      ///< added to the message; may be empty
};
[[nodiscard]] Rule any_number();
[[nodiscard]] Rule at_least(double least);
[[nodiscard]] Rule above(double least);
/// [least, most].
[[nodiscard]] Rule within(double least, double most);
/// (least, most).
[[nodiscard]] Rule between(double least, double most, std::string why = {});
/// [least, most).
[[nodiscard]] Rule at_least_under(double least, double most);
/// (least, most].
[[nodiscard]] Rule above_at_most(double least, double most);

[[nodiscard]] bool holds(const Rule& rule, double value);
/// "must be 0 metres or more".
[[nodiscard]] std::string sentence(const Rule& rule, Unit unit);

/// Where a row's value goes. Empty optionals follow from other options.
using Slot = std::variant<double*, std::optional<double>*, int*, std::optional<int>*,
                          std::uint64_t*, bool*, std::string*, std::filesystem::path*,
                          std::vector<std::string>*, std::vector<double>*>;

/// One option. The slot must outlive the row.
struct Option {
  std::string flag;   ///< "--draft", "-o,--output", or "FILE" for a positional argument
  std::string group;  ///< the heading in the help
  Slot slot;
  Unit unit = kNoUnit;
  Rule rule = {};
  std::string help;
  std::string name;  ///< in outputs, with its unit; empty: results do not depend on it
  std::vector<std::string> choices = {};                   ///< of a text; empty: any
  std::vector<std::pair<std::string, double>> words = {};  ///< that stand for a number
  std::size_t count = 0;                                   ///< of a list; 0: any
  bool required = false, not_empty = false;
  std::vector<std::string> excludes = {};  ///< flags that may not be given together with this one
  std::vector<std::string> used_by = {};   ///< values of the row that `chooses`; empty: all
  bool chooses = false;                    ///< its value or values decide which other rows are used
  /// Where it is given, nothing is chosen, and of the rows that hang on the choice only those of
  /// these flags are used.
  std::optional<std::vector<std::string>> instead_of_choice = {};
};
using OptionTable = std::vector<Option>;

/// A number; an optional one follows from other options where it is not given.
[[nodiscard]] Option real(std::string flag, std::string group, double& value, Unit unit, Rule rule,
                          std::string help, std::string name);
[[nodiscard]] Option real(std::string flag, std::string group, std::optional<double>& value,
                          Unit unit, Rule rule, std::string help, std::string name);
/// A whole number.
[[nodiscard]] Option whole(std::string flag, std::string group, int& value, Rule rule,
                           std::string help, std::string name);
[[nodiscard]] Option whole(std::string flag, std::string group, std::optional<int>& value,
                           Rule rule, std::string help, std::string name);
[[nodiscard]] Option whole(std::string flag, std::string group, std::uint64_t& value,
                           std::string help, std::string name);
/// One of a few words.
[[nodiscard]] Option choice(std::string flag, std::string group, std::string& value,
                            std::vector<std::string> choices, std::string help, std::string name);
[[nodiscard]] Option text(std::string flag, std::string group, std::string& value, std::string help,
                          std::string name);
/// Texts, separated by commas.
[[nodiscard]] Option texts(std::string flag, std::string group, std::vector<std::string>& value,
                           std::string help, std::string name);
/// A file or folder. With a name, outputs hold the file's name without its folder.
[[nodiscard]] Option path(std::string flag, std::string group, std::filesystem::path& value,
                          std::string help, std::string name);
/// On if it is given.
[[nodiscard]] Option flag(std::string flag, std::string group, bool& value, std::string help,
                          std::string name);
/// An argument without a flag, as FILE.
[[nodiscard]] Option argument(std::string word, std::filesystem::path& value, std::string help);
[[nodiscard]] Option argument(std::string word, std::string& value, std::string help);

/// The row, which must be given.
[[nodiscard]] Option required(Option option);
/// The row, whose value decides which others are used, as --planner.
[[nodiscard]] Option chooser(Option option);
/// The row, which is used where one of these is chosen.
/// @throws UsageError that names a typed row that chooses, or hangs on the choice, where `instead`
/// leaves nothing to choose.
void check_unchosen(const OptionTable& typed, const Option& instead);
[[nodiscard]] Option used_by(std::vector<std::string> chosen, Option option);

/// Tables one after the other.
[[nodiscard]] OptionTable joined(std::vector<OptionTable> tables);
/// The rows with these flags, in the order of the table.
[[nodiscard]] OptionTable only(const OptionTable& table, const std::vector<std::string>& flags);

/// The rows without those of these flags.
[[nodiscard]] OptionTable without(const OptionTable& table, const std::vector<std::string>& flags);

/// "--output" of "-o,--output".
[[nodiscard]] std::string long_flag(const Option& option);
/// "longest edge" of "--longest-edge": the name that libraries use in their errors.
[[nodiscard]] std::string field_of(const Option& option);
[[nodiscard]] bool is_argument(const Option& option);
[[nodiscard]] bool is_switch(const Option& option);
[[nodiscard]] bool is_list(const Option& option);

/// Takes what was typed. @throws UsageError that names flag, text and what it must be.
void set(const Option& option, const std::vector<std::string>& typed);
/// @throws UsageError that names flag, value and rule.
void check(const Option& option);
/// The value; empty for an optional one without. Files are named without their folders.
[[nodiscard]] std::optional<OptionValue> value_of(const Option& option);
/// "a, b or c".
[[nodiscard]] std::string either(const std::vector<std::string>& words);
/// @throws UsageError for the first of these rows that nothing chosen uses.
void check_used(const OptionTable& typed, const std::vector<std::string>& chosen);
/// What is chosen by the row that chooses; empty without such a row.
[[nodiscard]] std::vector<std::string> chosen_in(const OptionTable& table);
/// What the help writes in the place of a value: "{hit,footprint}", "FLOAT".
[[nodiscard]] std::string type_name(const Option& option);
/// The value for the help; empty if there is nothing to say.
[[nodiscard]] std::string default_text(const Option& option);

/// Adds the named rows in their order: `in_force` has the same rows as `typed`, and a value where
/// that follows from other options; the names of those are kept apart as derived.
void record(Provenance& provenance, const OptionTable& typed, const OptionTable& in_force);

}  // namespace swathplan
