#include "coverage/standards/judged_gaps.h"

#include <algorithm>
#include <cmath>

namespace swathplan {

namespace {

// Number of cells of `mask` in all rectangles from the lower-left corner, with a margin of zeros.
std::vector<std::uint32_t> rectangle_sums(const CellMask& mask, const JudgedGrid& grid) {
  const std::size_t wide = grid.columns + 1U;
  std::vector<std::uint32_t> sums(wide * (grid.rows + 1U), 0);
  for (std::size_t r = 0; r < grid.rows; ++r) {
    std::uint32_t row = 0;
    for (std::size_t c = 0; c < grid.columns; ++c) {
      row += mask[r * grid.columns + c];
      sums[(r + 1) * wide + c + 1] = sums[r * wide + c + 1] + row;
    }
  }
  return sums;
}

// Cells of full rectangles of `width` x `height`.
void mark_full(const CellMask& mask, const std::vector<std::uint32_t>& sums, const JudgedGrid& grid,
               std::size_t width, std::size_t height, CellMask& marked) {
  const std::size_t wide = grid.columns + 1U;
  const auto full = static_cast<std::uint32_t>(width * height);
  for (std::size_t r = 0; r + height <= grid.rows; ++r) {
    for (std::size_t c = 0; c + width <= grid.columns; ++c) {
      if (mask[r * grid.columns + c] == 0) continue;
      const std::uint32_t count = sums[(r + height) * wide + c + width] -
                                  sums[r * wide + c + width] - sums[(r + height) * wide + c] +
                                  sums[r * wide + c];
      if (count != full) continue;
      for (std::size_t k = r; k < r + height; ++k) {
        const auto first = marked.begin() + static_cast<std::ptrdiff_t>(k * grid.columns + c);
        std::fill(first, first + static_cast<std::ptrdiff_t>(width), std::uint8_t{1});
      }
    }
  }
}

// Lower envelope of parabolas over one line: squared distances in, squared distances out.
class ParabolaLine {
 public:
  explicit ParabolaLine(std::size_t longest) : at_(longest), from_(longest + 1), out_(longest) {}

  void run(float* values, std::size_t n, std::size_t stride) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double height = values[i * stride];
      if (std::isinf(height)) continue;
      double start = -std::numeric_limits<double>::infinity();
      while (count > 0) {
        start = meeting(values, stride, at_[count - 1], i);
        if (start > from_[count - 1]) break;
        --count;
      }
      from_[count] = count == 0 ? -std::numeric_limits<double>::infinity() : start;
      at_[count++] = i;
    }
    if (count == 0) return;
    std::size_t k = 0;
    for (std::size_t i = 0; i < n; ++i) {
      while (k + 1 < count && from_[k + 1] < static_cast<double>(i)) ++k;
      const double d = static_cast<double>(i) - static_cast<double>(at_[k]);
      out_[i] = static_cast<float>(d * d) + values[at_[k] * stride];
    }
    for (std::size_t i = 0; i < n; ++i) values[i * stride] = out_[i];
  }

 private:
  static double meeting(const float* values, std::size_t stride, std::size_t a, std::size_t b) {
    const auto x = static_cast<double>(a);
    const auto y = static_cast<double>(b);
    return ((values[b * stride] + y * y) - (values[a * stride] + x * x)) / (2.0 * (y - x));
  }

  std::vector<std::size_t> at_;
  std::vector<double> from_;
  std::vector<float> out_;
};

// The cells of one place, from one of them.
class PlaceFlood {
 public:
  PlaceFlood(const CellMask& failing, const JudgedGrid& grid) : grid_(grid), left_(failing) {}

  [[nodiscard]] bool open(std::size_t i) const { return left_[i] != 0; }

  FailingPlace flood(std::size_t start) {
    cells_.assign(1, start);
    left_[start] = 0;
    Vec2 sum = Vec2::Zero();
    for (std::size_t k = 0; k < cells_.size(); ++k) {
      const std::size_t i = cells_[k];
      sum += grid_.centre(i);
      const std::size_t column = i % grid_.columns;
      if (column > 0) take(i - 1);
      if (column + 1 < grid_.columns) take(i + 1);
      if (i >= grid_.columns) take(i - grid_.columns);
      if (i + grid_.columns < left_.size()) take(i + grid_.columns);
    }
    const auto n = static_cast<double>(cells_.size());
    return {nearest(sum / n), n * grid_.cell_m * grid_.cell_m};
  }

