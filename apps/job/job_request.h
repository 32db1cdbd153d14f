#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/options.h"
#include "apps/site.h"
#include "planners/job/beside_lines.h"
#include "planners/job/whole_job.h"

namespace swathplan {

/// What was asked for beside a main scheme, resolved from what was typed.
struct JobRequest {
  JobOptions job;                ///< without its berth, which the seafloor's frame places
  std::optional<Vec2> berth_xy;  ///< in the coordinates of the seafloor's file
  std::string berth_text;        ///< the same as it was typed
  std::optional<Vec2> beside_xy;
  BesideOptions beside;
  std::vector<std::string> notes;
  /// True where there is more to do than to sail the main scheme.
  [[nodiscard]] bool any() const;
};

/// `spacing_m`: between lines, for those beside others.
/// @throws UsageError that names flag, value and rule.
[[nodiscard]] JobRequest job_request(const JobChoice& typed, const std::optional<double>& spacing_m,
                                     const Vehicle& vehicle);

/// The berth in the frame of the site, in safe water; empty where none was asked for. Adds a note
/// where it is moved there.
/// @throws UsageError for a berth on land, beyond the data, in shoal water or in a no-go area.
[[nodiscard]] std::optional<Vec2> berth_in(const Site& site, const JobRequest& request,
                                           const Vehicle& vehicle, std::vector<std::string>& notes);

/// What lines are to run beside. @throws InvalidInput as import_shapes does.
[[nodiscard]] GivenShapes shapes_beside(const Site& site, const JobChoice& typed,
                                        const JobRequest& request);

}  // namespace swathplan
