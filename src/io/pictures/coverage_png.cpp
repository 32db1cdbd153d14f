#include "io/pictures/coverage_png.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "io/pictures/coverage_summary.h"
#include "io/pictures/drawing_internal.h"
#include "io/pictures/scale_bar.h"

namespace swathplan {
namespace {

const cv::Scalar kFaint(120, 110, 100);
constexpr int kMargin = 32, kSmallestWidth = 900;

cv::Scalar bgr(const Rgba& c) { return {double(c.b), double(c.g), double(c.r)}; }

/// The map itself; small grids are enlarged so that a cell is seen.
cv::Mat map_of(const CoverageSummary& summary) {
  const std::vector<Rgba> palette = coverage_palette();
  cv::Mat map(static_cast<int>(summary.rows), static_cast<int>(summary.columns), CV_8UC3);
  for (int r = 0; r < map.rows; ++r) {
    for (int c = 0; c < map.cols; ++c) {
      const std::uint8_t index =
          summary
              .pixels[static_cast<std::size_t>(r) * summary.columns + static_cast<std::size_t>(c)];
      const Rgba& colour = palette[index];
      map.at<cv::Vec3b>(r, c) =
          index == 0 ? internal::kOutsideArea : cv::Vec3b(colour.b, colour.g, colour.r);
    }
  }
  const int zoom = std::max(1, kSmallestWidth / std::max(map.cols, map.rows));
  cv::Mat large;
  cv::resize(map, large, {}, zoom, zoom, cv::INTER_NEAREST);
  return large;
}

void swatch(cv::Mat& picture, cv::Rect box, const Rgba& colour) {
  cv::rectangle(picture, box, bgr(colour), cv::FILLED);
}

/// Soundings per cell at the left, share of empty cells at the right.
void legend(cv::Mat& picture, int top, bool shares, bool logged_counts) {
  const std::vector<Rgba> palette = coverage_palette();
  const int step = 62, bar = 20;
  internal::put_text(picture, "Soundings per cell", {kMargin, top}, 0.5, internal::kInk);
  for (std::size_t i = 0; i < kCoveredNames.size(); ++i) {
    const int x = kMargin + static_cast<int>(i) * step;
    swatch(picture, {x, top + 12, step - 2, bar}, palette[kCovered + i]);
    internal::put_text(picture, kCoveredNames[i], {x, top + 50}, 0.45, kFaint);
  }
  const int left = kMargin + 6 * step + 40, width = 12;
  const std::string none = logged_counts ? "without a logged sounding" : "without a sounding";
  internal::put_text(picture, (shares ? "Share of cells " : "Cells ") + none, {left, top}, 0.5,
                     internal::kInk);
  for (int i = 1; i <= kEmptySteps; ++i) {
    const int at = kEmpty + (shares ? i : kEmptySteps);
    swatch(picture, {left + (i - 1) * width, top + 12, width, bar},
           palette[static_cast<std::size_t>(at)]);
  }
  if (!shares) return;
  internal::put_text(picture, "0+", {left, top + 50}, 0.45, kFaint);
  internal::put_text(picture, "100 %", {left + kEmptySteps * width - 44, top + 50}, 0.45, kFaint);
}

void scale_bar(cv::Mat& picture, int baseline, double metres_per_pixel) {
  const double metres = round_length(metres_per_pixel * 0.22 * picture.cols);
  const int length = static_cast<int>(std::lround(metres / metres_per_pixel));
  const int right = picture.cols - kMargin;
  cv::line(picture, {right - length, baseline}, {right, baseline}, internal::kInk, 3);
  for (const int x : {right - length, right}) {
    cv::line(picture, {x, baseline - 6}, {x, baseline + 6}, internal::kInk, 2);
  }
  internal::put_text(picture, fmt::format("{} m", metres), {right - length, baseline - 14}, 0.5,
                     internal::kInk);
}

cv::Mat picture_of(const CoverageGrid& grid, const std::string& title, bool logged_counts) {
  const CoverageSummary summary = summarise(grid, kPictureSide, logged_counts);
  const cv::Mat map = map_of(summary);
  const int head = title.empty() ? kMargin : kMargin + 44, foot = 150;
  cv::Mat picture(head + map.rows + foot, std::max(map.cols, kSmallestWidth) + 2 * kMargin, CV_8UC3,
                  internal::kPaper);
  const int left = (picture.cols - map.cols) / 2;
  map.copyTo(picture(cv::Rect(left, head, map.cols, map.rows)));
  internal::put_text(picture, title, {kMargin, kMargin + 18}, 0.8, internal::kInk);
  legend(picture, head + map.rows + 40, summary.factor > 1, logged_counts);
  const double zoom = static_cast<double>(map.cols) / summary.columns;
  scale_bar(picture, head + map.rows + foot - 20, grid.resolution_m() * summary.factor / zoom);
  return picture;
}

}  // namespace

void write_coverage_png(const std::filesystem::path& path, const CoverageGrid& grid,
                        const std::string& title, bool logged_counts) {
  internal::write_png(path, picture_of(grid, title, logged_counts));
}

}  // namespace swathplan
