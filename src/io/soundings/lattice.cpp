#include "io/soundings/lattice.h"

#include <algorithm>
#include <cmath>

#include "io/grids/grid_import.h"

namespace swathplan {
namespace {

constexpr double kStepTolerance = 0.05;  ///< share of a step; text files round coordinates
constexpr double kSparsest = 16.0;       ///< places per point; a lattice has no more
constexpr double kJoinedShare = 0.8;     ///< at least this share has a neighbour along both axes

struct Axis {
  double first = 0.0, step = 0.0;
  std::size_t count = 0;
  [[nodiscard]] double place(double value) const { return (value - first) / step; }
};

/// The axis on which all values lie at equal steps; count 0 if there is none.
Axis find_axis(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  if (values.size() < 2) return {};
  std::vector<double> gaps;
  for (std::size_t i = 1; i < values.size(); ++i) gaps.push_back(values[i] - values[i - 1]);
  std::vector<double> sorted = gaps;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  double steps = 0.0;
  for (const double gap : gaps) steps += std::round(gap / *middle);
  if (!(steps >= 1.0) || steps > 1e7) return {};
  Axis axis{values.front(), (values.back() - values.front()) / steps,
            static_cast<std::size_t>(steps) + 1};
  const bool regular = std::all_of(values.begin(), values.end(), [&](double v) {
    return std::abs(axis.place(v) - std::round(axis.place(v))) <= kStepTolerance;
  });
  return regular ? axis : Axis{};
}

double joined_share(const std::vector<std::uint32_t>& node, std::size_t columns, std::size_t n) {
  const auto has = [&](std::size_t at) { return at < node.size() && node[at] != kNoNode; };
  std::size_t joined = 0;
  for (std::size_t at = 0; at < node.size(); ++at) {
    if (!has(at)) continue;
    const bool beside =
        (at % columns > 0 && has(at - 1)) || ((at + 1) % columns > 0 && has(at + 1));
    const bool above = has(at + columns) || (at >= columns && has(at - columns));
    joined += beside && above ? 1 : 0;
  }
  return static_cast<double>(joined) / static_cast<double>(n);
}

}  // namespace

bool join_lattice(SurfaceData& points) {
  std::vector<double> xs;
  std::vector<double> ys;
  for (const Vec3& v : points.vertices) {
    xs.push_back(v.x());
    ys.push_back(v.y());
  }
  const Axis x = find_axis(std::move(xs));
  const Axis y = find_axis(std::move(ys));
  const auto n = static_cast<double>(points.vertices.size());
  if (x.count < 2 || y.count < 2) return false;
  if (static_cast<double>(x.count) * static_cast<double>(y.count) > kSparsest * n) return false;
  std::vector<std::uint32_t> node(x.count * y.count, kNoNode);
  for (std::uint32_t v = 0; v < points.vertices.size(); ++v) {
    const Vec3& p = points.vertices[v];
    const auto i = static_cast<std::size_t>(std::llround(x.place(p.x())));
    const auto j = static_cast<std::size_t>(std::llround(y.place(p.y())));
    std::uint32_t& place = node[j * x.count + i];
    if (place != kNoNode) return false;
    place = v;
  }
  if (joined_share(node, x.count, points.vertices.size()) < kJoinedShare) return false;
  points.faces = lattice_faces(node, x.count);
  points.is_clean = !points.faces.empty();
  points.spacing = std::sqrt(x.step * y.step);
  return points.is_clean;
}

}  // namespace swathplan
