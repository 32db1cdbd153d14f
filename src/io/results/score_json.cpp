#include "io/results/score_json.h"

#include "io/files/atomic_file.h"
#include "io/results/provenance_json.h"
#include "io/results/score_figures.h"

namespace swathplan {

std::string score_json(const std::string& planner, const Score& score,
                       const Provenance& provenance) {
  nlohmann::ordered_json json = provenance_json(provenance);
  json["planner"] = planner;
  json.update(score_figures(score));
  return json_text(json);
}

void write_score_json(const std::filesystem::path& path, const std::string& planner,
                      const Score& score, const Provenance& provenance) {
  write_text_atomically(path, score_json(planner, score, provenance));
}

}  // namespace swathplan
