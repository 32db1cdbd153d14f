#include "mesh/plane/area_query.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/plane/segments.h"

namespace swathplan {

struct AreaEdge {
  Vec2 a, b;
};

struct AreaQuery::Impl {
  std::vector<AreaEdge> edges;
  Box2 box;
  double cell = 1.0;
  std::int64_t columns = 0, rows = 0;
  std::vector<std::uint32_t> start, items;  // edges per bucket
  // Edges per strip, to count the crossings of a ray from a point. Strips are lower than buckets,
  // so that few edges are looked at that the ray does not meet.
  static constexpr std::int64_t kStripsPerRow = 16;
  std::vector<std::uint32_t> strip_start, strip_items;

  [[nodiscard]] std::int64_t column(double x) const {
    return std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor((x - box.min.x()) / cell)),
                                    0, columns - 1);
  }
  [[nodiscard]] std::int64_t row(double y) const {
    return std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor((y - box.min.y()) / cell)),
                                    0, rows - 1);
  }

  [[nodiscard]] std::int64_t strip(double y) const {
    return std::clamp<std::int64_t>(
        static_cast<std::int64_t>(std::floor((y - box.min.y()) / cell * kStripsPerRow)), 0,
        rows * kStripsPerRow - 1);
  }

  void add_ring(const Ring& ring) {
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
      edges.push_back({ring[j], ring[i]});
      box.extend(ring[i]);
    }
  }

  void fill();
  [[nodiscard]] bool inside(const Vec2& p) const;
  /// Distance and point; `within` and p where the outline is not nearer than that.
  [[nodiscard]] std::pair<double, Vec2> nearest(
      const Vec2& p, double within = std::numeric_limits<double>::infinity()) const;
};

void AreaQuery::Impl::fill() {
  const Vec2 size = box.size();
  const double buckets = static_cast<double>(std::max<std::size_t>(edges.size(), 16));
  cell = std::max({std::sqrt(std::max(size.x() * size.y(), 1e-12) / buckets),
                   std::max(size.x(), size.y()) / (4.0 * std::sqrt(buckets)), 1e-6});
  columns = std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(size.x() / cell)));
  rows = std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(size.y() / cell)));
  const auto fill_index = [&](std::vector<std::uint32_t>& first, std::vector<std::uint32_t>& list,
                              std::size_t count, auto&& each) {
    first.assign(count + 1, 0);
    each([&](std::size_t b, std::uint32_t) { ++first[b + 1]; });
    for (std::size_t b = 1; b <= count; ++b) first[b] += first[b - 1];
    list.resize(first.back());
    std::vector<std::uint32_t> at(first.begin(), first.end() - 1);
    each([&](std::size_t b, std::uint32_t i) { list[at[b]++] = i; });
  };
  fill_index(start, items, static_cast<std::size_t>(columns * rows), [&](auto&& put) {
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
      const AreaEdge& e = edges[i];
      for (std::int64_t r = row(std::min(e.a.y(), e.b.y())); r <= row(std::max(e.a.y(), e.b.y()));
           ++r) {
        for (std::int64_t c = column(std::min(e.a.x(), e.b.x()));
             c <= column(std::max(e.a.x(), e.b.x())); ++c) {
          put(static_cast<std::size_t>(r * columns + c), i);
        }
      }
    }
  });
  fill_index(strip_start, strip_items, static_cast<std::size_t>(rows * kStripsPerRow),
             [&](auto&& put) {
               for (std::uint32_t i = 0; i < edges.size(); ++i) {
                 const AreaEdge& e = edges[i];
                 const std::int64_t last = strip(std::max(e.a.y(), e.b.y()));
                 for (std::int64_t k = strip(std::min(e.a.y(), e.b.y())); k <= last; ++k) {
                   put(static_cast<std::size_t>(k), i);
                 }
               }
             });
}

bool AreaQuery::Impl::inside(const Vec2& p) const {
  if (edges.empty() || p.y() < box.min.y() || p.y() > box.max.y() || p.x() < box.min.x() ||
      p.x() > box.max.x()) {
    return false;
  }
  bool in = false;
  const auto s = static_cast<std::size_t>(strip(p.y()));
  for (std::uint32_t k = strip_start[s]; k < strip_start[s + 1]; ++k) {
    const AreaEdge& e = edges[strip_items[k]];
    if ((e.a.y() > p.y()) == (e.b.y() > p.y())) continue;
    if (e.a.x() <= p.x() && e.b.x() <= p.x()) continue;
    const double x = e.a.x() + (p.y() - e.a.y()) / (e.b.y() - e.a.y()) * (e.b.x() - e.a.x());
    if (x > p.x()) in = !in;
  }
  return in;
}

