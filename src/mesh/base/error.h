#pragma once

#include <stdexcept>
#include <string>

// The library knows the program's options by the names of their fields: 'resolution', 'CRS', 'water
// level'. Where a message tells what to set, the field stands between angle brackets, as in "set
// the <z unit>". The program replaces it by its own word for the option.
namespace swathplan {

/// The data cannot be used as they are (exit code 1). The message is one sentence. It names the
/// file or field and the line or element, and says what is wrong and what to do.
class InvalidInput : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An option that breaks its rule (exit code 2). The message names field, value and rule.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  /// "resolution 0; must be above 0 metres".
  UsageError(const std::string& field, const std::string& value, const std::string& rule)
      : std::runtime_error(field + (value.empty() ? "" : " " + value) + "; " + rule),
        field_(field) {}

  /// The option, as the message begins with it; empty where the message is a free sentence.
  [[nodiscard]] const std::string& field() const { return field_; }

 private:
  std::string field_;
};

}  // namespace swathplan
