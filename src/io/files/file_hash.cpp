#include "io/files/file_hash.h"

#include <fmt/format.h>

#include <array>
#include <boost/uuid/detail/sha1.hpp>
#include <fstream>

#include "mesh/base/error.h"

namespace swathplan {

std::string file_hash(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw InvalidInput(fmt::format("cannot read '{}'", path.string()));
  boost::uuids::detail::sha1 sha;
  std::array<char, 1 << 16> buffer;
  while (in.read(buffer.data(), buffer.size()) || in.gcount() > 0) {
    sha.process_bytes(buffer.data(), static_cast<std::size_t>(in.gcount()));
  }
  unsigned int digest[5];
  sha.get_digest(digest);
  return fmt::format("sha1:{:08x}{:08x}{:08x}{:08x}{:08x}", digest[0], digest[1], digest[2],
                     digest[3], digest[4]);
}

}  // namespace swathplan
