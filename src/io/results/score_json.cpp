#include "io/results/score_json.h"

#include "io/files/atomic_file.h"
#include "io/results/provenance_json.h"
#include "io/results/score_figures.h"
#include "io/results/verdict_json.h"

namespace swathplan {

std::string score_json(const std::string& planner, const Score& score, const Provenance& provenance,
                       const JudgedIn& judged) {
  nlohmann::ordered_json json = provenance_json(provenance);
  json["planner"] = planner;
  json.update(score_figures(score));
  if (judged.survey != nullptr) json["criterion"] = verdict_json(*judged.survey, *judged.frame);
  return json_text(json);
}

void write_score_json(const std::filesystem::path& path, const std::string& planner,
                      const Score& score, const Provenance& provenance, const JudgedIn& judged) {
  write_text_atomically(path, score_json(planner, score, provenance, judged));
}

}  // namespace swathplan
