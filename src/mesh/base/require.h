#pragma once

#include <fmt/format.h>

#include <cmath>

#include "mesh/base/error.h"

// Checks the rules of options. The message names the option, its value and the rule.
namespace swathplan {

/// @throws UsageError 'name value; must be rule' unless it holds.
inline void require(bool holds, const char* name, double value, const char* rule) {
  if (!holds) throw UsageError(name, fmt::format("{}", value), fmt::format("must be {}", rule));
}

/// @throws UsageError unless `value` is a finite number above 0.
inline void require_positive(const char* name, double value) {
  require(value > 0.0 && std::isfinite(value), name, value, "a finite number above 0");
}

}  // namespace swathplan
