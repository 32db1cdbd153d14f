#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace swathplan {

/// Disjoint sets of 0..n-1; the root of a set is its lowest member.
class UnionFind {
 public:
  explicit UnionFind(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0U); }
  [[nodiscard]] std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }
  [[nodiscard]] std::size_t count() const {
    std::size_t n = 0;
    for (std::uint32_t i = 0; i < parent_.size(); ++i) n += parent_[i] == i ? 1 : 0;
    return n;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace swathplan
