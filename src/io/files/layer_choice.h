#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace swathplan {

/// The first of `have` that is one of the names in `wanted` (separated by commas, large and small
/// letters alike); empty if there is none. One list of names serves several files, so a name that
/// a file does not hold is no error.
[[nodiscard]] std::optional<std::size_t> chosen_layer(std::string_view wanted,
                                                      const std::vector<std::string>& have);

/// @throws InvalidInput that lists the layers and says how to choose one.
[[noreturn]] void refuse_layers(const std::filesystem::path& path,
                                const std::vector<std::string>& have);

}  // namespace swathplan
