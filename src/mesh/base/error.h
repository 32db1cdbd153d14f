#pragma once

#include <stdexcept>
#include <string>

// The program's options are known here as fields: 'resolution', 'CRS', 'water level'. Where a
// sentence tells what to set, the field stands between angle brackets, as in "set the <z unit>";
// the program writes its own word for it there.
namespace swathplan {

/// Data that cannot be used as given (exit code 1). The message is one clear sentence that names
/// the file or field, the line or element, what is wrong and what to do.
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
