#include "io/charts/hazard_choice.h"

#include <gmock/gmock.h>

#include "io/import_files.h"

namespace swathplan {
namespace {

using testing::HasSubstr;
using HazardChoiceOf = ImportFiles;

std::string usage(const std::vector<std::string>& texts) {
  try {
    (void)parse_hazards(texts);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "accepted";
}

TEST_F(HazardChoiceOf, FilesLayersAndBuffers) {
  const std::string file = write("a.000", "x").string();
  const HazardChoices choices =
      parse_hazards({file, file + ":WRECKS=25", file + "=3", "OBSTRN=40", "RESARE=off"});
  ASSERT_EQ(choices.list.size(), 5U);
  EXPECT_TRUE(choices.unasked);
  EXPECT_EQ(choices.list[0].file, file);
  EXPECT_FALSE(choices.list[0].buffer_m);
  EXPECT_EQ(choices.list[1].layer, "WRECKS");
  EXPECT_EQ(choices.list[1].buffer_m, 25.0);
  EXPECT_EQ(choices.list[2].buffer_m, 3.0);
  EXPECT_TRUE(choices.list[2].layer.empty());
  EXPECT_TRUE(choices.list[3].file.empty());
  EXPECT_EQ(choices.list[3].layer, "OBSTRN");
  EXPECT_TRUE(choices.list[4].off);
  EXPECT_FALSE(parse_hazards({"none"}).unasked);
}

TEST_F(HazardChoiceOf, ANameWithAColonOrAnEqualsSignIsAFileWhereItExists) {
  const std::string file = write("a:b=2.gpkg", "x").string();
  EXPECT_EQ(parse_hazards({file}).list[0].file, file);
}

TEST_F(HazardChoiceOf, WhatCannotBeReadIsRefused) {
  EXPECT_THAT(usage({"charts/none.000"}), HasSubstr("'charts/none.000' does not exist"));
  EXPECT_THAT(usage({"none.000:WRECKS=3"}), HasSubstr("'none.000' does not exist"));
  EXPECT_THAT(usage({"WRECKS=wide"}), HasSubstr("'wide' is no buffer"));
  EXPECT_THAT(usage({"WRECKS=-3"}), HasSubstr("'-3' is no buffer"));
  EXPECT_THAT(usage({"DEPARE"}), HasSubstr("neither a file nor a class"));
  EXPECT_THAT(usage({"=3"}), HasSubstr("no file and no layer"));
}

}  // namespace
}  // namespace swathplan