std::pair<double, Vec2> AreaQuery::Impl::nearest(const Vec2& p, double within) const {
  double best = within;
  Vec2 point = p;
  if (edges.empty()) return {best, point};
  const std::int64_t c0 = column(p.x());
  const std::int64_t r0 = row(p.y());
  const auto visit = [&](std::int64_t c, std::int64_t r) {
    if (c < 0 || r < 0 || c >= columns || r >= rows) return;
    const auto b = static_cast<std::size_t>(r * columns + c);
    for (std::uint32_t k = start[b]; k < start[b + 1]; ++k) {
      const AreaEdge& e = edges[items[k]];
      const Vec2 q = nearest_on_segment(e.a, e.b, p).point;
      const double d = (q - p).norm();
      if (d < best) {
        best = d;
        point = q;
      }
    }
  };
  // A point outside the extent is looked up at the nearest point inside. It is farther off from
  // each ring of buckets by that gap.
  const Vec2 clamped(std::clamp(p.x(), box.min.x(), box.max.x()),
                     std::clamp(p.y(), box.min.y(), box.max.y()));
  const double gap = (clamped - p).norm();
  for (std::int64_t ring = 0; ring <= std::max(columns, rows); ++ring) {
    if (static_cast<double>(ring - 1) * cell - gap > best) break;
    for (std::int64_t k = -ring; k <= ring; ++k) {
      visit(c0 + k, r0 - ring);
      if (ring > 0) visit(c0 + k, r0 + ring);
      if (k > -ring && k < ring) {
        visit(c0 - ring, r0 + k);
        visit(c0 + ring, r0 + k);
      }
    }
  }
  return {best, point};
}

AreaQuery::AreaQuery(const Area& area) : impl_(std::make_unique<Impl>()) {
  for (const Polygon& polygon : area) {
    if (!polygon.outer.empty()) impl_->add_ring(polygon.outer);
    for (const Ring& hole : polygon.holes) {
      if (!hole.empty()) impl_->add_ring(hole);
    }
  }
  if (!impl_->edges.empty()) impl_->fill();
}
AreaQuery::~AreaQuery() = default;
AreaQuery::AreaQuery(AreaQuery&&) noexcept = default;
AreaQuery& AreaQuery::operator=(AreaQuery&&) noexcept = default;

bool AreaQuery::contains(const Vec2& p) const {
  return impl_->inside(p) || impl_->nearest(p, 2.0 * kOnOutline).first <= kOnOutline;
}

double AreaQuery::distance(const Vec2& p) const { return impl_->nearest(p).first; }
Vec2 AreaQuery::nearest_on_outline(const Vec2& p) const { return impl_->nearest(p).second; }

std::vector<std::pair<double, double>> AreaQuery::clip(const Vec2& a, const Vec2& b) const {
  std::vector<std::pair<double, double>> result;
  const Impl& d = *impl_;
  if (d.edges.empty()) return result;
  const Vec2 way = b - a;
  std::vector<double> cuts{0.0, 1.0};
  // The buckets that the segment passes, row by row: the columns between the places where it enters
  // and leaves the row, and one more on either side against rounding. An edge that is met twice
  // cuts at the same place twice, which does no harm.
  const std::int64_t r0 = d.row(std::min(a.y(), b.y()));
  const std::int64_t r1 = d.row(std::max(a.y(), b.y()));
  for (std::int64_t r = r0; r <= r1; ++r) {
    double x0 = std::min(a.x(), b.x());
    double x1 = std::max(a.x(), b.x());
    if (r0 != r1 && way.y() != 0.0) {
      const double y0 = d.box.min.y() + static_cast<double>(r) * d.cell;
      const double t0 = std::clamp((y0 - a.y()) / way.y(), 0.0, 1.0);
      const double t1 = std::clamp((y0 + d.cell - a.y()) / way.y(), 0.0, 1.0);
      // The rows at the rim also hold what lies beyond the extent.
      if (r != 0 && r != d.rows - 1) {
        x0 = a.x() + way.x() * (way.x() > 0.0 ? std::min(t0, t1) : std::max(t0, t1));
        x1 = a.x() + way.x() * (way.x() > 0.0 ? std::max(t0, t1) : std::min(t0, t1));
      }
    }
    const std::int64_t c0 = std::max<std::int64_t>(0, d.column(x0) - 1);
    const std::int64_t c1 = std::min<std::int64_t>(d.columns - 1, d.column(x1) + 1);
    for (std::int64_t c = c0; c <= c1; ++c) {
      const auto bucket = static_cast<std::size_t>(r * d.columns + c);
      for (std::uint32_t k = d.start[bucket]; k < d.start[bucket + 1]; ++k) {
        const AreaEdge& e = d.edges[d.items[k]];
        const Vec2 along = e.b - e.a;
        const double denominator = cross(way, along);
        if (denominator == 0.0) continue;
        const Vec2 w = e.a - a;
        const double t = cross(w, along) / denominator;
        const double s = cross(w, way) / denominator;
        if (t > 0.0 && t < 1.0 && s >= -1e-12 && s <= 1.0 + 1e-12) cuts.push_back(t);
      }
    }
  }
  std::sort(cuts.begin(), cuts.end());
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    if (cuts[i + 1] <= cuts[i] || !contains(a + 0.5 * (cuts[i] + cuts[i + 1]) * way)) continue;
    if (!result.empty() && result.back().second == cuts[i]) {
      result.back().second = cuts[i + 1];
    } else {
      result.emplace_back(cuts[i], cuts[i + 1]);
    }
  }
  return result;
}

double AreaQuery::inside_length(const Vec2& a, const Vec2& b) const {
  double share = 0.0;
  for (const auto& [t0, t1] : clip(a, b)) share += t1 - t0;
  return share * (b - a).norm();
}

}  // namespace swathplan
