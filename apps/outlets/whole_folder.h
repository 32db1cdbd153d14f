#pragma once

#include <filesystem>
#include <functional>

namespace swathplan {

/// Writes several files into a folder, all or none. `write` fills a folder of its own below
/// `folder`. When it has done so, its files move to `folder` under the same names and take the
/// place of older ones. If it throws, nothing of `folder` has changed.
/// @throws what `write` throws; an InvalidInput names files as they were to be called in `folder`,
///   and says that none was written.
void write_all_or_none(const std::filesystem::path& folder,
                       const std::function<void(const std::filesystem::path&)>& write);

}  // namespace swathplan
