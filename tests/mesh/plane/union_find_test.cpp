#include "mesh/plane/union_find.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace swathplan {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(UnionFind, EachMemberIsASetAtFirst) {
  UnionFind sets(3);
  EXPECT_EQ(sets.count(), 3U);
  for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ(sets.find(i), i);
  EXPECT_THAT(sets.numbered(), ElementsAre(0, 1, 2));
}

TEST(UnionFind, NoMembersAreNoSets) {
  UnionFind sets;
  EXPECT_EQ(sets.count(), 0U);
  EXPECT_THAT(sets.numbered(), IsEmpty());
}

TEST(UnionFind, TheLowestMemberIsTheRoot) {
  UnionFind sets(6);
  EXPECT_TRUE(sets.join(4, 5));
  EXPECT_TRUE(sets.join(2, 5));
  EXPECT_EQ(sets.find(4), 2U);
  EXPECT_EQ(sets.find(5), 2U);
  EXPECT_EQ(sets.count(), 4U);
  EXPECT_THAT(sets.numbered(), ElementsAre(0, 1, 2, 3, 2, 2));
}

TEST(UnionFind, JoiningOneSetWithItselfSaysSo) {
  UnionFind sets(3);
  EXPECT_TRUE(sets.join(0, 2));
  EXPECT_FALSE(sets.join(2, 0));
  EXPECT_FALSE(sets.join(1, 1));
  EXPECT_EQ(sets.count(), 2U);
}

TEST(UnionFind, GrowsByOneMemberAtATime) {
  UnionFind sets;
  EXPECT_EQ(sets.add(), 0U);
  EXPECT_EQ(sets.add(), 1U);
  sets.join_under(1, 0);
  EXPECT_EQ(sets.find(0), 1U);
  EXPECT_EQ(sets.count(), 1U);
}

// Against labels that are rewritten at each join.
TEST(UnionFind, AgreesWithPlainLabels) {
  std::mt19937 random(7);
  constexpr std::uint32_t kMembers = 60;
  UnionFind sets(kMembers);
  std::vector<std::uint32_t> label(kMembers);
  std::iota(label.begin(), label.end(), 0U);
  for (int k = 0; k < 50; ++k) {
    const auto a = static_cast<std::uint32_t>(random() % kMembers);
    const auto b = static_cast<std::uint32_t>(random() % kMembers);
    const std::uint32_t low = std::min(label[a], label[b]);
    const std::uint32_t high = std::max(label[a], label[b]);
    EXPECT_EQ(sets.join(a, b), low != high);
    std::replace(label.begin(), label.end(), high, low);
    for (std::uint32_t i = 0; i < kMembers; ++i) EXPECT_EQ(sets.find(i), label[i]);
  }
}

}  // namespace
}  // namespace swathplan
