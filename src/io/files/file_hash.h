#pragma once

#include <filesystem>
#include <string>

namespace swathplan {

/// 'sha1:' and 40 hexadecimal digits: a fingerprint of a file's bytes for provenance.
/// @throws InvalidInput if the file cannot be read.
[[nodiscard]] std::string file_hash(const std::filesystem::path& path);

}  // namespace swathplan
