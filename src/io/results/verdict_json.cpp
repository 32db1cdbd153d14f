#include "io/results/verdict_json.h"

namespace swathplan {
namespace {

nlohmann::ordered_json rule_json(const JudgedRule& rule, const Frame& frame) {
  nlohmann::ordered_json where = nlohmann::ordered_json::array();
  for (const FailingPlace& place : rule.where) {
    const Vec2 file = frame.to_file(place.position);
    where.push_back({{"x", file.x()}, {"y", file.y()}, {"area_m2", place.area_m2}});
  }
  return {{"name", rule.name},
          {"asks", rule.asks},
          {"figure", rule.figure},
          {"figure_pct", rule.figure_pct},
          {"pass", rule.pass},
          {"failing_m2", rule.failing_m2},
          {"failing_places", rule.failing_places},
          {"where", std::move(where)}};
}

}  // namespace

nlohmann::ordered_json verdict_json(const JudgedSurvey& survey, const Frame& frame) {
  const Verdict& verdict = survey.verdict;
  nlohmann::ordered_json rules = nlohmann::ordered_json::array();
  for (const JudgedRule& rule : verdict.rules) rules.push_back(rule_json(rule, frame));
  const double soundings = static_cast<double>(survey.soundings);
  return {{"criterion", verdict.criterion},
          {"title", verdict.title},
          {"predicted_to_pass", verdict.pass},
          {"verdict", sentence(verdict)},
          {"judged_m2", verdict.judged_m2},
          {"out_of_reach_m2", survey.out_of_reach.total_m2()},
          {"hidden_m2", survey.out_of_reach.hidden_m2},
          {"unsteerable_m2", survey.out_of_reach.unsteerable_m2},
          {"logged_pings", survey.pings},
          {"logged_soundings", survey.soundings},
          {"accepted_soundings_pct",
           survey.soundings > 0 ? 100.0 * static_cast<double>(survey.accepted) / soundings : 0.0},
          {"rules", std::move(rules)},
          {"tvu_share_of_limit", {{"bin", kTvuBin}, {"soundings", survey.tvu_histogram}}}};
}

}  // namespace swathplan
