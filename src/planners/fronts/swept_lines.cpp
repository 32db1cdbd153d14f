#include "planners/fronts/swept_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>

#include "mesh/base/parallel.h"
#include "planners/fronts/field_lines.h"

namespace swathplan {
namespace {

/// Less water than this below the sonar counts as this, metres.
constexpr double kLeastWaterBelow = 0.05;
/// A beam that has not met the floor after this many half swaths never will, since the slope is
/// steeper than the beam.
constexpr double kFarthest = 8.0;
/// Cell centres this near to the rim of a swath count as swept, metres. It allows for rounding.
constexpr double kOnRim = 1e-6;

/// Gives cells without a value that of the nearest cell with one.
void fill_from_nearest(const WaterRaster& raster, std::vector<float>& values,
                       std::vector<char>& known) {
  std::queue<std::size_t> next;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (known[i] != 0) next.push(i);
  }
  const auto columns = static_cast<std::ptrdiff_t>(raster.columns());
  while (!next.empty()) {
    const std::size_t i = next.front();
    next.pop();
    const auto c = static_cast<std::ptrdiff_t>(i) % columns;
    for (const std::ptrdiff_t step : {-columns, std::ptrdiff_t{-1}, std::ptrdiff_t{1}, columns}) {
      const std::ptrdiff_t n = static_cast<std::ptrdiff_t>(i) + step;
      const bool wraps = std::abs(step) == 1 && (c + step < 0 || c + step >= columns);
      if (wraps || n < 0 || n >= static_cast<std::ptrdiff_t>(values.size())) continue;
      const auto to = static_cast<std::size_t>(n);
      if (known[to] != 0) continue;
      known[to] = 1;
      values[to] = values[i];
      next.push(to);
    }
  }
}

/// Calls f(cell) for the cells of the area whose centres lie in the triangle.
template <class F>
void cells_in(const WaterRaster& raster, const std::array<Vec2, 3>& t, const F& f) {
  const Vec2 origin = raster.centre(0);
  const double cell = raster.cell_m();
  const double low = std::min({t[0].y(), t[1].y(), t[2].y()}) - kOnRim;
  const double high = std::max({t[0].y(), t[1].y(), t[2].y()}) + kOnRim;
  const double last_row = static_cast<double>(raster.rows()) - 1.0;
  const double r0 = std::max(0.0, std::ceil((low - origin.y()) / cell));
  const double r1 = std::min(last_row, std::floor((high - origin.y()) / cell));
  for (double r = r0; r <= r1; r += 1.0) {
    const double y = origin.y() + r * cell;
    double left = 1e300;
    double right = -1e300;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2& a = t[k];
      const Vec2& b = t[(k + 1) % 3];
      const double from = std::min(a.y(), b.y());
      const double to = std::max(a.y(), b.y());
      if (y < from - kOnRim || y > to + kOnRim) continue;
      const double rise = b.y() - a.y();
      const double share = std::abs(rise) < kOnRim ? 0.0 : std::clamp((y - a.y()) / rise, 0.0, 1.0);
      const double x = a.x() + share * (b.x() - a.x());
      left = std::min({left, x, std::abs(rise) < kOnRim ? b.x() : x});
      right = std::max({right, x, std::abs(rise) < kOnRim ? b.x() : x});
    }
    const double c0 = std::max(0.0, std::ceil((left - kOnRim - origin.x()) / cell));
    const double c1 = std::min(static_cast<double>(raster.columns()) - 1.0,
                               std::floor((right + kOnRim - origin.x()) / cell));
    for (double c = c0; c <= c1; c += 1.0) {
      const auto i = static_cast<std::size_t>(r) * raster.columns() + static_cast<std::size_t>(c);
      if (raster.in_area(i)) f(static_cast<std::uint32_t>(i));
    }
  }
}

/// Unit course at each point: along the chord over its neighbours.
Vec2 course_at(const std::vector<Vec2>& p, std::size_t i) {
  return (p[std::min(i + 1, p.size() - 1)] - p[i > 0 ? i - 1 : 0]).normalized();
}

void add_cells(const SweptGround& ground, std::size_t step, SweptLine& line) {
  const auto first = static_cast<std::ptrdiff_t>(line.cells.size());
  const auto add = [&](std::uint32_t cell) { line.cells.push_back(cell); };
  for (const std::vector<Vec2>* side : {&line.port, &line.starboard}) {
    const Vec2& a = line.points[step];
    const Vec2& b = line.points[step + 1];
    cells_in(ground.raster(), {a, b, (*side)[step + 1]}, add);
    cells_in(ground.raster(), {a, (*side)[step], (*side)[step + 1]}, add);
  }
  std::sort(line.cells.begin() + first, line.cells.end());
  line.cells.erase(std::unique(line.cells.begin() + first, line.cells.end()), line.cells.end());
  line.first_cell.push_back(line.cells.size());
}

}  // namespace

