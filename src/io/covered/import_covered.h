#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "coverage/covered/covered_before.h"
#include "coverage/route/vehicle.h"

namespace swathplan {

/// How files of earlier surveys are read, and what sails their tracks anew.
struct CoveredOptions {
  Ground whole;  ///< the whole survey area, with its scene
  Sonar sonar;
  Vehicle vehicle;
  ScoreOptions scoring;
  bool logged_only = true;              ///< of tracks with angles only logged legs count
  std::optional<double> track_swath_m;  ///< what tracks without angles cover, across
  std::optional<FanAngles> track_fan;   ///< or the fan that they were sailed with
  std::vector<std::string> layers;      ///< of the files; empty: the only one
};

/// Adds what a file says was surveyed to `before`, and a note of how it was read and what it
/// covers:
/// - a raster whose values are numbers of soundings (a band called so, or whole numbers without a
///   sign): its cells with as many as are wanted; with two values, 0 and another: the others;
/// - any other raster: its cells with a value;
/// - soundings, meshes, point clouds: the ground between points, as import_seafloor joins them;
/// - polygons: their area;
/// - tracks with angles: what the simulator sounds along them; without: a strip, or a fan's.
/// A file without a CRS is in the coordinates of the seafloor's file.
/// @throws InvalidInput if the file cannot be read, meets no cell of the survey area, or is a track
///   without angles and neither `track_swath_m` nor `track_fan` is given.
void add_covered(const std::filesystem::path& path, const Frame& frame,
                 const CoveredOptions& options, CoveredBefore& before,
                 std::vector<std::string>& notes);

}  // namespace swathplan
