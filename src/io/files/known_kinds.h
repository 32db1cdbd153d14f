#pragma once

#include <filesystem>

namespace swathplan {

/// Does nothing for a file that may hold a seafloor. Raw files of sonars, formats of other programs
/// that cannot be read, documents, web pages and the like are told by their first bytes.
/// @throws InvalidInput that says what the file is and what to do.
void refuse_foreign(const std::filesystem::path& path);

}  // namespace swathplan