SweptGround::SweptGround(const WaterRaster& raster, const std::vector<float>& width, double draft_m)
    : raster_(raster), width_(width), below_(raster.size()), tangent_(raster.size()) {
  std::vector<char> known(raster.size(), 0);
  for (std::size_t i = 0; i < raster.size(); ++i) {
    if (!raster.in_area(i)) continue;
    known[i] = 1;
    const double below = std::max(raster.depth(i) - draft_m, kLeastWaterBelow);
    below_[i] = static_cast<float>(below);
    tangent_[i] = static_cast<float>(0.5 * static_cast<double>(width[i]) / below);
  }
  std::vector<char> again = known;
  fill_from_nearest(raster, below_, known);
  fill_from_nearest(raster, tangent_, again);
}

double SweptGround::between(const std::vector<float>& values, const Vec2& p) const {
  const Vec2 at = (p - raster_.centre(0)) / raster_.cell_m();
  const double x = std::clamp(at.x(), 0.0, static_cast<double>(raster_.columns()) - 1.001);
  const double y = std::clamp(at.y(), 0.0, static_cast<double>(raster_.rows()) - 1.001);
  const auto c = static_cast<std::size_t>(x);
  const auto r = static_cast<std::size_t>(y);
  const double s = x - static_cast<double>(c);
  const double t = y - static_cast<double>(r);
  const std::size_t i = r * raster_.columns() + c;
  const auto v = [&](std::size_t k) { return static_cast<double>(values[k]); };
  return (1.0 - t) * ((1.0 - s) * v(i) + s * v(i + 1)) +
         t * ((1.0 - s) * v(i + raster_.columns()) + s * v(i + raster_.columns() + 1));
}

double SweptGround::reach_m(const Vec2& p, const Vec2& side) const {
  const double tangent = between(tangent_, p);
  const double half = tangent * below_m(p);
  const double step = std::min(raster_.cell_m(), 0.25 * half);
  double before = -half;
  bool entered = false;
  for (double y = step; y < kFarthest * half; y += step) {
    const Vec2 at = p + y * side;
    const auto cell = raster_.cell_at(at);
    const bool in = cell && raster_.in_area(*cell);
    if (entered && !in) return y;
    entered = entered || in;
    // How far the beam is past the floor, in metres along the horizontal.
    const double past = y - tangent * below_m(at);
    if (past >= 0.0) return y - step * past / (past - before);
    before = past;
  }
  return kFarthest * half;
}

std::vector<float> opening_width(const WaterRaster& raster, Angle opening, double draft_m) {
  std::vector<float> widths(raster.size(), 0.0F);
  const double share = 2.0 * std::tan(0.5 * opening.rad());
  for (std::size_t i = 0; i < raster.size(); ++i) {
    if (!raster.in_area(i)) continue;
    widths[i] = static_cast<float>(share * std::max(raster.depth(i) - draft_m, kLeastWaterBelow));
  }
  return widths;
}

SweptLine swept(const SurveyCurve& line, const SweptGround& ground) {
  SweptLine result;
  result.points = resampled(line, kSweepStepOfCell * ground.raster().cell_m()).points;
  result.first_cell.push_back(0);
  if (result.points.size() < 2) {
    result.points.clear();
    return result;
  }
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    const Vec2& p = result.points[i];
    const Vec2 course = course_at(result.points, i);
    const Vec2 right(course.y(), -course.x());
    result.starboard.push_back(p + ground.reach_m(p, right) * right);
    result.port.push_back(p - ground.reach_m(p, -right) * right);
  }
  for (std::size_t k = 0; k < result.steps(); ++k) add_cells(ground, k, result);
  return result;
}

std::vector<SweptLine> swept(const std::vector<SurveyCurve>& lines, const SweptGround& ground) {
  std::vector<SweptLine> result(lines.size());
  for_each_index(std::size_t{0}, lines.size(),
                 [&](std::size_t k) { result[k] = swept(lines[k], ground); });
  std::erase_if(result, [](const SweptLine& line) { return line.steps() == 0; });
  return result;
}

SurveyCurve carried_on(SurveyCurve curve, double share, const SweptGround& ground,
                       const AreaQuery& lines_in) {
  auto& p = curve.points;
  if (!(share > 0.0) || p.size() < 2 || is_closed(curve)) return curve;
  // The course comes from the last few points. From two alone it would be rough.
  const std::size_t back = std::min<std::size_t>(3, p.size() - 1);
  const auto end = [&](const Vec2& at, const Vec2& behind) {
    const Vec2 on = at + share * ground.width_m(at) * (at - behind).normalized();
    const auto parts = lines_in.clip(at, on);
    return parts.empty() || parts[0].first > 1e-6 ? at : Vec2(at + parts[0].second * (on - at));
  };
  const Vec2 first = end(p.front(), p[back]);
  const Vec2 last = end(p.back(), p[p.size() - 1 - back]);
  if (first != p.front()) p.insert(p.begin(), first);
  if (last != p.back()) p.push_back(last);
  return curve;
}

