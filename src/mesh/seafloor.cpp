#include "mesh/seafloor.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/base/error.h"
#include "mesh/plane/segments.h"

namespace swathplan {
namespace {

/// A point this far outside a face, in barycentric coordinates, still counts as on it. It is the
/// rounding of one division.
constexpr double kBarycentricTolerance = 1e-9;
/// A face with a smaller plan area is a wall, which has no depth of its own, square metres.
constexpr double kLeastPlanArea = 1e-12;

double plan_cross(const Vec3& a, const Vec3& b, const Vec3& c) {
  return cross((b - a).head<2>(), (c - a).head<2>());
}

}  // namespace

Box2 extent(const Seafloor& seafloor) {
  Box2 box;
  for (const Vec3& v : seafloor.vertices) box.extend(v.head<2>());
  return box;
}

double plan_area_m2(const Seafloor& s) {
  double twice = 0.0;
  for (const Seafloor::Face& f : s.faces) {
    const Vec2 ab = (s.vertices[f[1]] - s.vertices[f[0]]).head<2>();
    const Vec2 ac = (s.vertices[f[2]] - s.vertices[f[0]]).head<2>();
    twice += std::abs(cross(ab, ac));
  }
  return 0.5 * twice;
}

DepthRange depth_range(const Seafloor& seafloor) {
  DepthRange range{std::numeric_limits<double>::infinity(), 0.0,
                   -std::numeric_limits<double>::infinity()};
  double area = 0.0;
  double volume = 0.0;
  for (const Seafloor::Face& f : seafloor.faces) {
    const Vec3& a = seafloor.vertices[f[0]];
    const Vec3& b = seafloor.vertices[f[1]];
    const Vec3& c = seafloor.vertices[f[2]];
    const double face_area = 0.5 * std::abs(plan_cross(a, b, c));
    area += face_area;
    volume -= face_area * (a.z() + b.z() + c.z()) / 3.0;
    for (const Vec3* v : {&a, &b, &c}) {
      range.min = std::min(range.min, -v->z());
      range.max = std::max(range.max, -v->z());
    }
  }
  if (!(area > 0.0)) {
    throw InvalidInput(
        "the seafloor has no face with a plan area; it is empty or a vertical sheet");
  }
  range.mean = volume / area;
  return range;
}

Angle slope(const Seafloor& seafloor, std::uint32_t face) {
  const Seafloor::Face& f = seafloor.faces[face];
  const Vec3 normal = (seafloor.vertices[f[1]] - seafloor.vertices[f[0]])
                          .cross(seafloor.vertices[f[2]] - seafloor.vertices[f[0]]);
  return Angle::radians(std::atan2(normal.head<2>().norm(), std::abs(normal.z())));
}

struct DepthQuery::Impl {
  const Seafloor* seafloor = nullptr;
  Box2 bounds;
  Vec2 origin = Vec2::Zero();
  double cell = 1.0;
  std::int64_t columns = 1, rows = 1;
  std::vector<std::uint32_t> start;  // per bucket, into `items`
  std::vector<std::uint32_t> items;  // faces
  std::vector<std::uint32_t> vertex_start, vertex_items;

  [[nodiscard]] std::int64_t column(double x) const {
    return std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor((x - origin.x()) / cell)),
                                    0, columns - 1);
  }
  [[nodiscard]] std::int64_t row(double y) const {
    return std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor((y - origin.y()) / cell)),
                                    0, rows - 1);
  }
  [[nodiscard]] std::size_t bucket(std::int64_t c, std::int64_t r) const {
    return static_cast<std::size_t>(r * columns + c);
  }

  void size_buckets(const Box2& box, std::size_t faces);
  void fill_faces();
  void fill_vertices();
};

void DepthQuery::Impl::size_buckets(const Box2& box, std::size_t faces) {
  origin = box.min;
  const Vec2 size = box.size();
  // About one face a bucket. A long and narrow extent must not make the number of buckets explode.
  const double buckets = static_cast<double>(std::max<std::size_t>(faces, 1));
  cell = std::max(std::sqrt(std::max(size.x() * size.y(), 1e-12) / buckets),
                  std::max(size.x(), size.y()) / (4.0 * std::sqrt(buckets) + 1.0));
  cell = std::max(cell, 1e-9);
  columns = std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(size.x() / cell)));
  rows = std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(size.y() / cell)));
}

void DepthQuery::Impl::fill_faces() {
  std::vector<std::uint32_t> count(static_cast<std::size_t>(columns * rows) + 1, 0);
  const auto each_bucket = [&](const Seafloor::Face& f, auto&& visit) {
    Box2 box;
    for (std::uint32_t v : f) box.extend(seafloor->vertices[v].head<2>());
    const std::int64_t c1 = column(box.max.x());
    const std::int64_t r1 = row(box.max.y());
    for (std::int64_t r = row(box.min.y()); r <= r1; ++r) {
      for (std::int64_t c = column(box.min.x()); c <= c1; ++c) visit(bucket(c, r));
    }
  };
  for (const auto& f : seafloor->faces) each_bucket(f, [&](std::size_t b) { ++count[b + 1]; });
  for (std::size_t b = 1; b < count.size(); ++b) count[b] += count[b - 1];
  start = count;
  items.resize(start.back());
  for (std::uint32_t i = 0; i < seafloor->faces.size(); ++i) {
    each_bucket(seafloor->faces[i], [&](std::size_t b) { items[count[b]++] = i; });
  }
}

