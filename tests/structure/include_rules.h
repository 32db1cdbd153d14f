#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace swathplan::test {

/// The rooms of the source tree ('planners/steering') and the rooms that each may include.
using Arrows = std::map<std::string, std::set<std::string>>;

/// An include of one of our own headers or of a foreign one.
struct Include {
  std::string file;    ///< that includes, from the root of the tree: 'src/mesh/seafloor.cpp'
  int line = 0;        ///< from 1
  std::string header;  ///< as written between the quotes or brackets
  bool own = false;    ///< in quotes
};

/// Arrows from lines 'room: room room', as CMake writes them. @throws std::runtime_error.
[[nodiscard]] Arrows read_arrows(const std::string& file);

/// All includes of a file. @throws std::runtime_error if it cannot be read.
[[nodiscard]] std::vector<Include> read_includes(const std::string& root, const std::string& file);

/// The room that a file or a header belongs to: 'src/mesh/plane/box.h', 'mesh/plane/box.h' and
/// 'tests/mesh/plane/box_test.cpp' are all in 'mesh/plane'.
[[nodiscard]] std::string room_of(const std::string& file);

/// What is wrong with an include, one sentence; empty if nothing is: an arrow that was not
/// declared, another room's `_internal.h`, a foreign header in a public one.
[[nodiscard]] std::string fault(const Include& include, const Arrows& arrows);

/// Rooms that can be reached from themselves, and arrows that point against
/// mesh <- coverage <- planners <- io <- apps or join the adaptive planners with the offline ones.
[[nodiscard]] std::vector<std::string> faults(const Arrows& arrows);

}  // namespace swathplan::test
