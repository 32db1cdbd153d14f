#include "io/exports/survey_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>

namespace swathplan {
namespace {

bool surveys(const Waypoint& w) { return is_survey(w.kind); }

int largest_number(const Route& route) {
  int largest = 0;
  for (const Waypoint& w : route.waypoints) largest = std::max(largest, w.line.value_or(0));
  return largest;
}

/// What is put before the number of a line that is none of the main scheme.
std::string_view mark_of(LegKind kind) {
  if (kind == LegKind::cross) return "X";
  return kind == LegKind::patch ? "P" : "";
}

std::string_view words_of(LegKind kind) {
  if (kind == LegKind::cross) return "cross-line";
  return kind == LegKind::patch ? "patch line" : "line";
}

}  // namespace

std::vector<SurveyRun> survey_runs(const Route& route) {
  const auto& w = route.waypoints;
  std::vector<SurveyRun> runs;
  std::map<int, int> stretches;
  int unnumbered = largest_number(route);
  for (std::size_t first = 0; first + 1 < w.size();) {
    std::size_t last = first + 1;
    while (last + 1 < w.size() && w[last].kind == w[first].kind && w[last].line == w[first].line) {
      ++last;
    }
    if (surveys(w[first])) {
      const int number = w[first].line ? *w[first].line : ++unnumbered;
      const int stretch = ++stretches[number];
      runs.push_back({first, last,
                      fmt::format("{}{}{}", mark_of(w[first].kind), number,
                                  stretch == 1 ? "" : fmt::format("_{}", stretch))});
    }
    first = last;
  }
  return runs;
}

std::vector<std::string> waypoint_names(const Route& route) {
  std::vector<std::string> names(route.waypoints.size());
  const auto add = [&](std::size_t i, const std::string& name) {
    names[i] += (names[i].empty() ? "" : ", ") + name;
  };
  for (const SurveyRun& run : survey_runs(route)) {
    const std::string_view words = words_of(route.waypoints[run.first].kind);
    add(run.first, fmt::format("{} {} start", words, run.name));
    add(run.last, fmt::format("{} {} end", words, run.name));
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i].empty()) names[i] = std::to_string(i + 1);
  }
  return names;
}

std::vector<std::string> short_waypoint_names(const Route& route) {
  constexpr std::size_t kMost = 6;
  std::vector<std::string> names(route.waypoints.size());
  const auto add = [&](std::size_t i, const std::string& name) {
    if (names[i].size() + name.size() <= kMost) names[i] += name;
  };
  for (const SurveyRun& run : survey_runs(route)) {
    add(run.first, "S" + run.name);
    add(run.last, "E" + run.name);
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i].empty()) names[i] = std::to_string(i + 1);
  }
  return names;
}

}  // namespace swathplan
