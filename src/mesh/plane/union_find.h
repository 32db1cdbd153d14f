#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace swathplan {

/// Disjoint sets of 0..n-1. The root of a set is its lowest member as long as join() alone makes
/// the sets. Members that are out of range are an error of the caller.
class UnionFind {
 public:
  /// n sets of one member each.
  explicit UnionFind(std::size_t n = 0) : parent_(n) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }
  /// A new set of one new member, which is returned.
  std::uint32_t add() {
    parent_.push_back(static_cast<std::uint32_t>(parent_.size()));
    return parent_.back();
  }
  /// The root of the set that i is in; halves the path to it.
  [[nodiscard]] std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// Joins the sets of a and b; false if they were one already.
  bool join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }
  /// Joins two sets by their roots: `root` stays the root, even if it is the higher one.
  void join_under(std::uint32_t root, std::uint32_t other_root) { parent_[other_root] = root; }
  /// Numbers 0, 1, ... for the sets, in the order of their lowest members; one for each member.
  /// After joins by join() only.
  [[nodiscard]] std::vector<std::uint32_t> numbered() {
    std::vector<std::uint32_t> number(parent_.size());
    std::uint32_t next = 0;
    for (std::uint32_t i = 0; i < number.size(); ++i) {
      number[i] = find(i) == i ? next++ : number[find(i)];
    }
    return number;
  }
  /// How many sets there are.
  [[nodiscard]] std::size_t count() const {
    std::size_t n = 0;
    for (std::uint32_t i = 0; i < parent_.size(); ++i) n += parent_[i] == i ? 1 : 0;
    return n;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace swathplan
