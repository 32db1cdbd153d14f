#include "io/files/layer_choice.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/files/text.h"
#include "mesh/base/error.h"

namespace swathplan {

std::optional<std::size_t> chosen_layer(std::string_view wanted,
                                        const std::vector<std::string>& have) {
  for (const std::string_view name : split(wanted, ',')) {
    if (trim(name).empty()) continue;
    for (std::size_t i = 0; i < have.size(); ++i) {
      if (lower(trim(name)) == lower(have[i])) return i;
    }
  }
  return {};
}

void refuse_layers(const std::filesystem::path& path, const std::vector<std::string>& have) {
  constexpr std::size_t kMostNames = 20;
  std::vector<std::string> names;
  for (const std::string& name : have) {
    if (names.size() < kMostNames) names.push_back(quotable(name));
  }
  throw InvalidInput(fmt::format("'{}' holds {} layers ({}{}); choose one with <layer>",
                                 path.string(), have.size(), fmt::join(names, ", "),
                                 have.size() > kMostNames ? ", ..." : ""));
}

}  // namespace swathplan
