#pragma once

#include <nlohmann/json.hpp>

#include "io/results/provenance.h"

namespace swathplan {

/// The members that every JSON output begins with: program, version, command, input, seed, options.
[[nodiscard]] nlohmann::ordered_json provenance_json(const Provenance& provenance);

/// The text of a JSON output: two spaces of indent and a newline at the end. Bytes that are not
/// UTF-8 (a file name may hold them) are replaced.
[[nodiscard]] std::string json_text(const nlohmann::ordered_json& json);

}  // namespace swathplan
