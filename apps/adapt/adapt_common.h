#pragma once

#include <tbb/global_control.h>

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "apps/command_line.h"
#include "apps/options.h"
#include "apps/site.h"
#include "io/pictures/adaptive_pictures.h"
#include "io/results/adaptive_study.h"
#include "planners/adaptive/survey_track.h"

namespace swathplan {

/// Where results go, and what they must not depend on.
struct AdaptOutput {
  std::filesystem::path folder = "out";
  bool json = false, quiet = false;
  std::uint64_t seed = 1;
  int threads = 0;
};
[[nodiscard]] OptionTable adapt_output_options(AdaptOutput& output);
/// The command `mode` of a planner; a folder that cannot be written to is said before the work.
[[nodiscard]] Command adapt_mode(const std::string& mode, const std::string& what,
                                 OptionTable options, const AdaptOutput& output,
                                 std::function<void()> run);

/// Where the box lies.
struct BoxOptions {
  std::string start = "sw";
  double azimuth_deg = 0.0;
  std::vector<double> corner;  ///< x, y in file coordinates; empty: the local origin
};
[[nodiscard]] OptionTable box_options(BoxOptions& options);
[[nodiscard]] SurveyBox box_of(const BoxOptions& options, double width_m, double length_m,
                               const Frame& frame);

/// Keeps all work to the threads that were asked for, as long as it lives; 0: all cores.
[[nodiscard]] tbb::global_control thread_limit(const AdaptOutput& output);

/// --no-go of a mission in an abstract world: polygons in the metres of --corner.
[[nodiscard]] Option no_go_option(std::filesystem::path& file);

/// The survey area of the box.
[[nodiscard]] Area box_area(const SurveyBox& box);

/// A finished mission and what is to be said of it.
struct MissionOutput {
  std::string planner, label;
  Route route;
  std::vector<TrackPicture> pictures;
  std::vector<std::pair<std::string, double>> figures;  ///< names carry their units
  std::vector<std::string> notes;
  Provenance provenance;
};
/// A mission with a sonar that sweeps `range_m` to each side from `depth_m` above the bottom;
/// figures, pictures and notes are left to fill in.
[[nodiscard]] MissionOutput mission_output(const SurveyBox& box,
                                           std::span<const SurveyTrack> tracks, double range_m,
                                           double depth_m, Provenance provenance);

/// The no-go polygons of a mission in an abstract world; none without a file. Notes on the file go
/// to the mission's.
/// @throws InvalidInput where none comes within `reach_m` of the box.
[[nodiscard]] Area abstract_no_go(const SiteOptions& choice, const SurveyBox& box, double reach_m,
                                  MissionOutput& mission);
/// Cuts the mission's tracks at no-go areas and leads it round them, through `water` where given,
/// and notes what was done. Where no way leads round, what lies in the areas is marked infeasible.
/// @throws InvalidInput where no track is left.
void keep_out_of(const Area& no_go, const Area& water, MissionOutput& mission);

/// Writes route.csv, route.geojson, score.json, mission.json, tracks.png, report.html and the rest
/// that every survey gets into the folder, and prints the figures.
void write_mission(const AdaptOutput& output, const MissionOutput& mission, const Site& site);

/// Missions in abstract worlds are scored and reported like any other, over a flat bottom around
/// the box, a quarter of the sonar's range deep.
[[nodiscard]] inline double flat_depth_m(double range_m) { return 0.25 * range_m; }
void write_flat_mission(const AdaptOutput& output, const MissionOutput& mission,
                        const SurveyBox& box, double range_m);
/// The same, without a word on stdout, which belongs to the protocol.
void write_live_mission(const AdaptOutput& output, const MissionOutput& mission,
                        const SurveyBox& box, double range_m);

/// What made an adaptive mission: the rows as typed and as they were in force.
[[nodiscard]] Provenance adapt_provenance(const std::string& command, const OptionTable& typed,
                                          const OptionTable& in_force);

/// --missions of a study.
[[nodiscard]] Option missions_option(int& missions, const std::string& what);

/// run_study() into the output's folder, with what a terminal shows of it.
[[nodiscard]] std::vector<std::vector<double>> run_watched(const Study& study,
                                                           const AdaptOutput& output);

}  // namespace swathplan
