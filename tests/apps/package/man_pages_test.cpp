#include "apps/package/man_pages.h"

#include <gmock/gmock.h>

namespace swathplan {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// A program with two commands to call, one of them below another, and a hidden one.
class ManPages : public testing::Test {
 protected:
  std::vector<Command> commands() {
    Option depth = real("--depth", "Water", depth_m_, kMetres, above(0.0), "Depth", "depth_m");
    Option shape = choice("--shape", "", shape_, {"round", "square"}, "Shape", "shape");
    const Command live{"live", "Sail", {std::move(depth)}, [] {}, {}};
    return {
        {"draw", ".Draw it", {argument("FILE", shape_, "A 'file'"), std::move(shape)}, [] {}, {}},
        {"adapt", "Adapt", {}, {}, {live}},
        {"secret", "For builders", {}, [] {}, {}, true}};
  }

 private:
  double depth_m_ = 2.5;
  std::string shape_ = "round";
};

TEST_F(ManPages, AreOneForTheProgramAndOneForEachCommandThatDoesSomething) {
  std::vector<std::string> names;
  for (const WrittenPage& page : man_pages("Plans", "1.2", commands())) names.push_back(page.name);
  EXPECT_THAT(names, ElementsAre("swathplan.1", "swathplan-draw.1", "swathplan-adapt-live.1"));
}

TEST_F(ManPages, SayHelpRuleAndDefaultOfEachOption) {
  const auto pages = man_pages("Plans", "1.2", commands());
  EXPECT_THAT(pages[2].text, HasSubstr(".SS Water\n.TP\n\\fB\\-\\-depth\\fR \\fIFLOAT\\fR\n"
                                       "Depth. Must be above 0 metres. Default: 2.5.\n"));
  EXPECT_THAT(pages[1].text, HasSubstr("\\fI{round,square}\\fR\nShape. Default: round.\n"));
}

TEST_F(ManPages, KeepHiddenCommandsOut) {
  for (const WrittenPage& page : man_pages("Plans", "1.2", commands())) {
    EXPECT_THAT(page.text, Not(HasSubstr("secret"))) << page.name;
  }
}

TEST_F(ManPages, EscapeWhatRoffWouldTakeForRequests) {
  const std::string main = man_pages("Plans", "1.2", commands())[0].text;
  EXPECT_THAT(main, HasSubstr("\n\\&.Draw it.\n"));
}

}  // namespace
}  // namespace swathplan
