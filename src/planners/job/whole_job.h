#pragma once

#include <optional>
#include <string>
#include <vector>

#include "planners/job/boats_apart.h"
#include "planners/job/cross_lines.h"
#include "planners/job/patch_test.h"
#include "planners/plan.h"

namespace swathplan {

/// Hours of the day in which boats are out.
struct Daylight {
  double from_h = 0.0, to_h = 24.0;  ///< 0 <= from_h < to_h <= 24
};

/// What belongs to a job beside its main scheme.
struct JobOptions {
  /// Where the boats lie, in safe water. Empty: they begin where the first line does, if there are
  /// sorties or several boats; else there is no way out or home.
  std::optional<Vec2> berth = std::nullopt;
  double cross_share = 0.0;  ///< length of cross-lines / length of the main scheme; 0: none
  bool patch_test = false;
  std::optional<double> longest_sortie_s =
      std::nullopt;  ///< contingency included; empty: the job is one sortie
  std::optional<Daylight> daylight = std::nullopt;  ///< sorties lie within it, day after day
  int boats = 1;                                    ///< >= 1
};

/// A sortie of one boat.
struct JobSortie {
  int boat = 1, number = 1;  ///< from 1
  double begins_s = 0.0;     ///< after the job begins; with daylight, after midnight of its day 1
  double duration_s = 0.0, with_contingency_s = 0.0;
  double length_m = 0.0, logged_m = 0.0;
  std::vector<int> lines;  ///< numbers, in sailing order
};

/// What is told of a job.
struct JobSummary {
  std::optional<Vec2> berth;
  std::vector<JobSortie> sorties;  ///< boat by boat; one where the job is not divided
  int boats = 1;
  double undivided_s = 0.0;  ///< one boat, one sortie
  double sailed_s = 0.0;     ///< all sorties
  double makespan_s = 0.0;   ///< of the boat that sails longest, its waits at the start included
  BoatsApart apart;          ///< of several boats
  std::optional<double> longest_sortie_s;
  bool by_daylight = false;
  std::optional<CrossLines> cross;  ///< of those laid here; its lines are left empty
  double cross_share_asked = 0.0;
  std::vector<PatchTest> patch_tests;
  [[nodiscard]] bool divided() const { return sorties.size() > 1; }
};

/// The whole job: its sorties and, one after the other, their route.
struct Job {
  Route route;
  std::vector<Route> routes;  ///< of the sorties
  JobSummary summary;
  std::vector<std::string> notes;  ///< one sentence each, for people
};

/// Makes a whole job of the lines of a main scheme. Lines stay as they are; joins that still fit
/// stay, others are found through the water. Patch-test lines come first, then cross-lines, then
/// the main scheme, in its own order or in a better one from the berth and back. The job is cut
/// into parts for the boats, of about the same time, and these into sorties that keep to their
/// hours. Boats on lines of the main scheme keep a swath apart at all times, and off neighbouring
/// lines where they can: by the order of their lines, and else by beginning later.
/// @throws UsageError for options out of their range, if no way leads from the berth to any line,
///   or if sorties are too short; InvalidInput if the route holds no line.
[[nodiscard]] Job whole_job(const Route& main, const Ground& ground, const PlanOptions& options,
                            const JobOptions& how);

/// @throws UsageError that names the option, its value and the rule.
void check(const JobOptions& how);

inline constexpr int kMostBoats = 8;

}  // namespace swathplan
