#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/charts/hazard_choice.h"
#include "mesh/plane/polygons.h"

namespace swathplan {

/// One thing to keep off.
struct Hazard {
  std::string layer;          ///< 'WRECKS'
  std::string name;           ///< what the file calls it; may be empty
  double accuracy_m = 0.0;    ///< of its place
  std::string accuracy_from;  ///< 'POSACC', 'QUAPOS 4', 'CATZOC B', 'scale 1:80000'; 'typed'
  double buffer_m = 0.0;      ///< room around it, metres
  bool to_be_seen = false;    ///< not sailed over, but its cells count in the coverage
  Area area;                  ///< with its room, local metres
};

/// How many of a layer there are, and how many come near the survey.
struct HazardCount {
  std::string layer;
  std::size_t found = 0, near = 0, without_place = 0;
  double least_buffer_m = 0.0, most_buffer_m = 0.0;  ///< of those near
  bool to_be_seen = false;
};

struct Hazards {
  std::vector<Hazard> list;  ///< those near, in the order of the file
  std::vector<HazardCount> counts;
  std::vector<std::string> notes, warnings;  ///< one sentence each
};

/// Reads what is to be kept off from a file. Of a chart these are its classes of hazards, each
/// with a buffer that grows with the stated accuracy of its place (hazard_buffers.h), as far as
/// `choices`, all for this file, do not say otherwise. Of other vector files these are the chosen
/// layers, or all, and the choice must name the buffer. Only what comes within its buffer of `near`
/// (local metres) is kept. Restricted areas that forbid neither entry nor passage are left out.
/// @throws InvalidInput if the file cannot be read, a chosen layer does not exist or holds no
///   place, or the frame has no CRS; UsageError for a buffer that is needed and not given.
[[nodiscard]] Hazards read_hazards(const std::filesystem::path& file,
                                   const std::vector<HazardChoice>& choices, const Frame& frame,
                                   const Box2& near);

/// Adds those of another file.
void append(Hazards& hazards, Hazards more);

/// All areas of the hazards that are to be seen, or of the others, united.
[[nodiscard]] Area united_area(const Hazards& hazards, bool to_be_seen);

}  // namespace swathplan
