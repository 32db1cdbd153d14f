#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace swathplan {

/// Lets `write` fill a file under a temporary name beside `path`. Then it renames the file, so that
/// a reader never sees half of it. The temporary file keeps the extension of `path`, because
/// libraries choose the format by it. If `write` throws, the temporary file is removed.
/// @throws InvalidInput if the folder or file cannot be written, or if `path` is a device or a
///   pipe, which a file must not replace; the message names it.
void write_atomically(const std::filesystem::path& path,
                      const std::function<void(const std::filesystem::path&)>& write);

/// Lets `write` fill a file of GDAL's memory, whose name it gets, then writes its bytes in the same
/// way. GDAL's drivers are not to be trusted with a full disk: some crash, some say nothing.
void write_through_memory(const std::filesystem::path& path,
                          const std::function<void(const std::string&)>& write);

/// Writes `text` in the same way.
void write_text_atomically(const std::filesystem::path& path, std::string_view text);

}  // namespace swathplan
