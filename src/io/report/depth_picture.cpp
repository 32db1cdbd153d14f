#include <algorithm>
#include <cmath>
#include <limits>

#include "io/pictures/scale_bar.h"
#include "io/report/pictures_internal.h"

namespace swathplan::internal {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// How much deeper it gets per metre to the east and to the south.
Vec2 gradient(const DepthField& field, std::uint32_t c, std::uint32_t r) {
  const double here = field.at(c, r);
  const auto along = [&](double before, double after) {
    const double from = std::isnan(before) ? here : before, to = std::isnan(after) ? here : after;
    const int pixels = (std::isnan(before) ? 0 : 1) + (std::isnan(after) ? 0 : 1);
    return pixels > 0 ? (to - from) / (pixels * field.pixel_m) : 0.0;
  };
  return {along(field.at(c - 1, r), field.at(c + 1, r)),
          along(field.at(c, r - 1), field.at(c, r + 1))};
}

/// The shade of a pixel, from 0 (dark) to kDepthShades - 2 (bright). The light comes from the
/// north-west, 45 degrees up.
int shade_at(const DepthField& field, std::uint32_t c, std::uint32_t r, double exaggeration) {
  // Depth is positive down, so the normal of the seafloor leans to where it gets deeper.
  const Vec2 lean = exaggeration * gradient(field, c, r);
  const double east = lean.x(), south = lean.y();
  const double light =
      (-0.5 * east - 0.5 * south + std::sqrt(0.5)) / std::sqrt(1.0 + east * east + south * south);
  constexpr int kLast = kDepthShades - 2;
  return std::clamp(static_cast<int>(std::lround(2.0 + 4.0 * (light - std::sqrt(0.5)))), 0, kLast);
}

bool on_isobath(const DepthField& field, std::uint32_t c, std::uint32_t r, double interval) {
  // Ground that is level at an isobath's depth lies to its one side, whatever rounding says.
  constexpr double kRounding = 1e-3;
  const auto step = [&](double depth) { return std::floor((depth + kRounding) / interval); };
  const double here = step(field.at(c, r));
  const double right = field.at(c + 1, r), below = field.at(c, r + 1);
  return (!std::isnan(right) && step(right) != here) || (!std::isnan(below) && step(below) != here);
}

std::vector<Rgba> depth_palette() {
  const std::vector<Rgba> ramp{{244, 240, 208, 255}, {196, 226, 203, 255}, {138, 202, 203, 255},
                               {94, 165, 197, 255},  {74, 124, 178, 255},  {66, 86, 146, 255}};
  constexpr double kLight[kDepthShades] = {-0.20, -0.10, 0.0, 0.10, 0.20, -0.34};
  std::vector<Rgba> palette{{0, 0, 0, 0}};
  for (int level = 0; level < kDepthLevels; ++level) {
    const Rgba base = blend(ramp, static_cast<double>(level) / (kDepthLevels - 1));
    for (const double light : kLight) {
      const Rgba towards = light < 0 ? Rgba{20, 30, 50, 255} : Rgba{255, 255, 255, 255};
      palette.push_back(blend({base, towards}, std::abs(light)));
    }
  }
  return palette;
}

Box2 box_of(const DepthField& field) {
  Box2 box;
  box.extend(field.corner);
  box.extend(field.corner + field.pixel_m * Vec2(field.columns, -double(field.rows)));
  return box;
}

std::vector<Rgba> slope_palette() {
  const std::vector<Rgba> ramp{{247, 247, 240, 255},
                               {253, 216, 140, 255},
                               {239, 138, 72, 255},
                               {178, 50, 80, 255},
                               {72, 20, 90, 255}};
  std::vector<Rgba> palette{{0, 0, 0, 0}};
  for (int level = 0; level < kSlopeLevels; ++level) {
    palette.push_back(blend(ramp, static_cast<double>(level) / (kSlopeLevels - 1)));
  }
  return palette;
}

void range_of(const DepthField& field, DepthPicture& out) {
  out.min_m = std::numeric_limits<double>::max();
  out.max_m = std::numeric_limits<double>::lowest();
  for (const double depth : field.depth) {
    if (std::isnan(depth)) continue;
    out.min_m = std::min(out.min_m, depth);
    out.max_m = std::max(out.max_m, depth);
  }
  if (out.min_m > out.max_m) out.min_m = out.max_m = 0.0;
}

}  // namespace