void DepthQuery::Impl::fill_vertices() {
  std::vector<std::uint32_t> count(static_cast<std::size_t>(columns * rows) + 1, 0);
  const auto bucket_of = [&](const Vec3& v) { return bucket(column(v.x()), row(v.y())); };
  for (const Vec3& v : seafloor->vertices) ++count[bucket_of(v) + 1];
  for (std::size_t b = 1; b < count.size(); ++b) count[b] += count[b - 1];
  vertex_start = count;
  vertex_items.resize(vertex_start.back());
  for (std::uint32_t i = 0; i < seafloor->vertices.size(); ++i) {
    vertex_items[count[bucket_of(seafloor->vertices[i])]++] = i;
  }
}

DepthQuery::DepthQuery(const Seafloor& seafloor) : impl_(std::make_unique<Impl>()) {
  impl_->seafloor = &seafloor;
  impl_->bounds = swathplan::extent(seafloor);
  if (impl_->bounds.empty()) throw InvalidInput("the seafloor has no vertices");
  impl_->size_buckets(impl_->bounds, seafloor.faces.size());
  impl_->fill_faces();
  impl_->fill_vertices();
}

const Box2& DepthQuery::extent() const { return impl_->bounds; }

DepthQuery::~DepthQuery() = default;
DepthQuery::DepthQuery(DepthQuery&&) noexcept = default;
DepthQuery& DepthQuery::operator=(DepthQuery&&) noexcept = default;

namespace {

/// Height of a face's plane at p; empty if p does not lie in the face's plan.
std::optional<double> height_at(const Seafloor& seafloor, const Seafloor::Face& f, const Vec2& p) {
  const Vec3& a = seafloor.vertices[f[0]];
  const Vec3& b = seafloor.vertices[f[1]];
  const Vec3& c = seafloor.vertices[f[2]];
  const double twice_area = plan_cross(a, b, c);
  if (std::abs(twice_area) < kLeastPlanArea) return std::nullopt;
  const Vec3 q(p.x(), p.y(), 0.0);
  const double wa = plan_cross(q, b, c) / twice_area;
  const double wb = plan_cross(a, q, c) / twice_area;
  const double wc = 1.0 - wa - wb;
  if (std::min({wa, wb, wc}) < -kBarycentricTolerance) return std::nullopt;
  return wa * a.z() + wb * b.z() + wc * c.z();
}

}  // namespace

std::optional<std::uint32_t> DepthQuery::face(const Vec2& p) const {
  const Impl& d = *impl_;
  if (!p.allFinite()) return std::nullopt;
  const std::size_t b = d.bucket(d.column(p.x()), d.row(p.y()));
  std::optional<std::uint32_t> best;
  double best_z = -std::numeric_limits<double>::infinity();
  for (std::uint32_t k = d.start[b]; k < d.start[b + 1]; ++k) {
    const auto z = height_at(*d.seafloor, d.seafloor->faces[d.items[k]], p);
    if (z && *z > best_z) {
      best_z = *z;
      best = d.items[k];
    }
  }
  return best;
}

std::optional<double> DepthQuery::depth(const Vec2& p) const {
  const auto f = face(p);
  if (!f) return std::nullopt;
  const auto z = height_at(*impl_->seafloor, impl_->seafloor->faces[*f], p);
  return z ? std::optional<double>(-*z) : std::nullopt;
}

double DepthQuery::nearest_depth(const Vec2& p) const {
  const Impl& d = *impl_;
  const std::int64_t c0 = d.column(p.x());
  const std::int64_t r0 = d.row(p.y());
  double best = std::numeric_limits<double>::infinity();
  double z = 0.0;
  const auto visit = [&](std::int64_t c, std::int64_t r) {
    if (c < 0 || r < 0 || c >= d.columns || r >= d.rows) return;
    const std::size_t b = d.bucket(c, r);
    for (std::uint32_t k = d.vertex_start[b]; k < d.vertex_start[b + 1]; ++k) {
      const Vec3& v = d.seafloor->vertices[d.vertex_items[k]];
      const double distance = (v.head<2>() - p).squaredNorm();
      if (distance < best) {
        best = distance;
        z = v.z();
      }
    }
  };
  // Looks at rings of buckets around p until no nearer vertex can follow. A point outside the
  // extent is moved onto it first. Rings are measured from there, so the gap between both is added.
  const Vec2 clamped(
      std::clamp(p.x(), d.origin.x(), d.origin.x() + d.cell * static_cast<double>(d.columns)),
      std::clamp(p.y(), d.origin.y(), d.origin.y() + d.cell * static_cast<double>(d.rows)));
  const double gap = (clamped - p).norm();
  for (std::int64_t ring = 0; ring <= std::max(d.columns, d.rows); ++ring) {
    const double reach = static_cast<double>(ring - 1) * d.cell - gap;
    if (reach > 0.0 && reach * reach > best) break;
    for (std::int64_t k = -ring; k <= ring; ++k) {
      visit(c0 + k, r0 - ring);
      if (ring > 0) visit(c0 + k, r0 + ring);
      if (k > -ring && k < ring) {
        visit(c0 - ring, r0 + k);
        visit(c0 + ring, r0 + k);
      }
    }
  }
  return -z;
}

}  // namespace swathplan
