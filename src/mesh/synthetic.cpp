#include "mesh/synthetic.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "mesh/base/error.h"

namespace swathplan {
namespace {

/// Heights are rounded to this, metres. Else files would differ where exp() differs in its last
/// bit.
constexpr double kHeightStep = 1e-3;
/// Width of the near-vertical walls of shaft and step, metres. A height field cannot stand upright.
constexpr double kWallWidth = 0.1;

using Height = std::function<std::optional<double>(double, double)>;

std::vector<double> even(double from, double step, std::size_t count) {
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = from + step * static_cast<double>(i);
  return values;
}

/// Nodes at every (x, y) with a height. Two triangles fill the square between four of them; the
/// diagonal runs from south-west to north-east.
Seafloor height_field(const std::vector<double>& xs, const std::vector<double>& ys,
                      const Height& height) {
  Seafloor seafloor;
  constexpr std::uint32_t kNone = 0xFFFFFFFFU;
  std::vector<std::uint32_t> index(xs.size() * ys.size(), kNone);
  for (std::size_t j = 0; j < ys.size(); ++j) {
    for (std::size_t i = 0; i < xs.size(); ++i) {
      const auto z = height(xs[i], ys[j]);
      if (!z) continue;
      index[j * xs.size() + i] = static_cast<std::uint32_t>(seafloor.vertices.size());
      seafloor.vertices.emplace_back(xs[i], ys[j], std::round(*z / kHeightStep) * kHeightStep);
    }
  }
  for (std::size_t j = 0; j + 1 < ys.size(); ++j) {
    for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
      const std::uint32_t sw = index[j * xs.size() + i];
      const std::uint32_t se = index[j * xs.size() + i + 1];
      const std::uint32_t nw = index[(j + 1) * xs.size() + i];
      const std::uint32_t ne = index[(j + 1) * xs.size() + i + 1];
      if (sw == kNone || se == kNone || nw == kNone || ne == kNone) continue;
      seafloor.faces.push_back({sw, se, ne});
      seafloor.faces.push_back({sw, ne, nw});
    }
  }
  return seafloor;
}

/// 0 below `from`, 1 above `to`, smooth between.
double ramp(double from, double to, double v) {
  const double t = std::clamp((v - from) / (to - from), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/// A bell of height 1 and width sigma.
double bell(double x, double y, double cx, double cy, double sigma) {
  const double dx = (x - cx) / sigma;
  const double dy = (y - cy) / sigma;
  return std::exp(-0.5 * (dx * dx + dy * dy));
}

bool within(double v, double low, double high) { return v >= low && v <= high; }

/// Quays along three sides, two moles that leave an entrance, a pier between two basins, an island.
bool harbour_land(double x, double y) {
  const bool quay = y > 382.0 || (y > 118.0 && (x < 18.0 || x > 284.0));
  const bool west_mole = within(y, 118.0, 134.0) && x < 112.0;
  const bool east_mole = within(y, 118.0, 134.0) && x > 196.0;
  const bool pier = within(x, 138.0, 162.0) && y > 276.0;
  const bool island = std::hypot(x - 232.0, (y - 62.0) / 0.8) < 15.0;
  return quay || west_mole || east_mole || pier || island;
}

double harbour_depth(double x, double y) {
  // The open roadstead deepens to the south; inside the moles the natural bed is shallow.
  double depth = 7.0 + 19.0 * ramp(150.0, 0.0, y) * (0.75 + 0.25 * ramp(0.0, 150.0, x));
  depth += 0.6 * std::sin(x / 23.0) * std::sin(y / 31.0);
  // Dredged: the channel through the entrance up to a turning basin, and the berths in the east.
  const double channel_x = 154.0 + 10.0 * ramp(60.0, 200.0, y);
  const double channel = ramp(34.0, 20.0, std::abs(x - channel_x)) * ramp(262.0, 244.0, y);
  const double turning = ramp(56.0, 40.0, std::hypot(x - 190.0, y - 222.0));
  const double berth = ramp(206.0, 216.0, x) * ramp(206.0, 218.0, y) * ramp(366.0, 354.0, y);
  const double channel_depth = 14.0 + 12.0 * ramp(150.0, 10.0, y);
  depth += std::max(0.0, channel_depth - depth) * channel;
  depth += std::max(0.0, 14.0 - depth) * turning;
  depth += std::max(0.0, 12.0 - depth) * berth;
  // A shoal beside the approach, the island's foot, and silt in the north-west basin.
  depth -= 16.5 * bell(x, y, 66.0, 60.0, 22.0);
  depth -= (depth - 3.4) * ramp(34.0, 16.0, std::hypot(x - 232.0, (y - 62.0) / 0.8));
  depth -= 3.6 * ramp(110.0, 40.0, x) * ramp(290.0, 372.0, y);
  return std::clamp(depth, 3.0, 26.0);
}

/// A shelf that deepens to the south-west, with three shoals and a basin.
double sea_depth(double x, double y) {
  const double shelf = 195.3 - 70.0 * ramp(-2000.0, 11300.0, y) - 40.0 * ramp(-1500.0, 9000.0, x);
  const double shoals = 129.4 * bell(x, y, 4300.0, 3100.0, 900.0) +
                        62.0 * bell(x, y, 1700.0, 6100.0, 800.0) +
                        44.0 * bell(x, y, 6000.0, 7300.0, 950.0);
  return shelf - shoals + 21.1 * bell(x, y, 1200.0, 1500.0, 1300.0);
}

void check_size(double width, double height, double depth) {
  if (!(width > 0.0 && height > 0.0 && depth > 0.0)) {
    throw UsageError("width, height and depth must be above 0 metres");
  }
}

/// Node spacing of the plain shapes: 1 m, or coarser so that no more than 250,000 nodes arise.
std::vector<double> nodes(double length, double other) {
  constexpr double kMostNodes = 250000.0;
  const double step = std::max(1.0, std::sqrt(length * other / kMostNodes));
  const auto count = static_cast<std::size_t>(std::max(1.0, std::round(length / step)));
  return even(0.0, length / static_cast<double>(count), count + 1);
}

}  // namespace

Seafloor saddle() {
  const auto axis = even(-40.0, 1.0, 81);
  return height_field(axis, axis, [](double x, double y) { return (x * x - y * y) / 64.0 - 35.0; });
}

Seafloor shaft() {
  std::vector<double> axis;
  for (const double v : even(-50.0, 2.5, 13)) axis.push_back(v);
  for (const double v : even(-20.0 + kWallWidth, 1.0, 1)) axis.push_back(v);
  for (const double v : even(-17.5, 2.5, 15)) axis.push_back(v);
  axis.push_back(20.0 - kWallWidth);
  for (const double v : even(20.0, 2.5, 13)) axis.push_back(v);
  return height_field(axis, axis, [](double x, double y) {
    const bool pit = std::max(std::abs(x), std::abs(y)) < 20.0;
    return pit ? -45.0 : -10.0;
  });
}

Seafloor harbour() {
  return height_field(even(0.0, 2.0, 151), even(0.0, 2.0, 201),
                      [](double x, double y) -> std::optional<double> {
                        if (harbour_land(x, y)) return std::nullopt;
                        return -harbour_depth(x, y);
                      });
}

Seafloor sea() {
  return height_field(even(0.0, 50.0, 149), even(0.0, 50.0, 187),
                      [](double x, double y) { return -sea_depth(x, y); });
}

Seafloor flat(double width, double height, double depth) {
  check_size(width, height, depth);
  return height_field(nodes(width, height), nodes(height, width),
                      [=](double, double) { return -depth; });
}

Seafloor tilted(double width, double height, double depth, Angle slope) {
  check_size(width, height, depth);
  if (!(slope.deg() >= 0.0 && slope.deg() <= 89.0)) {
    throw UsageError("the slope must lie in [0, 89] degrees");
  }
  const double rise = tan(slope);
  return height_field(nodes(width, height), nodes(height, width),
                      [=](double x, double) { return -depth - rise * x; });
}

Seafloor stepped(double width, double height, double depth_west, double depth_east) {
  check_size(width, height, std::min(depth_west, depth_east));
  auto xs = nodes(width, height);
  std::erase_if(xs, [&](double x) { return std::abs(x - 0.5 * width) <= kWallWidth; });
  xs.push_back(0.5 * width);
  xs.push_back(0.5 * width + std::min(kWallWidth, 0.25 * width));
  std::sort(xs.begin(), xs.end());
  return height_field(xs, nodes(height, width), [=](double x, double) {
    return x <= 0.5 * width ? -depth_west : -depth_east;
  });
}

}  // namespace swathplan
