#include <algorithm>
#include <cmath>
#include <tuple>

#include "mesh/plane/segment_pairs_internal.h"

namespace swathplan::internal {
namespace {

struct Item {
  std::int64_t column, row;
  std::uint32_t segment;
  [[nodiscard]] auto key() const { return std::tuple(row, column, segment); }
};

struct Box {
  Vec2 low, high;
};

std::int64_t index(double x) { return static_cast<std::int64_t>(std::floor(x)); }

// Adds the buckets that a segment meets or passes within `hair` bucket widths.
void fill_buckets(const Vec2& a, const Vec2& b, double hair, std::uint32_t segment,
                  std::vector<Item>& items) {
  const Vec2& low = a.y() <= b.y() ? a : b;
  const Vec2& high = a.y() <= b.y() ? b : a;
  const double per_y = high.y() > low.y() ? (high.x() - low.x()) / (high.y() - low.y()) : 0.0;
  for (std::int64_t row = index(low.y() - hair); row <= index(high.y() + hair); ++row) {
    double x0 = low.x();
    double x1 = high.x();
    if (high.y() - low.y() > hair) {
      const auto y = static_cast<double>(row);
      x0 = low.x() + per_y * (std::clamp(y - hair, low.y(), high.y()) - low.y());
      x1 = low.x() + per_y * (std::clamp(y + 1.0 + hair, low.y(), high.y()) - low.y());
    }
    const std::int64_t last = index(std::max(x0, x1) + hair);
    for (std::int64_t column = index(std::min(x0, x1) - hair); column <= last; ++column) {
      items.push_back({column, row, segment});
    }
  }
}

Box box_of(const Vec2& a, const Vec2& b) { return {a.cwiseMin(b), a.cwiseMax(b)}; }

bool apart(const Box& a, const Box& b, double reach) {
  return ((a.low - b.high).array() > reach).any() || ((b.low - a.high).array() > reach).any();
}

}  // namespace

std::vector<std::pair<std::uint32_t, std::uint32_t>> segment_pairs(const std::vector<Vec2>& path,
                                                                   double reach_m) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> found;
  if (path.size() < 3) return found;
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) length += (path[i + 1] - path[i]).norm();
  if (length == 0.0) return found;
  // Buckets as wide as the mean segment is long: the path then has a few entries for each segment.
  const double cell = length / static_cast<double>(path.size() - 1);
  constexpr double kHair = 1e-6;  // bucket widths, against rounding
  std::vector<Item> items;
  std::vector<Box> boxes;
  for (std::uint32_t i = 0; i + 1 < path.size(); ++i) {
    fill_buckets((path[i] - path[0]) / cell, (path[i + 1] - path[0]) / cell, kHair + reach_m / cell,
                 i, items);
    boxes.push_back(box_of(path[i], path[i + 1]));
  }
  std::sort(items.begin(), items.end(),
            [](const Item& x, const Item& y) { return x.key() < y.key(); });
  std::size_t begin = 0;
  for (std::size_t end = 1; end <= items.size(); ++end) {
    if (end < items.size() && items[end].row == items[begin].row &&
        items[end].column == items[begin].column) {
      continue;
    }
    for (std::size_t i = begin; i < end; ++i) {
      for (std::size_t j = i + 1; j < end; ++j) {
        const auto a = items[i].segment;
        const auto b = items[j].segment;
        if (!apart(boxes[a], boxes[b], reach_m)) found.emplace_back(a, b);
      }
    }
    begin = end;
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace swathplan::internal