 private:
  void take(std::size_t i) {
    if (left_[i] == 0) return;
    left_[i] = 0;
    cells_.push_back(i);
  }

  [[nodiscard]] Vec2 nearest(const Vec2& mean) const {
    const auto best = std::min_element(cells_.begin(), cells_.end(), [&](auto a, auto b) {
      return std::pair((grid_.centre(a) - mean).squaredNorm(), a) <
             std::pair((grid_.centre(b) - mean).squaredNorm(), b);
    });
    return grid_.centre(*best);
  }

  const JudgedGrid& grid_;
  CellMask left_;
  std::vector<std::size_t> cells_;
};

template <class Test>
CellMask asked_cells(const JudgedGrid& grid, Test test) {
  CellMask mask(grid.cells.size(), 0);
  for (std::size_t i = 0; i < mask.size(); ++i) {
    mask[i] = grid.cells[i].asked && test(grid.cells[i]) ? 1 : 0;
  }
  return mask;
}

}  // namespace

CellMask gaps_in(const Criterion& criterion, const JudgedGrid& grid) {
  if (criterion.gap == GapRule::spread) return CellMask(grid.cells.size(), 0);
  const int lines = lines_asked(criterion);
  const CellMask lacking = asked_cells(grid, [&](const auto& c) { return c.lines < lines; });
  return criterion.gap == GapRule::row ? in_rows(lacking, grid, criterion.gap_cells)
                                       : in_boxes(lacking, grid, criterion.gap_cells);
}

CellMask missed_cubes(const Criterion& criterion, const JudgedGrid& grid) {
  if (!criterion.features) return CellMask(grid.cells.size(), 0);
  const FeatureRule& rule = *criterion.features;
  return in_boxes(asked_cells(grid,
                              [&](const JudgedCell& c) {
                                return c.accepted > 0 &&
                                       (c.feature_pings < static_cast<float>(rule.pings) ||
                                        c.feature_beams < static_cast<float>(rule.beams));
                              }),
                  grid, criterion.gap_cells);
}

CellMask in_boxes(const CellMask& lacking, const JudgedGrid& grid, int side) {
  CellMask marked(lacking.size(), 0);
  const auto n = static_cast<std::size_t>(side);
  mark_full(lacking, rectangle_sums(lacking, grid), grid, n, n, marked);
  return marked;
}

CellMask in_rows(const CellMask& lacking, const JudgedGrid& grid, int length) {
  CellMask marked(lacking.size(), 0);
  const std::vector<std::uint32_t> sums = rectangle_sums(lacking, grid);
  const auto n = static_cast<std::size_t>(length);
  mark_full(lacking, sums, grid, n, 1, marked);
  mark_full(lacking, sums, grid, 1, n, marked);
  return marked;
}

std::vector<float> distance_in_cells(const CellMask& seen, const JudgedGrid& grid) {
  std::vector<float> distance(seen.size(), std::numeric_limits<float>::infinity());
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i] != 0) distance[i] = 0.0F;
  }
  ParabolaLine line(std::max(grid.columns, grid.rows));
  for (std::size_t r = 0; r < grid.rows; ++r) {
    line.run(distance.data() + r * grid.columns, grid.columns, 1);
  }
  for (std::size_t c = 0; c < grid.columns; ++c) {
    line.run(distance.data() + c, grid.rows, grid.columns);
  }
  for (float& d : distance) d = std::sqrt(d);
  return distance;
}

std::vector<FailingPlace> places_of(const CellMask& failing, const JudgedGrid& grid) {
  std::vector<FailingPlace> places;
  PlaceFlood flood(failing, grid);
  for (std::size_t i = 0; i < failing.size(); ++i) {
    if (flood.open(i)) places.push_back(flood.flood(i));
  }
  std::stable_sort(places.begin(), places.end(),
                   [](const auto& a, const auto& b) { return a.area_m2 > b.area_m2; });
  return places;
}

}  // namespace swathplan
