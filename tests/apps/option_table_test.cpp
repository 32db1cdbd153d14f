#include "apps/option_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <set>

#include "apps/command_line.h"
#include "apps/options.h"
#include "apps/survey.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// Every row that commands share.
struct SharedRows {
  SiteOptions site;
  SurveyOptions survey;
  ExportChoice exports;
  OutputOptions output;
  OptionTable rows =
      joined({site_options(site), scoring_options(survey), planning_options(survey.planning),
              exporting_options(exports), output_options(output)});
};

/// What an action says when it refuses.
template <class Action>
std::string refusal(Action&& action) {
  try {
    action();
  } catch (const UsageError& error) {
    return in_flags(error);
  }
  return "accepted";
}

/// `plan` with these words typed; what it was given stays in `shared`.
void type(SharedRows& shared, std::vector<const char*> words) {
  words.insert(words.begin(), {"swathplan", "plan"});
  ASSERT_EQ(run_commands(
                "", [] { return std::string(); }, {{"plan", "", shared.rows, [] {}, {}}},
                static_cast<int>(words.size()), words.data()),
            0);
}

TEST(OptionTable, EveryRowHasHelpAndAFlagOfItsOwn) {
  const SharedRows shared;
  std::set<std::string> flags;
  for (const Option& option : shared.rows) {
    EXPECT_GT(option.help.size(), 4U) << option.flag;
    EXPECT_TRUE(flags.insert(long_flag(option)).second) << option.flag << " twice";
  }
}

TEST(OptionTable, EveryRowThatResultsDependOnHasANameInOutputs) {
  const SharedRows shared;
  // What is printed, where results go and how many threads work on them.
  const std::set<std::string> apart{"--output", "--json", "--quiet", "--threads"};
  std::set<std::string> names;
  for (const Option& option : shared.rows) {
    if (is_argument(option)) continue;
    EXPECT_EQ(option.name.empty(), apart.contains(long_flag(option))) << option.flag;
    if (!option.name.empty()) {
      EXPECT_TRUE(names.insert(option.name).second) << option.name;
    }
  }
}

TEST(OptionTable, NamesEndInTheirUnits) {
  const SharedRows shared;
  const std::vector<std::pair<Unit, std::string>> endings{
      {kMetres, "_m"}, {kSquareMetres, "_m2"}, {kDegrees, "_deg"}, {kMetresPerSecond, "_mps"},
      {kHours, "_h"},  {kPerCent, "_pct"},     {kWatts, "_w"}};
  for (const Option& option : shared.rows) {
    for (const auto& [unit, ending] : endings) {
      if (option.unit != unit) continue;
      EXPECT_TRUE(option.name.ends_with(ending)) << option.name;
    }
  }
}

TEST(OptionTable, DefaultsKeepTheirRules) {
  const SharedRows shared;
  for (const Option& option : shared.rows) EXPECT_NO_THROW(check(option)) << option.flag;
}

TEST(OptionTable, ARefusalNamesFlagValueAndRule) {
  const auto of = [](std::vector<const char*> words) {
    SharedRows shared;
    words.insert(words.begin(), "file");
    return refusal([&] { type(shared, words); });
  };
  EXPECT_EQ(of({"--draft", "-1"}), "--draft -1; must be 0 metres or more");
  EXPECT_EQ(of({"--resolution", "0"}), "--resolution 0; must be above 0 metres");
  EXPECT_EQ(of({"--resolution", "nan"}), "--resolution nan; must be above 0 metres");
  EXPECT_EQ(of({"--resolution", "fine"}), "--resolution fine; must be a number of metres");
  EXPECT_EQ(of({"--heading", "400"}), "--heading 400; must be at least 0 and under 360 degrees");
  EXPECT_EQ(of({"--ping-spacing", "1e6"}),
            "--ping-spacing 1e+06; must be above 0 and at most 100 metres");
  EXPECT_THAT(of({"--max-opening", "180"}),
              HasSubstr("must lie between 0 and 180 degrees, both excluded: a beam"));
  EXPECT_EQ(of({"--beams", "1"}), "--beams 1; must be 2 to 100000");
  EXPECT_EQ(of({"--seed", "-1"}), "--seed -1; must be a whole number of 0 or more");
  EXPECT_EQ(of({"--cover", "sight"}), "--cover sight; must be hit or footprint");
  EXPECT_THAT(of({"--z-unit", "yard"}), AllOf(HasSubstr("--z-unit yard"), HasSubstr("fathom")));
  EXPECT_THAT(of({"-o", ""}), HasSubstr("--output is empty"));
  EXPECT_THAT(of({"--length", "10", "--time", "1"}),
              AllOf(HasSubstr("--length"), HasSubstr("--time")));
}

TEST(OptionTable, FillsWhatTheRowsPointTo) {
  SharedRows shared;
  type(shared, {"a.asc", "--z-unit", "foot", "--draft", "0.7", "--hit-only", "--export", "gpx,kml",
                "--seed", "18446744073709551615"});
  EXPECT_EQ(shared.site.file, "a.asc");
  EXPECT_EQ(shared.site.z_unit_m, 0.3048);
  EXPECT_EQ(shared.survey.vehicle.draft_m, 0.7);
  EXPECT_FALSE(shared.survey.vehicle.squat_m);
  EXPECT_TRUE(shared.survey.scoring.hit_only);
  EXPECT_EQ(shared.exports.formats, (std::vector<std::string>{"gpx", "kml"}));
  EXPECT_EQ(shared.survey.noise.seed, 18446744073709551615U);
}

