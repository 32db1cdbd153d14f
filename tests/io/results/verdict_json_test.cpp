#include "io/results/verdict_json.h"

#include <gmock/gmock.h>

#include "io/results/score_json.h"
#include "io/sample_judged.h"
#include "io/sample_plan.h"

namespace swathplan {
namespace {

TEST(VerdictJson, SaysWhatFailsAndWhereInTheCoordinatesOfTheFile) {
  Frame frame;
  frame.origin = {500000.0, 6000000.0};
  const nlohmann::ordered_json written = verdict_json(test::judged_survey(), frame);
  EXPECT_EQ(written["criterion"], "s44-special");
  EXPECT_EQ(written["predicted_to_pass"], false);
  EXPECT_EQ(written["verdict"],
            "predicted to fail IHO S-44 Special Order: coverage (97.50 % of cells, 2 gaps; asked: "
            "100 % coverage and feature search)");
  EXPECT_EQ(written["accepted_soundings_pct"], 75.0);
  EXPECT_EQ(written["out_of_reach_m2"], 4.5);
  EXPECT_EQ(written["hidden_m2"], 3.0);
  EXPECT_EQ(written["unsteerable_m2"], 1.5);
  ASSERT_EQ(written["rules"].size(), 2U);
  EXPECT_EQ(written["rules"][0]["pass"], false);
  EXPECT_EQ(written["rules"][0]["figure_pct"], 97.5);
  EXPECT_EQ(written["rules"][0]["where"][0]["x"], 500010.0);
  EXPECT_EQ(written["rules"][0]["where"][0]["y"], 6000020.0);
  EXPECT_EQ(written["rules"][0]["where"][1]["area_m2"], 1.0);
  EXPECT_EQ(written["tvu_share_of_limit"]["soundings"][12], 10);
}

TEST(VerdictJson, StandsInTheScoreOfASurveyThatWasJudged) {
  const JudgedSurvey survey = test::judged_survey();
  const Frame frame;
  const auto read = [](const std::string& text) { return nlohmann::json::parse(text); };
  const auto with = read(score_json("nuc", {}, test::provenance(), {&survey, &frame}));
  EXPECT_EQ(with["criterion"]["title"], "IHO S-44 Special Order");
  EXPECT_EQ(read(score_json("nuc", {}, test::provenance())).count("criterion"), 0U);
}

}  // namespace
}  // namespace swathplan
