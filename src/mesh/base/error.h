#pragma once

#include <stdexcept>

namespace swathplan {

/// Data that cannot be used as given (exit code 1). The message is one clear sentence that names
/// the file or field, the line or element, what is wrong and what to do.
class InvalidInput : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An option that breaks its rule (exit code 2). The message names option, value and rule.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace swathplan
