#include "io/files/layer_choice.h"

#include <gmock/gmock.h>

#include "io/import_files.h"

namespace swathplan {
namespace {

using testing::HasSubstr;

TEST(LayerChoice, TakesTheFirstNameThatTheFileHolds) {
  EXPECT_EQ(chosen_layer("b", {"a", "b"}), 1U);
  EXPECT_EQ(chosen_layer("other, B ,a", {"a", "b"}), 1U);
  EXPECT_FALSE(chosen_layer("", {"a", ""}));
  EXPECT_FALSE(chosen_layer("c", {"a", "b"}));
}

TEST(LayerChoice, RefusalListsThem) {
  EXPECT_THAT(refusal([]() -> int {
                refuse_layers("x.gpkg", {"a", "b"});
              }),
              HasSubstr("'x.gpkg' holds 2 layers (a, b); choose one with <layer>"));
}

}  // namespace
}  // namespace swathplan
