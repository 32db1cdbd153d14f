#pragma once

#include <filesystem>
#include <string>

#include "io/results/plan_record.h"
#include "io/results/provenance.h"
#include "mesh/base/frame.h"

namespace swathplan {

/// Provenance and record; coordinates are those of the input file.
[[nodiscard]] std::string plan_json(const PlanRecord& record, const Frame& frame,
                                    const Provenance& provenance);

/// Writes it to a file.
/// @throws InvalidInput if the file cannot be written.
void write_plan_json(const std::filesystem::path& path, const PlanRecord& record,
                     const Frame& frame, const Provenance& provenance);

}  // namespace swathplan
