#include "planners/adaptive/cost_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "mesh/base/error.h"
#include "mesh/base/require.h"

namespace swathplan {
namespace {

// The bottom's own level is the mean over this much of the image around a pixel.
constexpr double kLevelAlong = 30.0;
constexpr double kLevelAcross = 2.0;
// Speckle is averaged over a third of the window before contrasts are measured.
constexpr double kSmoothShare = 1.0 / 3.0;
// Variation is compared with its mean over this much around. Five times the mean costs 1.
constexpr double kSurroundings = 12.0;
constexpr double kFullCost = 4.0;
// Contrasts below a twentieth of the mean return do not count, even in an image without speckle.
constexpr double kLeastVariation = 0.05;
// The height above the bottom that costs 1 in the nadir gap, and the square of its local mean.
constexpr double kNadirHeight = 0.35;
constexpr double kNadirMean = 5.0;

void check(const CostMapOptions& o) {
  require(o.window_m > 0.0, "cost window", o.window_m, "above 0 m");
  require(o.smallest_m2 >= 0.0, "smallest patch", o.smallest_m2, "at least 0 square metres");
  require(o.threshold > 0.0, "threshold", o.threshold, "above 0");
  require(o.row_m > 0.0, "cost row", o.row_m, "above 0 m");
}

int pixels(double metres, double pixel) {
  return std::max(1, static_cast<int>(std::lround(metres / pixel)));
}

cv::Mat box(const cv::Mat& image, int along, int across) {
  cv::Mat result;
  cv::boxFilter(image, result, CV_32F, {across, along}, {-1, -1}, true, cv::BORDER_REFLECT);
  return result;
}

// Local standard deviation of the levelled, smoothed intensity.
cv::Mat local_variation(const cv::Mat& intensity, const SideScanImage& image, double window_m) {
  const cv::Mat level =
      box(intensity, pixels(kLevelAlong, image.row_m), pixels(kLevelAcross, image.pixel_m));
  cv::Mat levelled = intensity / cv::max(level, 1e-12F);
  const double small = window_m * kSmoothShare;
  levelled = box(levelled, pixels(small, image.row_m), pixels(small, image.pixel_m));
  const int along = pixels(window_m, image.row_m);
  const int across = pixels(window_m, image.pixel_m);
  const cv::Mat mean = box(levelled, along, across);
  const cv::Mat square = box(levelled.mul(levelled), along, across);
  cv::Mat deviation;
  cv::sqrt(cv::max(square - mean.mul(mean), 0.0F), deviation);
  return deviation;
}

float median(const cv::Mat& values) {
  std::vector<float> list(values.begin<float>(), values.end<float>());
  const auto middle = list.begin() + static_cast<std::ptrdiff_t>(list.size() / 2);
  std::nth_element(list.begin(), middle, list.end());
  return *middle;
}

// Variation compared with its surroundings: facets, ripples and speckle raise both.
cv::Mat outstanding(const cv::Mat& variation, const SideScanImage& image) {
  const cv::Mat around =
      box(variation, pixels(kSurroundings, image.row_m), pixels(kSurroundings, image.pixel_m));
  const cv::Mat usual =
      cv::max(around, std::max(kLeastVariation, static_cast<double>(median(variation))));
  cv::Mat ratio;
  cv::divide(variation, usual, ratio, 1.0, CV_32F);
  return cv::max((ratio - 1.0) / kFullCost, 0.0);
}

// Pixels of patches smaller than an object keep no more than half the threshold.
void wipe_small(cv::Mat& cost, double pixel_area, const CostMapOptions& o) {
  const cv::Mat above = cost > o.threshold;
  cv::Mat labels;
  cv::Mat stats;
  cv::Mat centroids;
  const int count = cv::connectedComponentsWithStats(above, labels, stats, centroids, 8);
  std::vector<char> small(static_cast<std::size_t>(count), 0);
  for (int k = 1; k < count; ++k) {
    small[static_cast<std::size_t>(k)] =
        stats.at<int>(k, cv::CC_STAT_AREA) * pixel_area < o.smallest_m2 ? 1 : 0;
  }
  for (int r = 0; r < cost.rows; ++r) {
    for (int c = 0; c < cost.cols; ++c) {
      if (small[static_cast<std::size_t>(labels.at<int>(r, c))]) {
        cost.at<float>(r, c) = 0.5F * static_cast<float>(o.threshold);
      }
    }
  }
}

CostMap gathered(const std::vector<float>& costs, const SideScanImage& image, double row_m) {
  const int per_row = pixels(row_m, image.row_m);
  CostMap map{(image.rows + per_row - 1) / per_row,
              image.columns,
              0.0,
              image.pixel_m,
              {},
              image.nadir_gap_m,
              image.rows * image.row_m};
  map.values.assign(map.index(map.rows, 0), 0.0F);
  for (int r = 0; r < image.rows; ++r) {
    const auto to = map.index(r / per_row, 0);
    const auto from = static_cast<std::size_t>(r) * static_cast<std::size_t>(image.columns);
    for (std::size_t c = 0; c < static_cast<std::size_t>(image.columns); ++c) {
      map.values[to + c] = std::max(map.values[to + c], costs[from + c]);
    }
  }
  return map;
}

void check_heights(const AccordionObservation& observation, const NadirHeights& heights,
                   const CostMapOptions& o) {
  const auto size = static_cast<std::size_t>(std::max(0, heights.rows)) *
                    static_cast<std::size_t>(std::max(0, heights.columns));
  if (size == 0 || heights.columns % 2 != 0 || heights.z.size() != size) {
    throw InvalidInput(
        fmt::format("nadir heights of {} x {} places with {} values; give rows x an even number of "
                    "columns of them, from port to starboard",
                    heights.rows, heights.columns, heights.z.size()));
  }
  const int per_row = pixels(o.row_m, heights.row_m);
  const int rows = (heights.rows + per_row - 1) / per_row;
  if (rows != observation.back.rows || rows != observation.ahead.rows) {
    throw InvalidInput(
        fmt::format("nadir heights of {} pings make {} rows and not {}; "
                    "give one row of heights per ping of the image",
                    heights.rows, rows, observation.back.rows));
  }
}

}  // namespace

std::vector<float> pixel_costs(const SideScanImage& image, bool port, const CostMapOptions& o) {
  check(o);
  std::vector<float> pixels_of_side = port ? image.port : image.starboard;
  const auto size = static_cast<std::size_t>(std::max(0, image.rows)) *
                    static_cast<std::size_t>(std::max(0, image.columns));
  if (size == 0 || pixels_of_side.size() != size) {
    throw InvalidInput(
        fmt::format("a side-scan image of {} x {} pixels with {} values on its {} "
                    "side; give rows x columns of them, at least one",
                    image.rows, image.columns, pixels_of_side.size(), port ? "port" : "starboard"));
  }
  const cv::Mat whole(image.rows, image.columns, CV_32F, pixels_of_side.data());
  const int first =
      std::min(image.columns - 1, static_cast<int>(std::ceil(image.nadir_gap_m / image.pixel_m)));
  cv::Mat cost = local_variation(whole.colRange(first, image.columns).clone(), image, o.window_m);
  cost = outstanding(cost, image);
  wipe_small(cost, image.pixel_m * image.row_m, o);
  cv::Mat result = cv::Mat::zeros(image.rows, image.columns, CV_32F);
  cost.copyTo(result.colRange(first, image.columns));
  return {result.begin<float>(), result.end<float>()};
}

AccordionObservation cost_maps(const SideScanImage& image, bool port_looks_back,
                               const CostMapOptions& o) {
  AccordionObservation observation{gathered(pixel_costs(image, true, o), image, o.row_m),
                                   gathered(pixel_costs(image, false, o), image, o.row_m)};
  if (!port_looks_back) std::swap(observation.back, observation.ahead);
  return observation;
}

void fill_nadir(AccordionObservation& observation, const NadirHeights& heights,
                bool port_looks_back, const CostMapOptions& o) {
  check_heights(observation, heights, o);
  cv::Mat z(heights.rows, heights.columns, CV_32F);
  std::copy(heights.z.begin(), heights.z.end(), z.begin<float>());
  const cv::Mat known = z == z;  // NaN is not itself
  z.setTo(cv::mean(z, known)[0], ~known);
  const cv::Mat mean =
      box(z, pixels(kNadirMean, heights.row_m), pixels(kNadirMean, heights.pixel_m));
  cv::Mat cost = cv::max((z - mean) / kNadirHeight, 0.0F);
  cost.setTo(0.0F, ~known);
  wipe_small(cost, heights.pixel_m * heights.row_m, o);
  const int per_row = pixels(o.row_m, heights.row_m);
  const int half = heights.columns / 2;
  for (int r = 0; r < heights.rows; ++r) {
    for (int c = 0; c < heights.columns; ++c) {
      const bool port = c < half;
      CostMap& map = port == port_looks_back ? observation.back : observation.ahead;
      const int column = port ? half - 1 - c : c - half;
      const int row = r / per_row;
      if (column >= map.columns || row >= map.rows) continue;
      float& value = map.values[map.index(row, column)];
      value = std::max(value, cost.at<float>(r, c));
    }
  }
  for (CostMap* map : {&observation.back, &observation.ahead}) {
    if (half * heights.pixel_m >= map->blind_m - 0.5 * heights.pixel_m) map->blind_m = 0.0;
  }
}

}  // namespace swathplan