TEST(OptionTable, SpeedsMayNameTheirUnit) {
  const auto speed = [](const char* text) {
    SharedRows shared;
    type(shared, {"file", "--speed", text});
    return shared.survey.vehicle.speed_mps.value();
  };
  for (const char* text : {"4kn", "4 kn", "4kt", "4.0 kts", "4 knots"}) {
    EXPECT_NEAR(speed(text), 2.0578, 1e-4) << text;
  }
  EXPECT_DOUBLE_EQ(speed("2.1m/s"), 2.1);
  EXPECT_DOUBLE_EQ(speed("2.1"), 2.1);
  EXPECT_DOUBLE_EQ(speed("7.2km/h"), 2.0);
  SharedRows shared;
  for (const char* text : {"4 bft", "kn", "4 knn"}) {
    EXPECT_THAT(refusal([&] { type(shared, {"file", "--speed", text}); }), HasSubstr("as 4kn"));
  }
  EXPECT_THAT(refusal([&] { type(shared, {"file", "--draft", "4kn"}); }), HasSubstr("of metres"));
}

TEST(OptionTable, WhatIsChosenDecidesWhatIsOfUse) {
  std::string planner = "nuc";
  double heading = 30.0;
  const OptionTable rows{
      chooser(text("--planner", "", planner, "What plans", "planner")),
      used_by({"rows", "fitted"}, real("--heading", "", heading, kDegrees, any_number(), "", "h"))};
  EXPECT_EQ(chosen_in(rows), std::vector<std::string>{"nuc"});
  EXPECT_EQ(refusal([&] { check_used(rows, {"nuc"}); }),
            "--heading 30; nuc does not use it: leave it out, or choose rows or fitted");
  EXPECT_EQ(refusal([&] { check_used(rows, {"nuc", "rows"}); }), "accepted");
  EXPECT_EQ(refusal([&] { check_used(rows, {}); }), "accepted");
}

TEST(OptionTable, OnlyPlannersThatThereAreAreSaidToUseARow) {
  const SharedRows shared;
  const std::set<std::string> planners{"back-and-forth", "edge-following", "multi-depth", "nuc",
                                       "mdnuc",          "fitted-lines"};
  std::size_t rows = 0;
  for (const Option& option : shared.rows) {
    rows += option.used_by.empty() ? 0 : 1;
    for (const std::string& name : option.used_by) {
      EXPECT_TRUE(planners.contains(name)) << option.flag << ": " << name;
    }
  }
  EXPECT_GT(rows, 15U);
}

TEST(OptionTable, RecordsWhatWasInForceAndWhatFollowedFromIt) {
  SharedRows shared;
  type(shared, {"a.asc", "--vehicle", "launch", "--margin", "0.4"});
  const Survey survey = survey_of(shared.survey);
  Provenance provenance;
  record_scoring(provenance, shared.survey, survey);
  const auto value = [&](const std::string& name) {
    for (const auto& [known, v] : provenance.options) {
      if (known == name) return v;
    }
    return OptionValue(std::string("missing"));
  };
  EXPECT_EQ(value("draft_m"), OptionValue(1.0));
  EXPECT_EQ(value("under_keel_margin_m"), OptionValue(0.4));
  EXPECT_THAT(provenance.derived, testing::Contains("draft_m"));
  EXPECT_THAT(provenance.derived, testing::Not(testing::Contains("under_keel_margin_m")));
  EXPECT_EQ(provenance.seed, 1U);
}

TEST(OptionTable, ErrorsAboutFieldsOfACommandAreSaidInItsFlags) {
  double gap = 0.0;
  const Command command{"sail",
                        "",
                        {real("--nadir-gap", "", gap, kMetres, any_number(), "Blind strip", "g_m")},
                        [&] { throw UsageError("nadir gap", std::to_string(gap), "is wide"); },
                        {}};
  const std::array<const char*, 4> words{"swathplan", "sail", "--nadir-gap", "7"};
  EXPECT_EQ(refusal([&] {
              static_cast<void>(run_commands(
                  "", [] { return std::string(); }, {command}, 4, words.data()));
            }),
            "--nadir-gap 7.000000; is wide");
}

TEST(OptionTable, SentencesOfLibrariesGetTheirFlags) {
  EXPECT_EQ(in_flags("give the <CRS> EPSG:n or set <z unit>"),
            "give the --crs EPSG:n or set --z-unit");
  EXPECT_EQ(in_flags("a <strange word>, 1 < 2 > 0"), "a strange word, 1 < 2 > 0");
  EXPECT_EQ(in_flags(UsageError("longest edge", "-1", "must be above 0")),
            "--longest-edge -1; must be above 0");
  EXPECT_EQ(in_flags(InvalidInput("lower <clearance>")), "lower --clearance");
}

}  // namespace
}  // namespace swathplan
