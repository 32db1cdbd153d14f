#include "io/results/provenance.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/results/provenance_json.h"

namespace swathplan {
namespace {

Provenance made_by_hand() {
  Provenance p;
  p.version = "1";
  p.command = "plan";
  p.input_file = "/somewhere/else/b.tif";
  p.input_hash = "sha1:0";
  p.options = {{"crs", std::string("a \"b\"")},
               {"draft_m", 0.1},
               {"beams", std::int64_t{256}},
               {"hit_only", true},
               {"limits_m", std::vector<double>{8.0, 15.5}},
               {"export", std::vector<std::string>{"gpx", "kml"}}};
  p.derived = {"draft_m"};
  return p;
}

TEST(Provenance, AsTomlHasALineForEachOptionAndCommentsForWhatFollows) {
  EXPECT_EQ(survey_toml(made_by_hand()),
            "# Options of 'plan', swathplan 1, as a configuration file.\n"
            "# FILE: b.tif, sha1:0\n"
            "seed = 1\n"
            "crs = \"a \\\"b\\\"\"\n"
            "# draft_m = 0.1  # follows from the others\n"
            "beams = 256\n"
            "hit_only = true\n"
            "limits_m = [8.0,15.5]\n"
            "export = [\"gpx\",\"kml\"]\n");
}

TEST(Provenance, AsJsonKeepsTheKindsOfValuesAndTheirOrder) {
  const nlohmann::ordered_json head = provenance_json(made_by_hand());
  EXPECT_EQ(head["program"], "swathplan");
  EXPECT_EQ(head["version"], "1");
  EXPECT_EQ(head["command"], "plan");
  EXPECT_EQ(head["input_hash"], "sha1:0");
  EXPECT_EQ(head["seed"], 1);
  EXPECT_EQ(head["options"].dump(),
            R"({"crs":"a \"b\"","draft_m":0.1,"beams":256,"hit_only":true,"limits_m":[8.0,15.5],)"
            R"("export":["gpx","kml"],"derived":["draft_m"]})");
}

TEST(Provenance, HoldsNoFolderOfTheInput) {
  const Provenance p = made_by_hand();
  EXPECT_EQ(provenance_json(p)["input_file"], "b.tif");
  EXPECT_EQ(provenance_json(p).dump().find("somewhere"), std::string::npos);
  EXPECT_EQ(survey_toml(p).find("somewhere"), std::string::npos);
}

TEST(Provenance, WithoutDerivedOptionsNamesNone) {
  Provenance p = made_by_hand();
  p.derived.clear();
  EXPECT_FALSE(provenance_json(p)["options"].contains("derived"));
}

TEST(Provenance, DegreesComeBackFromRadiansAsTheyWent) {
  for (const double degrees : {0.0, 2.0, 120.0, 130.1, 178.0}) {
    EXPECT_EQ(tidy_degrees(Angle::degrees(degrees)), degrees);
  }
}

TEST(JsonText, IsIndentedEndsInANewlineAndReplacesWhatIsNotUtf8) {
  EXPECT_EQ(json_text({{"a", 1}}), "{\n  \"a\": 1\n}\n");
  EXPECT_TRUE(nlohmann::json::accept(json_text({{"a", "r\xF8nne"}})));
}

}  // namespace
}  // namespace swathplan
