#include "io/files/xml.h"

#include <gtest/gtest.h>

namespace swathplan {
namespace {

TEST(XmlEscaped, LeavesNothingThatXmlCannotHold) {
  EXPECT_EQ(xml_escaped("a&b<c>\"d'"), "a&amp;b&lt;c&gt;&quot;d&apos;");
  EXPECT_EQ(xml_escaped("K\xC3\xB8ge\x01"), "K\xC3\xB8ge?");
  EXPECT_EQ(xml_escaped("\xFF"), "?");
}

}  // namespace
}  // namespace swathplan
