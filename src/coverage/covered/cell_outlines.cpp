#include "coverage/covered/cell_outlines.h"

#include <array>

namespace swathplan {
namespace {

/// Directions of an edge between two corners of the lattice, counter-clockwise.
enum Direction : std::uint8_t { east, north, west, south };
constexpr std::array<std::array<int, 2>, 4> kOutlineSteps{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

/// Walks along the edges that have a marked cell on their left and none on their right.
class OutlineWalker {
 public:
  OutlineWalker(const std::vector<std::uint8_t>& marked, const CellLattice& lattice)
      : marked_(marked), lattice_(lattice), edges_((lattice.columns + 1) * (lattice.rows + 1), 0) {
    for (std::size_t r = 0; r < lattice.rows; ++r) {
      for (std::size_t c = 0; c < lattice.columns; ++c) add_edges_of(c, r);
    }
  }

  [[nodiscard]] std::vector<Ring> rings() {
    std::vector<Ring> result;
    for (std::size_t corner = 0; corner < edges_.size(); ++corner) {
      while (edges_[corner] != 0) result.push_back(ring_from(corner));
    }
    return result;
  }

 private:
  [[nodiscard]] bool is_marked(std::size_t c, std::size_t r) const {
    return c < lattice_.columns && r < lattice_.rows && marked_[r * lattice_.columns + c] != 0;
  }
  [[nodiscard]] std::size_t corner_at(std::size_t c, std::size_t r) const {
    return r * (lattice_.columns + 1) + c;
  }

  void add_edges_of(std::size_t c, std::size_t r) {
    if (!is_marked(c, r)) return;
    const auto add = [&](std::size_t corner, Direction direction) {
      edges_[corner] = static_cast<std::uint8_t>(edges_[corner] | (1U << direction));
    };
    if (r == 0 || !is_marked(c, r - 1)) add(corner_at(c, r), east);
    if (!is_marked(c + 1, r)) add(corner_at(c + 1, r), north);
    if (!is_marked(c, r + 1)) add(corner_at(c + 1, r + 1), west);
    if (c == 0 || !is_marked(c - 1, r)) add(corner_at(c, r + 1), south);
  }

  [[nodiscard]] Ring ring_from(std::size_t start) {
    Ring ring;
    std::size_t corner = start;
    int came = -1;
    do {
      const int next = leaving(corner, came);
      if (next != came) ring.push_back(place(corner));
      edges_[corner] = static_cast<std::uint8_t>(edges_[corner] & ~(1U << next));
      const auto width = static_cast<std::ptrdiff_t>(lattice_.columns + 1);
      const auto& step = kOutlineSteps.at(static_cast<std::size_t>(next));
      corner =
          static_cast<std::size_t>(static_cast<std::ptrdiff_t>(corner) + step[0] + step[1] * width);
      came = next;
    } while (corner != start);
    return ring;
  }

  /// The edge to go on by. Where cells meet at a corner only, the left turn stays at one cell.
  [[nodiscard]] int leaving(std::size_t corner, int came) const {
    if (came < 0) {
      int first = 0;
      while ((edges_[corner] & (1U << first)) == 0) ++first;
      return first;
    }
    for (const int turn : {1, 0, 3}) {
      const int direction = (came + turn) % 4;
      if ((edges_[corner] & (1U << direction)) != 0) return direction;
    }
    return came;  // not reached: as many edges leave a corner as come to it
  }

  [[nodiscard]] Vec2 place(std::size_t corner) const {
    const std::size_t width = lattice_.columns + 1;
    const std::size_t row = corner / width;
    return lattice_.origin +
           lattice_.cell_m * Vec2(static_cast<double>(corner % width), static_cast<double>(row));
  }

  const std::vector<std::uint8_t>& marked_;
  const CellLattice& lattice_;
  std::vector<std::uint8_t> edges_;
};

}  // namespace

Area outlines(const std::vector<std::uint8_t>& marked, const CellLattice& lattice) {
  return from_rings(OutlineWalker(marked, lattice).rings(), true);
}

}  // namespace swathplan
