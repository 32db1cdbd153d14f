#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace swathplan {

/// Lets `write` fill a file under a temporary name beside `path`, then renames it, so that a
/// reader never sees half a file. The temporary file is removed when `write` throws; it keeps the
/// extension of `path`, by which libraries choose the format.
/// @throws InvalidInput if the folder or file cannot be written; the message names it.
void write_atomically(const std::filesystem::path& path,
                      const std::function<void(const std::filesystem::path&)>& write);

/// The same for text that is already there.
void write_text_atomically(const std::filesystem::path& path, std::string_view text);

}  // namespace swathplan
