#include <gtest/gtest.h>

#include "io/base64.h"
#include "io/report/pictures_internal.h"

namespace swathplan {
namespace {

TEST(IndexedPng, Base64IsTheKnownOne) {
  EXPECT_EQ(internal::base64(""), "");
  EXPECT_EQ(internal::base64("f"), "Zg==");
  EXPECT_EQ(internal::base64("fo"), "Zm8=");
  EXPECT_EQ(internal::base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(test::bytes_of(internal::base64("\xff\x01z")), "\xff\x01z");
}

}  // namespace
}  // namespace swathplan
