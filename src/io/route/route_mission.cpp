#include "io/route/route_mission.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "io/files/text.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

using MissionJson = nlohmann::json;

// MAV_CMD of MAVLink's common message set.
constexpr int kChangeSpeed = 178;
constexpr int kJump = 177;

/// Commands to sail to a place: waypoint, loiter (3 ways), land, take-off, loiter to altitude,
/// spline.
constexpr std::array kPlaces = {16, 17, 18, 19, 21, 22, 31, 82};
/// MAV_FRAME whose places are latitude and longitude, and that of commands without a place.
constexpr std::array kInDegrees = {0, 2, 3, 5, 6, 10, 11};

bool holds(const auto& list, int value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

struct FoundItem {
  std::string label;  ///< for messages
  int frame = 0, command = 0;
  double speed = 0.0;  ///< second parameter
  std::optional<Vec2> lonlat;
};

/// Makes a route of the items of a mission, one after the other.
class MissionReader {
 public:
  explicit MissionReader(std::string file) : file_(std::move(file)) { route_.parts.emplace_back(); }

  void add(const FoundItem& item) {
    if (item.command == kJump) {
      fail(item.label, "jumps back to another item: write out the loop, or leave it out");
    }
    if (item.command == kChangeSpeed) {
      // -1 keeps the speed, -2 asks for the vehicle's own.
      speed_ = item.speed > 0.0 ? std::optional(item.speed)
                                : (item.speed == -1.0 ? speed_ : std::nullopt);
      if (!points().empty()) points().back().speed_mps = speed_;
      return;
    }
    if (!holds(kPlaces, item.command)) {
      ++others_[item.command];
      return;
    }
    if (!holds(kInDegrees, item.frame)) {
      fail(item.label, fmt::format("is in frame {}, whose places are no latitude and longitude: "
                                   "save the mission with global coordinates",
                                   item.frame));
    }
    if (!item.lonlat) fail(item.label, "has no latitude and longitude");
    if (item.lonlat->isZero(0.0)) {
      ++nowhere_;
      return;
    }
    points().push_back({.place = *item.lonlat, .line = std::nullopt, .speed_mps = speed_});
  }

  [[noreturn]] void fail(const std::string& label, const std::string& what) const {
    throw InvalidInput(fmt::format("'{}', {}: {}", file_, label, what));
  }

  [[nodiscard]] ForeignRoute done() && {
    std::string commands;
    for (const auto& [command, count] : others_) {
      commands += fmt::format("{}{} ({}x)", commands.empty() ? "" : ", ", command, count);
    }
    if (!commands.empty()) {
      route_.notes.push_back("commands other than waypoints and speeds were left out: " + commands);
    }
    if (nowhere_ > 0) {
      route_.notes.push_back(fmt::format(
          "{} item{} at latitude 0, longitude 0, which means where the vehicle is, {} left out",
          nowhere_, nowhere_ == 1 ? "" : "s", nowhere_ == 1 ? "was" : "were"));
    }
    return std::move(route_);
  }

 private:
  std::vector<ForeignPoint>& points() { return route_.parts.back(); }

  std::string file_;
  ForeignRoute route_;
  std::optional<double> speed_;
  std::map<int, int> others_;
  int nowhere_ = 0;
};

FoundItem row_item(const std::string& label, const std::vector<std::string_view>& fields,
                   const MissionReader& reader) {
  constexpr std::size_t kColumns = 12;
  if (fields.size() != kColumns) {
    reader.fail(label, fmt::format("has {} columns where a mission has {}; is the file truncated?",
                                   fields.size(), kColumns));
  }
  std::array<double, kColumns> numbers{};
  for (std::size_t i = 0; i < kColumns; ++i) {
    const auto value = to_finite_number(fields[i]);
    if (!value) {
      reader.fail(label, fmt::format("column {} '{}' is no number", i + 1, quotable(fields[i])));
    }
    numbers[i] = *value;
  }
  const auto frame = whole_number(fields[2]);
  const auto command = whole_number(fields[3]);
  if (!frame || !command) reader.fail(label, "its frame and command must be whole numbers");
  return {.label = label,
          .frame = *frame,
          .command = *command,
          .speed = numbers[5],
          .lonlat = Vec2(numbers[9], numbers[8])};
}

/// Reads the items of a .plan.
class PlanReader {
 public:
  explicit PlanReader(const std::string& file) : reader_(file) {}

  void add(const MissionJson& items, const std::string& label, int depth) {
    if (!items.is_array()) reader_.fail(label, "has no list of items");
    for (std::size_t i = 0; i < items.size(); ++i) {
      const std::string name = fmt::format("{}item {}", label.empty() ? "" : label + ", ", i + 1);
      const MissionJson& item = items[i];
      if (!item.is_object()) reader_.fail(name, "is no object");
      if (text(item, "type") == "ComplexItem") {
        add_complex(item, name, depth);
      } else {
        reader_.add(simple(item, name));
      }
    }
  }

  [[nodiscard]] ForeignRoute done() && { return std::move(reader_).done(); }

 private:
  static std::string text(const MissionJson& node, const char* member) {
    const auto at = node.find(member);
    return at != node.end() && at->is_string() ? at->get<std::string>() : std::string();
  }

  static int number(const MissionJson& node, const char* member, int otherwise) {
    const auto at = node.find(member);
    if (at == node.end() || !at->is_number()) return otherwise;
    const double value = at->get<double>();
    return std::abs(value) < 1e9 ? static_cast<int>(value) : otherwise;
  }

  /// Parameters may be null: not given.
  static double parameter(const MissionJson& list, std::size_t i) {
    return i < list.size() && list[i].is_number() ? list[i].get<double>() : 0.0;
  }

  FoundItem simple(const MissionJson& item, const std::string& label) const {
    FoundItem found{.label = label,
                    .frame = number(item, "frame", 0),
                    .command = number(item, "command", -1),
                    .lonlat = std::nullopt};
    if (found.command < 0) reader_.fail(label, "has no command");
    const auto list = item.find("params");
    if (list != item.end() && list->is_array()) {
      found.speed = parameter(*list, 1);
      found.lonlat = Vec2(parameter(*list, 5), parameter(*list, 4));
    }
    // Older plans keep the place apart.
    const auto place = item.find("coordinate");
    if (place != item.end() && place->is_array()) {
      found.lonlat = Vec2(parameter(*place, 1), parameter(*place, 0));
    }
    return found;
  }

  void add_complex(const MissionJson& item, const std::string& label, int depth) {
    constexpr int kMostDepth = 4;
    const std::string kind = text(item, "complexItemType");
    for (const char* member : {"TransectStyleComplexItem", "Items"}) {
      const auto inner = item.find(member);
      if (inner == item.end()) continue;
      const MissionJson& list =
          inner->is_object() && inner->contains("Items") ? (*inner)["Items"] : *inner;
      if (depth < kMostDepth && list.is_array() && !list.empty()) {
        add(list, fmt::format("{} ({})", label, quotable(kind)), depth + 1);
        return;
      }
    }
    reader_.fail(label, fmt::format("'{}' holds an area but none of its lines: save the plan again "
                                    "in QGroundControl, or export its lines",
                                    quotable(kind)));
  }

  MissionReader reader_;
};

}  // namespace

