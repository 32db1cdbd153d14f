#pragma once

#include <string>

namespace swathplan {

/// What the action says when it throws an Error.
template <class Error, class Action>
std::string message_of(Action&& action) {
  try {
    action();
  } catch (const Error& e) {
    return e.what();
  }
  return "nothing was thrown";
}

}  // namespace swathplan
