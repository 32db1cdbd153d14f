#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "apps/options.h"
#include "apps/site.h"
#include "io/adaptive_pictures.h"
#include "planners/survey_track.h"

namespace swathplan {

/// Where results go, and what they must not depend on.
struct AdaptOutput {
  std::filesystem::path folder = "out";
  bool json = false, quiet = false;
  std::uint64_t seed = 1;
  int threads = 0;
};
void add_adapt_output(CLI::App& command, AdaptOutput& output);

/// Where the box lies.
struct BoxOptions {
  std::string start = "sw";
  double azimuth_deg = 0.0;
  std::vector<double> corner;  ///< x, y in file coordinates; empty: the local origin
};
void add_box_options(CLI::App& command, BoxOptions& options);
[[nodiscard]] SurveyBox box_of(const BoxOptions& options, double width_m, double length_m,
                               const Frame& frame);

/// A flat seafloor around a box for missions in abstract worlds, so that their routes are scored
/// and reported like any other. `margin_m` of it lies around the box.
[[nodiscard]] std::unique_ptr<Site> flat_site(const SurveyBox& box, double margin_m,
                                              double depth_m);
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
/// Writes route.csv, route.geojson, score.json, mission.json, tracks.png, report.html and the rest
/// that every survey gets into the folder, and prints the figures.
void write_mission(const AdaptOutput& output, const MissionOutput& mission, const Site& site);

/// What made an adaptive mission.
[[nodiscard]] Provenance adapt_provenance(const std::string& command, std::uint64_t seed,
                                          std::vector<std::pair<std::string, OptionValue>> options);

/// Half-angles that sweep `range_m` to each side at `depth_m` below the sonar.
[[nodiscard]] FanAngles side_fan(double range_m, double depth_m);

/// Progress of a study on stderr, where that is a terminal.
[[nodiscard]] std::function<void(double)> study_progress(const std::string& label, bool quiet);

}  // namespace swathplan
