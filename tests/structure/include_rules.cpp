#include "structure/include_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <functional>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace swathplan::test {
namespace {

std::ifstream opened(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot read " + file);
  return in;
}

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// Headers that are slow to parse or not ours to pass on stay in .cpp files and _internal.h.
bool stays_in_the_cellar(const std::string& header) {
  static const std::regex foreign(
      "(CGAL|boost|embree3|assimp|opencv2|polyclipping)/"
      ".*|(gdal|ogr|cpl_).*|clipper\\.hpp|Ip[A-Z].*");
  return std::regex_match(header, foreign);
}

int level(const std::string& room) {
  static const std::array<std::string, 5> modules{"mesh", "coverage", "planners", "io", "apps"};
  const std::string module = room.substr(0, room.find('/'));
  const auto at = std::find(modules.begin(), modules.end(), module);
  if (at == modules.end()) throw std::runtime_error("no module: " + room);
  return static_cast<int>(at - modules.begin());
}

bool is_planner_room(const std::string& room) { return level(room) == 2; }

/// The room itself if arrows lead back to it.
bool on_a_circle(const std::string& room, const Arrows& arrows) {
  std::set<std::string> seen;
  const std::function<bool(const std::string&)> leads_back = [&](const std::string& from) {
    const auto uses = arrows.find(from);
    if (uses == arrows.end()) return false;
    return std::any_of(uses->second.begin(), uses->second.end(), [&](const std::string& to) {
      return to == room || (seen.insert(to).second && leads_back(to));
    });
  };
  return leads_back(room);
}

}  // namespace

Arrows read_arrows(const std::string& file) {
  std::ifstream in = opened(file);
  Arrows arrows;
  for (std::string line; std::getline(in, line);) {
    const std::size_t colon = line.find(':');
    if (colon == std::string::npos) continue;
    std::istringstream words(line.substr(colon + 1));
    std::set<std::string>& uses = arrows[line.substr(0, colon)];
    for (std::string word; words >> word;) uses.insert(word);
  }
  return arrows;
}

std::vector<Include> read_includes(const std::string& root, const std::string& file) {
  static const std::regex include("\\s*#\\s*include\\s*([<\"])([^>\"]+)[>\"].*");
  std::ifstream in = opened(root + "/" + file);
  std::vector<Include> found;
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    std::smatch parts;
    if (!std::regex_match(line, parts, include)) continue;
    found.push_back({file, number, parts[2], parts[1] == "\""});
  }
  return found;
}

std::string room_of(const std::string& file) {
  std::string path = file;
  for (const std::string top : {"src/", "tests/"}) {
    if (path.rfind(top, 0) == 0) path.erase(0, top.size());
  }
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? std::string() : path.substr(0, slash);
}

std::string fault(const Include& include, const Arrows& arrows) {
  const std::string from = room_of(include.file);
  const std::string where = fmt::format("{}:{}", include.file, include.line);
  if (!include.own) {
    const bool is_public = include.file.rfind("src/", 0) == 0 && ends_with(include.file, ".h") &&
                           !ends_with(include.file, "_internal.h");
    if (!is_public || !stays_in_the_cellar(include.header)) return {};
    return fmt::format("{}: <{}> belongs into .cpp files and _internal.h only", where,
                       include.header);
  }
  const std::string to = room_of(include.header);
  if (to == from) return {};
  if (ends_with(include.header, "_internal.h")) {
    return fmt::format("{}: {} is internal to {}", where, include.header, to);
  }
  const bool is_test = include.file.rfind("tests/", 0) == 0;
  if (is_test) return {};  // a test may build its case with whatever is public
  const auto uses = arrows.find(from);
  if (uses == arrows.end()) return fmt::format("{}: no room '{}' was declared", where, from);
  if (uses->second.count(to) != 0) return {};
  return fmt::format("{}: {} may not use {}; declare the arrow if it is meant", where, from, to);
}

std::vector<std::string> faults(const Arrows& arrows) {
  std::vector<std::string> found;
  for (const auto& [room, uses] : arrows) {
    if (on_a_circle(room, arrows)) found.push_back(room + " lies on a circle of arrows");
    for (const std::string& used : uses) {
      if (level(used) > level(room)) {
        found.push_back(fmt::format("{} -> {} points against the modules' order", room, used));
      }
      const bool one_is_adaptive = (room == "planners/adaptive") != (used == "planners/adaptive");
      if (is_planner_room(room) && is_planner_room(used) && one_is_adaptive) {
        found.push_back(fmt::format("{} -> {} joins adaptive and offline planners", room, used));
      }
    }
  }
  return found;
}

}  // namespace swathplan::test
