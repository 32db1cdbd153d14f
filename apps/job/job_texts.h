#pragma once

#include <string>
#include <vector>

#include "coverage/route/cross_figures.h"
#include "planners/job/whole_job.h"

namespace swathplan {

/// The stems of the files of a job's sorties, such as 'route_boat1_sortie2'; empty where the job is
/// one.
[[nodiscard]] std::vector<std::string> sortie_stems(const JobSummary& job);

/// What is said of a job on the terminal: its sorties, its boats, and each condition of its patch
/// test.
[[nodiscard]] std::string job_table(const JobSummary& job);

/// One sentence each on cross-lines and the parts of the patch test, for the plan's notes.
[[nodiscard]] std::vector<std::string> job_notes(const JobSummary& job, const CrossFigures& cross);

}  // namespace swathplan
