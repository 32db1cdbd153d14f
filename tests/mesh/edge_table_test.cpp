#include "mesh/edge_table.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

namespace swathplan {
namespace {

TEST(EdgeTable, TwoFacesShareOneEdgeInOppositeSenses) {
  const std::vector<Seafloor::Face> faces{{0, 1, 2}, {2, 1, 3}};
  const std::vector<EdgeUse> uses = edge_uses(faces, 4);
  ASSERT_EQ(uses.size(), 6U);
  std::size_t edges = 0;
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    ++edges;
    const bool shared = edge[0].low == 1 && edge[0].high == 2;
    ASSERT_EQ(edge.size(), shared ? 2U : 1U);
    if (shared) {
      EXPECT_EQ(edge[0].face, 0U);
      EXPECT_EQ(edge[1].face, 1U);
      EXPECT_NE(edge[0].ascends, edge[1].ascends);
    }
  });
  EXPECT_EQ(edges, 5U);
}

TEST(EdgeTable, NoFacesHaveNoEdges) {
  EXPECT_TRUE(edge_uses({}, 0).empty());
  EXPECT_TRUE(edge_uses({}, 7).empty());
  for_each_edge({}, [](std::span<const EdgeUse>) { ADD_FAILURE() << "an edge of nothing"; });
}

// Any soup of faces, repeated corners included, against a map that is filled the slow way.
TEST(EdgeTable, HoldsWhatAMapOfAllEdgesHolds) {
  std::mt19937 random(5);
  for (const std::uint32_t vertices : {1U, 4U, 40U}) {
    std::vector<Seafloor::Face> faces;
    for (int f = 0; f < 60; ++f) {
      const auto corner = [&] { return static_cast<std::uint32_t>(random() % vertices); };
      faces.push_back({corner(), corner(), corner()});
    }
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::multiset<std::uint32_t>> expected;
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
      for (std::size_t i = 0; i < 3; ++i) {
        const auto [low, high] = std::minmax(faces[f].at(i), faces[f].at((i + 1) % 3));
        expected[{low, high}].insert(f);
      }
    }
    auto next = expected.begin();
    for_each_edge(edge_uses(faces, vertices), [&](std::span<const EdgeUse> edge) {
      ASSERT_NE(next, expected.end());
      EXPECT_EQ(next->first, std::pair(edge[0].low, edge[0].high));
      std::vector<std::uint32_t> users;
      for (const EdgeUse& use : edge) {
        users.push_back(use.face);
        const auto& face = faces[use.face];
        const std::uint32_t from = face.at(use.corner);
        const std::uint32_t to = face.at((use.corner + 1U) % 3U);
        EXPECT_EQ(std::min(from, to), use.low);
        EXPECT_EQ(std::max(from, to), use.high);
        EXPECT_EQ(use.ascends, from < to);
      }
      EXPECT_EQ(users, std::vector<std::uint32_t>(next->second.begin(), next->second.end()));
      ++next;
    });
    EXPECT_EQ(next, expected.end());
  }
}

}  // namespace
}  // namespace swathplan
