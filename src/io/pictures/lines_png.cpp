#include "io/pictures/lines_png.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "io/pictures/drawing_internal.h"
#include "io/pictures/scale_bar.h"

namespace swathplan {
namespace {

const cv::Vec3b kMissed(48, 48, 214);
const cv::Vec3b kShoal(250, 244, 232), kDeep(190, 140, 92);
constexpr int kLineMargin = 28, kHead = 62, kFoot = 70;
/// The number of shades of depth. A smooth shade would make the file several times larger.
constexpr double kSteps = 12.0;

class Picture {
 public:
  Picture(const SweptGround& ground, const std::vector<SweptLine>& lines)
      : raster_(ground.raster()) {
    const auto columns = static_cast<double>(raster_.columns());
    const auto rows = static_cast<double>(raster_.rows());
    scale_ = kLinesPictureSide / std::max(columns, rows);
    map_ = cv::Mat(static_cast<int>(rows * scale_), static_cast<int>(columns * scale_), CV_8UC3);
    std::vector<char> is_swept(raster_.size(), 0);
    for (const SweptLine& line : lines) {
      for (const std::uint32_t cell : line.cells) is_swept[cell] = 1;
    }
    find_range();
    paint(is_swept);
    for (const SweptLine& line : lines) draw(line);
  }

  [[nodiscard]] const cv::Mat& map() const { return map_; }
  [[nodiscard]] double metres_per_pixel() const { return raster_.cell_m() / scale_; }
  [[nodiscard]] double shoalest() const { return low_; }
  [[nodiscard]] double deepest() const { return high_; }

 private:
  void find_range() {
    for (std::size_t i = 0; i < raster_.size(); ++i) {
      if (!raster_.in_area(i)) continue;
      low_ = std::min(low_, raster_.depth(i));
      high_ = std::max(high_, raster_.depth(i));
    }
  }

  [[nodiscard]] cv::Vec3b shade(double depth) const {
    const double share = high_ > low_ ? (depth - low_) / (high_ - low_) : 0.0;
    const double t = std::floor(share * kSteps) / kSteps;
    cv::Vec3b colour;
    for (int k = 0; k < 3; ++k) {
      colour[k] = static_cast<unsigned char>(std::lround((1.0 - t) * kShoal[k] + t * kDeep[k]));
    }
    return colour;
  }

  void paint(const std::vector<char>& is_swept) {
    for (int y = 0; y < map_.rows; ++y) {
      const auto r = static_cast<std::size_t>((map_.rows - 1 - y + 0.5) / scale_);
      for (int x = 0; x < map_.cols; ++x) {
        const auto c = static_cast<std::size_t>((x + 0.5) / scale_);
        const std::size_t i = r * raster_.columns() + c;
        map_.at<cv::Vec3b>(y, x) = !raster_.in_area(i) ? internal::kOutsideArea
                                   : is_swept[i] != 0  ? shade(raster_.depth(i))
                                                       : kMissed;
      }
    }
  }

  void draw(const SweptLine& line) {
    constexpr int kShift = 4;  // sixteenths of a pixel
    const Vec2 corner = raster_.centre(0) - Vec2::Constant(0.5 * raster_.cell_m());
    std::vector<cv::Point> points;
    for (const Vec2& p : line.points) {
      const Vec2 at = (p - corner) / metres_per_pixel();
      points.emplace_back(static_cast<int>(std::lround(16.0 * at.x())),
                          static_cast<int>(std::lround(16.0 * (map_.rows - at.y()))));
    }
    cv::polylines(map_, points, false, internal::kInk, 1, cv::LINE_AA, kShift);
  }

  const WaterRaster& raster_;
  double scale_ = 1.0, low_ = 1e300, high_ = 0.0;
  cv::Mat map_;
};

cv::Mat framed(const Picture& drawn, const std::string& title) {
  const cv::Mat& map = drawn.map();
  cv::Mat picture(kHead + map.rows + kFoot, std::max(map.cols, 640) + 2 * kLineMargin, CV_8UC3,
                  internal::kPaper);
  map.copyTo(picture(cv::Rect((picture.cols - map.cols) / 2, kHead, map.cols, map.rows)));
  const std::size_t end = title.find('\n');
  internal::put_text(picture, title.substr(0, end), {kLineMargin, 26});
  if (end != std::string::npos)
    internal::put_text(picture, title.substr(end + 1), {kLineMargin, 48});
  const int base = kHead + map.rows + 46;
  internal::put_text(picture,
                     fmt::format("{:.0f} m (pale) to {:.0f} m deep (blue); missed: red",
                                 drawn.shoalest(), drawn.deepest()),
                     {kLineMargin, base});
  const double metres = round_length(0.2 * map.cols * drawn.metres_per_pixel());
  const int length = static_cast<int>(std::lround(metres / drawn.metres_per_pixel()));
  const int right = picture.cols - kLineMargin;
  cv::line(picture, {right - length, base}, {right, base}, internal::kInk, 2);
  internal::put_text(picture, fmt::format("{} m", metres), {right - length, base - 10});
  return picture;
}

}  // namespace

void write_lines_png(const std::filesystem::path& path, const SweptGround& ground,
                     const std::vector<SweptLine>& lines, const std::string& title) {
  const cv::Mat picture = framed(Picture(ground, lines), title);
  internal::write_png(path, picture, internal::kSmallPng);
}

}  // namespace swathplan
