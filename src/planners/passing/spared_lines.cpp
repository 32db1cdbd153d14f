#include "planners/passing/spared_lines.h"

#include <algorithm>
#include <numeric>

namespace swathplan {
namespace {

/// Less off an end is not worth a new join, metres.
constexpr double kLeastSparedEndM = 2.0;

/// A line without so many metres of its beginning and its end.
std::vector<Waypoint> shortened(const std::vector<Waypoint>& line, double first_m, double last_m) {
  std::vector<Waypoint> result = line;
  const auto cut = [](std::vector<Waypoint>& points, double metres) {
    while (points.size() > 1 && metres > 0.0) {
      const Vec2 way = points[1].position - points[0].position;
      if (way.norm() > metres) {
        points[0].position += metres / way.norm() * way;
        return;
      }
      metres -= way.norm();
      points.erase(points.begin());
    }
  };
  cut(result, first_m);
  // From behind only positions move: the properties of a waypoint hold from it on.
  double left = last_m;
  while (result.size() > 1 && left > 0.0) {
    const Vec2 way = result[result.size() - 2].position - result.back().position;
    if (way.norm() > left) {
      result.back().position += left / way.norm() * way;
      break;
    }
    left -= way.norm();
    const Vec2 end = result[result.size() - 2].position;
    result.erase(result.end() - 2);
    result.back().position = end;
  }
  return result;
}

}  // namespace

std::optional<SparedStretches> spared(const Route& route, ShownCells& shown, double least_m) {
  std::vector<RouteStretch> all = stretches(route);
  // Logged lines come in the same order in both.
  std::vector<std::size_t> stretch_of;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Waypoint& first = all[k].points.front();
    if (!all[k].join && first.log && first.fan) stretch_of.push_back(k);
  }
  const auto& lines = shown.lines();
  if (stretch_of.size() != lines.size()) return std::nullopt;
  std::vector<std::size_t> order(lines.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return lines[a].length_m > lines[b].length_m;
  });
  SparedStretches result;
  std::vector<std::uint8_t> gone(all.size(), 0);
  std::vector<std::uint8_t> new_join(all.size(), 0);  // beside what changed
  const auto beside_join = [&](std::size_t k, bool first) {
    if (first) return k == 0 || all[k - 1].join;
    return k + 1 == all.size() || all[k + 1].join;
  };
  for (const std::size_t line : order) {
    if (!shown.spare(line)) continue;
    const std::size_t k = stretch_of[line];
    gone[k] = 1;
    ++result.lines;
    if (k > 0 && all[k - 1].join) new_join[k - 1] = 1;
    if (k + 1 < all.size() && all[k + 1].join) new_join[k + 1] = 1;
  }
  for (const std::size_t line : order) {
    const std::size_t k = stretch_of[line];
    if (gone[k] != 0) continue;
    double off[2] = {0.0, 0.0};
    for (const bool first : {true, false}) {
      if (!beside_join(k, first)) continue;
      const double most = lines[line].length_m - off[0] - least_m;
      if (most < kLeastSparedEndM) continue;
      off[first ? 0 : 1] = shown.spare_end(line, first, most);
    }
    for (double& metres : off) metres = metres < kLeastSparedEndM ? 0.0 : metres;
    if (off[0] + off[1] <= 0.0) continue;
    result.ends_m += off[0] + off[1];
    all[k].points = shortened(all[k].points, off[0], off[1]);
    if (off[0] > 0.0 && k > 0) new_join[k - 1] = 1;
    if (off[1] > 0.0 && k + 1 < all.size()) new_join[k + 1] = 1;
  }
  if (result.lines == 0 && result.ends_m <= 0.0) return std::nullopt;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (gone[k] == 0 && !(all[k].join && new_join[k] != 0)) {
      result.stretches.push_back(std::move(all[k]));
    }
  }
  return result;
}

}  // namespace swathplan