ForeignRoute parse_mission_waypoints(std::string_view text, const std::string& file) {
  MissionReader reader(file);
  const auto lines = split(text, '\n');
  if (const auto version = split(lines.front(), ' '); version.size() < 3 || version[2] != "110") {
    reader.fail("line 1", fmt::format("'{}' is another version than 'QGC WPL 110'; save the "
                                      "mission anew",
                                      quotable(lines.front())));
  }
  bool home = true;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const auto fields = split(lines[i], ' ');
    if (fields.empty() || fields[0].starts_with('#')) continue;
    const FoundItem item = row_item(fmt::format("line {}", i + 1), fields, reader);
    if (!home) reader.add(item);
    home = false;
  }
  ForeignRoute route = std::move(reader).done();
  if (route.parts.front().size() == 1) {
    throw InvalidInput(fmt::format(
        "'{}' holds one waypoint beside home (its first row, where the vehicle is armed): a route "
        "needs at least two",
        file));
  }
  return route;
}

ForeignRoute parse_mission_plan(std::string_view text, const std::string& file) {
  MissionJson document;
  try {
    document = MissionJson::parse(text);
  } catch (const MissionJson::parse_error& error) {
    throw InvalidInput(
        fmt::format("'{}' is not complete JSON: byte {} cannot be read; is the file truncated?",
                    file, error.byte));
  }
  const auto mission = document.find("mission");
  if (mission == document.end() || !mission->is_object() || !mission->contains("items")) {
    throw InvalidInput(fmt::format("'{}' is a plan without mission items", file));
  }
  PlanReader reader(file);
  reader.add((*mission)["items"], "", 0);
  return std::move(reader).done();
}

}  // namespace swathplan