double DepthField::at(std::uint32_t c, std::uint32_t r) const {
  return c < columns && r < rows ? depth[std::size_t{r} * columns + c] : kNone;
}

DepthField depth_field(const DepthQuery& depths, const Box2& box, std::uint32_t largest_side) {
  DepthField field;
  field.pixel_m = box.size().maxCoeff() / largest_side;
  field.corner = {box.min.x(), box.max.y()};
  const auto pixels = [&](double metres) {
    return std::max(1U, static_cast<std::uint32_t>(std::ceil(metres / field.pixel_m - 1e-9)));
  };
  field.columns = pixels(box.size().x());
  field.rows = pixels(box.size().y());
  field.depth.reserve(std::size_t{field.columns} * field.rows);
  for (std::uint32_t r = 0; r < field.rows; ++r) {
    for (std::uint32_t c = 0; c < field.columns; ++c) {
      const Vec2 p = field.corner + field.pixel_m * Vec2(c + 0.5, -(r + 0.5));
      field.depth.push_back(depths.depth(p).value_or(kNone));
    }
  }
  return field;
}

DepthPicture depth_picture(const DepthField& field) {
  DepthPicture out;
  range_of(field, out);
  const double range = out.max_m - out.min_m;
  out.isobath_m = range > 0.01 ? round_length(range / 5.0) : 1.0;
  out.box = box_of(field);
  out.picture = {.columns = field.columns,
                 .rows = field.rows,
                 .pixels = std::vector<std::uint8_t>(field.depth.size()),
                 .palette = depth_palette()};
  // The relief is drawn 0.15 times as high as the map is wide. That is easy to read for all depths.
  const double exaggeration = range > 0.01 ? 0.15 * out.box.size().maxCoeff() / range : 1.0;
  for (std::uint32_t r = 0; r < field.rows; ++r) {
    for (std::uint32_t c = 0; c < field.columns; ++c) {
      const double depth = field.at(c, r);
      if (std::isnan(depth)) continue;
      const double share = range > 0.0 ? (depth - out.min_m) / range : 0.0;
      const int level = std::min(static_cast<int>(share * kDepthLevels), kDepthLevels - 1);
      const int shade = on_isobath(field, c, r, out.isobath_m)
                            ? kDepthShades - 1
                            : shade_at(field, c, r, exaggeration);
      out.picture.pixels[std::size_t{r} * field.columns + c] =
          static_cast<std::uint8_t>(1 + level * kDepthShades + shade);
    }
  }
  return out;
}

SlopePicture slope_picture(const DepthField& field) {
  SlopePicture out;
  out.box = box_of(field);
  out.picture = {.columns = field.columns,
                 .rows = field.rows,
                 .pixels = std::vector<std::uint8_t>(field.depth.size()),
                 .palette = slope_palette()};
  for (std::uint32_t r = 0; r < field.rows; ++r) {
    for (std::uint32_t c = 0; c < field.columns; ++c) {
      if (std::isnan(field.at(c, r))) continue;
      const double steep = Angle::radians(std::atan(gradient(field, c, r).norm())).deg();
      const int level = std::min(static_cast<int>(steep / kSlopeStepDeg), kSlopeLevels - 1);
      out.picture.pixels[std::size_t{r} * field.columns + c] = static_cast<std::uint8_t>(1 + level);
    }
  }
  return out;
}

}  // namespace swathplan::internal
