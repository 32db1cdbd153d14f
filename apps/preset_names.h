#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

namespace swathplan {

/// Names of all presets, separated by commas.
template <class Presets>
std::string names(const Presets& presets) {
  std::vector<std::string> list;
  list.reserve(std::size(presets));
  for (const auto& preset : presets) list.push_back(preset.name);
  return fmt::format("{}", fmt::join(list, ", "));
}

}  // namespace swathplan
