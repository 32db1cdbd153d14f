#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "planners/job/whole_job.h"

namespace swathplan {

/// What plan.json says of a job; places in file coordinates. `files`: the routes of its sorties,
/// empty where the job is one.
[[nodiscard]] nlohmann::ordered_json job_json(const JobSummary& job,
                                              const std::vector<std::string>& files,
                                              const Frame& frame);

}  // namespace swathplan
