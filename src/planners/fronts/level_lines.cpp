#include "planners/fronts/level_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace swathplan {
namespace {

/// A point of a line lies on an edge between two cells, and the edge's number names it. Even: from
/// a cell to its eastern neighbour. Odd: to its northern one.
using EdgeKey = std::uint64_t;

class Chains {
 public:
  void link(EdgeKey a, const Vec2& at_a, EdgeKey b, const Vec2& at_b) {
    point(a, at_a).push(b);
    point(b, at_b).push(a);
  }

  std::vector<SurveyCurve> curves() {
    std::vector<SurveyCurve> result;
    // Open chains come first, from one of their ends. The chains that are left are closed.
    for (const bool open : {true, false}) {
      for (const EdgeKey key : order_) {
        const Node& node = nodes_.at(key);
        if (node.used || (open && node.links != 1)) continue;
        result.push_back(walk(key));
      }
    }
    return result;
  }

 private:
  struct Node {
    Vec2 at = Vec2::Zero();
    std::array<EdgeKey, 2> next{};
    int links = 0;
    bool used = false;
    void push(EdgeKey key) {
      if (links < 2) next[static_cast<std::size_t>(links++)] = key;
    }
  };

  Node& point(EdgeKey key, const Vec2& at) {
    const auto [it, fresh] = nodes_.try_emplace(key);
    if (fresh) {
      it->second.at = at;
      order_.push_back(key);
    }
    return it->second;
  }

  SurveyCurve walk(EdgeKey key) {
    SurveyCurve curve;
    const EdgeKey first = key;
    for (;;) {
      Node& node = nodes_.at(key);
      node.used = true;
      curve.points.push_back(node.at);
      bool on = false;
      for (int k = 0; k < node.links && !on; ++k) {
        const EdgeKey next = node.next[static_cast<std::size_t>(k)];
        if (nodes_.at(next).used) continue;
        key = next;
        on = true;
      }
      if (on) continue;
      const bool closed = curve.points.size() > 3 && node.links == 2 &&
                          (node.next[0] == first || node.next[1] == first);
      if (closed) curve.points.push_back(curve.points.front());
      return curve;
    }
  }

  std::unordered_map<EdgeKey, Node> nodes_;
  std::vector<EdgeKey> order_;  // of appearance, so that the result is always the same
};

}  // namespace

std::vector<SurveyCurve> level_lines(const WaterRaster& raster, const std::vector<float>& u,
                                     double level) {
  Chains chains;
  const std::size_t columns = raster.columns();
  for (std::size_t r = 0; r + 1 < raster.rows(); ++r) {
    for (std::size_t c = 0; c + 1 < columns; ++c) {
      const std::array<std::size_t, 4> cell{r * columns + c, r * columns + c + 1,
                                            (r + 1) * columns + c + 1, (r + 1) * columns + c};
      if (!std::all_of(cell.begin(), cell.end(),
                       [&](std::size_t i) { return std::isfinite(u[i]); })) {
        continue;
      }
      // Edges: south (of 0), east (of 1), north (of 3), west (of 0).
      const std::array<EdgeKey, 4> keys{2 * cell[0], 2 * cell[1] + 1, 2 * cell[3], 2 * cell[0] + 1};
      std::array<std::pair<EdgeKey, Vec2>, 4> cuts;
      std::size_t count = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t a = cell[k];
        const std::size_t b = cell[(k + 1) % 4];
        const double ua = static_cast<double>(u[a]) - level;
        const double ub = static_cast<double>(u[b]) - level;
        if ((ua >= 0.0) == (ub >= 0.0)) continue;
        const double t = ua / (ua - ub);
        cuts[count++] = {keys[k], (1.0 - t) * raster.centre(a) + t * raster.centre(b)};
      }
      for (std::size_t k = 0; k + 1 < count; k += 2) {
        chains.link(cuts[k].first, cuts[k].second, cuts[k + 1].first, cuts[k + 1].second);
      }
    }
  }
  return chains.curves();
}

}  // namespace swathplan