LinesFigures judge_lines(const std::vector<SweptLine>& lines, const SweptGround& ground) {
  const WaterRaster& raster = ground.raster();
  LinesFigures figures;
  figures.lines = lines.size();
  figures.least_m = least_line_m(raster, ground.width());
  std::vector<std::uint32_t> last(raster.size(), 0);
  std::size_t swept_cells = 0;
  std::size_t visits = 0;
  std::uint32_t number = 0;
  for (const SweptLine& line : lines) {
    ++number;
    figures.length_m += length_m(SurveyCurve{line.points});
    for (const std::uint32_t cell : line.cells) {
      if (last[cell] == 0) ++swept_cells;
      if (last[cell] != number) ++visits;
      last[cell] = number;
    }
  }
  std::size_t cells = 0;
  for (std::size_t i = 0; i < raster.size(); ++i) cells += raster.in_area(i) ? 1 : 0;
  if (cells > 0) {
    figures.missed = 1.0 - static_cast<double>(swept_cells) / static_cast<double>(cells);
  }
  if (swept_cells > 0) {
    figures.overlap = static_cast<double>(visits) / static_cast<double>(swept_cells) - 1.0;
  }
  return figures;
}

namespace {

/// How many steps of any line sweep each cell.
class StepCounts {
 public:
  StepCounts(const std::vector<SweptLine>& lines, std::size_t cells) : counts_(cells, 0) {
    for (const SweptLine& line : lines) {
      for (const std::uint32_t cell : line.cells) ++counts_[cell];
    }
  }
  /// Takes a step away. Returns how many cells no line sweeps any more.
  std::size_t take(const SweptLine& line, std::size_t step) {
    std::size_t lost = 0;
    for (std::size_t k = line.first_cell[step]; k < line.first_cell[step + 1]; ++k) {
      if (--counts_[line.cells[k]] == 0) ++lost;
    }
    return lost;
  }
  void put(const SweptLine& line, std::size_t step) {
    for (std::size_t k = line.first_cell[step]; k < line.first_cell[step + 1]; ++k) {
      ++counts_[line.cells[k]];
    }
  }

 private:
  std::vector<std::uint32_t> counts_;
};

/// The part of the line from step `begin` up to step `end`.
SweptLine part(const SweptLine& line, std::size_t begin, std::size_t end) {
  SweptLine result;
  result.first_cell.push_back(0);
  if (begin >= end) return result;
  const auto cut = [&](const std::vector<Vec2>& v) {
    return std::vector<Vec2>(v.begin() + static_cast<std::ptrdiff_t>(begin),
                             v.begin() + static_cast<std::ptrdiff_t>(end) + 1);
  };
  result.points = cut(line.points);
  result.port = cut(line.port);
  result.starboard = cut(line.starboard);
  const std::size_t first = line.first_cell[begin];
  result.cells.assign(line.cells.begin() + static_cast<std::ptrdiff_t>(first),
                      line.cells.begin() + static_cast<std::ptrdiff_t>(line.first_cell[end]));
  for (std::size_t k = begin; k < end; ++k)
    result.first_cell.push_back(line.first_cell[k + 1] - first);
  return result;
}

/// The longest run of steps from one end that is not worth sailing. It is taken out of `counts`.
std::size_t poor_steps(const SweptLine& line, bool from_back, std::size_t begin, std::size_t end,
                       const SweptGround& ground, double gain, StepCounts& counts) {
  const double cell_m2 = ground.raster().cell_m() * ground.raster().cell_m();
  double metres = 0.0;
  double lost_m2 = 0.0;
  std::size_t poor = 0;
  std::size_t looked = 0;
  const auto step_at = [&](std::size_t k) { return from_back ? end - 1 - k : begin + k; };
  const double w = begin < end ? ground.width_m(line.points[from_back ? end : begin]) : 0.0;
  while (looked < end - begin) {
    const std::size_t step = step_at(looked);
    lost_m2 += cell_m2 * static_cast<double>(counts.take(line, step));
    metres += (line.points[step + 1] - line.points[step]).norm();
    ++looked;
    if (lost_m2 <= gain * w * metres) poor = looked;
    // Even a whole swath more of steps that lose nothing could not make up for this loss.
    if (lost_m2 > gain * w * (metres + w)) break;
  }
  while (looked > poor) counts.put(line, step_at(--looked));
  return poor;
}

}  // namespace

void trim_ends(std::vector<SweptLine>& lines, const SweptGround& ground, double gain) {
  StepCounts counts(lines, ground.raster().size());
  for (SweptLine& line : lines) {
    const std::size_t front = poor_steps(line, false, 0, line.steps(), ground, gain, counts);
    const std::size_t back = poor_steps(line, true, front, line.steps(), ground, gain, counts);
    if (front + back > 0) line = part(line, front, line.steps() - back);
  }
  std::erase_if(lines, [](const SweptLine& line) { return line.steps() == 0; });
}

}  // namespace swathplan
