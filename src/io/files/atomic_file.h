#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace swathplan {

/// Lets `write` fill a file under a temporary name beside `path`. Then it renames the file, so that
/// a reader never sees half of it. The temporary file keeps the extension of `path`, because
/// libraries choose the format by it. If `write` throws, the temporary file is removed.
/// @throws InvalidInput if the folder or file cannot be written; the message names it.
void write_atomically(const std::filesystem::path& path,
                      const std::function<void(const std::filesystem::path&)>& write);

/// Writes `text` in the same way.
void write_text_atomically(const std::filesystem::path& path, std::string_view text);

}  // namespace swathplan
