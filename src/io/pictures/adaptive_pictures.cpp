#include "io/pictures/adaptive_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "io/pictures/drawing_internal.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

constexpr int kWidth = 800;
constexpr int kHeight = 440;
constexpr int kLeft = 64, kRight = 150, kTop = 34, kBottom = 48;
const cv::Scalar kChartInk(60, 50, 40);
const cv::Scalar kGrid(225, 225, 225);
const std::array<cv::Scalar, 8> kColours{cv::Scalar(180, 90, 20),  cv::Scalar(40, 120, 230),
                                         cv::Scalar(60, 150, 40),  cv::Scalar(60, 40, 200),
                                         cv::Scalar(170, 80, 140), cv::Scalar(60, 90, 110),
                                         cv::Scalar(180, 160, 20), cv::Scalar(120, 120, 120)};

constexpr double kSmallText = 0.42, kTitleText = 0.5;  // font scales

void text(cv::Mat& image, const std::string& words, cv::Point at, double size = kSmallText) {
  internal::put_text(image, words, at, size, kChartInk);
}

int width_of(const std::string& words) { return internal::text_width(words, kSmallText); }

// A step of 1, 2 or 5 times a power of ten that gives about six of them.
double tick_step(double span) {
  const double raw = span / 6.0;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= raw) return factor * power;
  }
  return 10.0 * power;
}

struct Axes {
  double x0 = 0, x1 = 1, y0 = 0, y1 = 1;
  [[nodiscard]] cv::Point at(double x, double y) const {
    const double u = (x - x0) / (x1 - x0);
    const double v = (y - y0) / (y1 - y0);
    return {kLeft + static_cast<int>(std::lround(u * (kWidth - kLeft - kRight))),
            kHeight - kBottom - static_cast<int>(std::lround(v * (kHeight - kTop - kBottom)))};
  }
};

Axes fitted_axes(const Chart& chart) {
  Axes a{1e300, -1e300, 1e300, -1e300};
  for (const ChartCurve& c : chart.curves) {
    for (const double x : c.x) {
      a.x0 = std::min(a.x0, x);
      a.x1 = std::max(a.x1, x);
    }
    for (const double y : c.y) {
      a.y0 = std::min(a.y0, y);
      a.y1 = std::max(a.y1, y);
    }
  }
  if (!(a.x1 > a.x0)) a.x1 = a.x0 + 1.0;
  if (!(a.y1 > a.y0)) a.y1 = a.y0 + 1.0;
  const double step = tick_step(a.y1 - a.y0);
  a.y0 = std::floor(a.y0 / step) * step;
  a.y1 = std::ceil(a.y1 / step) * step;
  return a;
}

void draw_grid(cv::Mat& image, const Axes& a) {
  const double xs = tick_step(a.x1 - a.x0);
  for (double x = std::ceil(a.x0 / xs - 1e-9) * xs; x <= a.x1 + 1e-9 * xs; x += xs) {
    cv::line(image, a.at(x, a.y0), a.at(x, a.y1), kGrid);
    const std::string label = fmt::format("{:g}", std::abs(x) < 1e-9 * xs ? 0.0 : x);
    text(image, label, a.at(x, a.y0) + cv::Point(-width_of(label) / 2, 18));
  }
  const double ys = tick_step(a.y1 - a.y0);
  for (double y = a.y0; y <= a.y1 + 1e-9 * ys; y += ys) {
    cv::line(image, a.at(a.x0, y), a.at(a.x1, y), kGrid);
    const std::string label = fmt::format("{:g}", std::abs(y) < 1e-9 * ys ? 0.0 : y);
    text(image, label, a.at(a.x0, y) + cv::Point(-width_of(label) - 6, 4));
  }
  cv::rectangle(image, a.at(a.x0, a.y0), a.at(a.x1, a.y1), kChartInk);
}

void draw_curve(cv::Mat& image, const Axes& a, const ChartCurve& curve, const cv::Scalar& colour) {
  for (std::size_t i = 1; i < curve.x.size(); ++i) {
    const cv::Point p = a.at(curve.x[i - 1], curve.y[i - 1]);
    const cv::Point q = a.at(curve.x[i], curve.y[i]);
    if (!curve.dashed) {
      cv::line(image, p, q, colour, 2, cv::LINE_AA);
      continue;
    }
    const int pieces = std::max(1, static_cast<int>(cv::norm(q - p) / 5.0));
    for (int k = 0; k < pieces; k += 2) {
      const double s = static_cast<double>(k) / pieces;
      const double t = std::min(1.0, static_cast<double>(k + 1) / pieces);
      cv::line(image, p + (q - p) * s, p + (q - p) * t, colour, 1, cv::LINE_AA);
    }
  }
}

/// Metres of a track picture on its pixels: one scale for both axes. A box that is far longer than
/// wide is laid on its side, so that it stays readable.
struct TrackFrame {
  double low = 0.0, high = 1.0;  ///< across
  double length_m = 1.0;
  double scale = 1.0;  ///< pixels a metre
  bool lying = false;  ///< along runs to the right, across upwards
  [[nodiscard]] double width() const { return lying ? length_m : high - low; }
  [[nodiscard]] double height() const { return lying ? high - low : length_m; }
  [[nodiscard]] int bottom() const {
    return kTop + static_cast<int>(std::lround(height() * scale));
  }
  [[nodiscard]] cv::Point at(double across, double along) const {
    const double x = lying ? along : across - low, y = lying ? across - low : along;
    return {kLeft + static_cast<int>(std::lround(x * scale)),
            bottom() - static_cast<int>(std::lround(y * scale))};
  }
};

TrackFrame frame_of(const TrackPicture& picture) {
  constexpr double kTallest = 520.0;  // pixels
  TrackFrame frame;
  frame.high = picture.width_m;
  frame.length_m = picture.length_m;
  for (const SurveyTrack& t : picture.tracks) {
    frame.low = std::min(frame.low, t.across_m);
    frame.high = std::max(frame.high, t.across_m);
  }
  frame.lying = picture.length_m > frame.high - frame.low;
  frame.scale = std::min((kWidth - kLeft - 20.0) / frame.width(), kTallest / frame.height());
  return frame;
}

/// Ticks and numbers along both sides, metres.
void draw_track_axes(cv::Mat& image, const TrackFrame& frame) {
  const auto each = [](double low, double high, const auto& draw) {
    const double step = tick_step(high - low);
    for (double v = std::ceil(low / step - 1e-9) * step; v <= high + 1e-9 * step; v += step) {
      draw(v, fmt::format("{:g}", std::abs(v) < 1e-9 * step ? 0.0 : v));
    }
  };
  const auto below = [&](cv::Point p, const std::string& label) {
    p.y = frame.bottom();
    cv::line(image, p, p + cv::Point(0, 5), kChartInk);
    text(image, label, p + cv::Point(-width_of(label) / 2, 18));
  };
  const auto beside = [&](cv::Point p, const std::string& label) {
    p.x = kLeft;
    cv::line(image, p, p + cv::Point(-5, 0), kChartInk);
    text(image, label, p + cv::Point(-width_of(label) - 8, 4));
  };
  each(frame.low, frame.high, [&](double v, const std::string& label) {
    frame.lying ? beside(frame.at(v, 0.0), label) : below(frame.at(v, 0.0), label);
  });
  each(0.0, frame.length_m, [&](double v, const std::string& label) {
    frame.lying ? below(frame.at(0.0, v), label) : beside(frame.at(0.0, v), label);
  });
  text(image,
       frame.lying ? "metres along to the right, across upwards"
                   : "metres across to the right, along upwards",
       {kLeft, frame.bottom() + 38});
}

void draw_shade(cv::Mat& image, const TrackPicture& picture, const TrackFrame& frame) {
  const auto columns = picture.shade.size();
  for (std::size_t c = 0; c < columns; ++c) {
    const double step = picture.width_m / static_cast<double>(columns);
    const double v = std::clamp(picture.shade[c], 0.0, 1.0);
    const cv::Scalar colour(255 - 60 * v, 255 - 20 * v * v - 90 * v, 255 - 150 * v);
    cv::rectangle(image, frame.at(static_cast<double>(c) * step, 0.0),
                  frame.at(static_cast<double>(c + 1) * step, picture.length_m), colour,
                  cv::FILLED);
  }
}

void draw_tracks(cv::Mat& image, const TrackPicture& picture, const TrackFrame& frame) {
  const auto count = static_cast<double>(std::max<std::size_t>(1, picture.tracks.size() - 1));
  for (std::size_t i = 0; i < picture.tracks.size(); ++i) {
    const SurveyTrack& t = picture.tracks[i];
    const double u = static_cast<double>(i) / count;
    const cv::Scalar colour(60 + 20 * u, 30 + 120 * u, 40 + 200 * u);
    const double start = t.outbound ? 0.0 : picture.length_m;
    const double end = picture.length_m - start;
    cv::line(image, frame.at(t.across_m, start), frame.at(t.across_m, end), colour, 2, cv::LINE_AA);
    if (i + 1 == picture.tracks.size()) break;
    const SurveyTrack& n = picture.tracks[i + 1];
    cv::line(image, frame.at(t.across_m, end),
             frame.at(n.across_m, n.outbound ? 0.0 : picture.length_m), colour, 1, cv::LINE_AA);
  }
}

cv::Mat drawn(const TrackPicture& picture) {
  const TrackFrame frame = frame_of(picture);
  cv::Mat image(frame.bottom() + 50, kWidth, CV_8UC3, cv::Scalar::all(255));
  draw_shade(image, picture, frame);
  cv::rectangle(image, frame.at(0.0, 0.0), frame.at(picture.width_m, picture.length_m), kChartInk);
  draw_tracks(image, picture, frame);
  for (const Vec2& o : picture.objects) {
    cv::circle(image, frame.at(o.x(), o.y()), 4, {40, 40, 220}, cv::FILLED, cv::LINE_AA);
  }
  draw_track_axes(image, frame);
  text(image, picture.title, {kLeft, 18}, kTitleText);
  text(image, picture.shade_label,
       {kWidth - 20 - width_of(picture.shade_label), frame.bottom() + 38});
  return image;
}

}  // namespace

void write_chart_png(const std::filesystem::path& path, const Chart& chart) {
  cv::Mat image(kHeight, kWidth, CV_8UC3, cv::Scalar::all(255));
  const Axes axes = fitted_axes(chart);
  draw_grid(image, axes);
  int y = kTop + 10;
  std::size_t colours = 0;
  for (const ChartCurve& curve : chart.curves) {
    // A curve without a name goes with the one before it.
    if (!curve.label.empty()) ++colours;
    const cv::Scalar& colour = kColours[std::max<std::size_t>(1, colours) % kColours.size()];
    draw_curve(image, axes, curve, colour);
    if (curve.label.empty()) continue;
    const cv::Point from(axes.at(axes.x1, axes.y1).x + 10, y);
    cv::line(image, from, from + cv::Point(18, 0), colour, curve.dashed ? 1 : 2, cv::LINE_AA);
    text(image, curve.label, from + cv::Point(24, 4), 0.38);
    y += 18;
  }
  text(image, chart.title, {kLeft, 22}, kTitleText);
  text(image, chart.x_label, {kLeft, kHeight - 10});
  text(image, chart.y_label, {kWidth - kRight - width_of(chart.y_label), 22});
  internal::write_png(path, image, internal::kSmallPng);
}

void write_tracks_png(const std::filesystem::path& path,
                      const std::vector<TrackPicture>& pictures) {
  std::vector<cv::Mat> images;
  images.reserve(pictures.size());
  for (const TrackPicture& picture : pictures) images.push_back(drawn(picture));
  cv::Mat all;
  cv::vconcat(images, all);
  internal::write_png(path, all, internal::kSmallPng);
}

void write_waterfall_png(const std::filesystem::path& path, const SideScanImage& image) {
  cv::Mat grey(image.rows, 2 * image.columns, CV_8U);
  // Intensities span four powers of ten from nadir to the far edge; a root keeps both visible.
  const auto tone = [](float v) {
    return static_cast<uchar>(
        std::clamp(255.0 * std::pow(static_cast<double>(v), 0.4), 0.0, 255.0));
  };
  for (int r = 0; r < image.rows; ++r) {
    const auto first = static_cast<std::size_t>(r) * static_cast<std::size_t>(image.columns);
    const int row = image.rows - 1 - r;
    for (int c = 0; c < image.columns; ++c) {
      const auto pixel = first + static_cast<std::size_t>(c);
      grey.at<uchar>(row, image.columns - 1 - c) = tone(image.port[pixel]);
      grey.at<uchar>(row, image.columns + c) = tone(image.starboard[pixel]);
    }
  }
  internal::write_png(path, grey, internal::kSmallPng);
}

SideScanImage read_waterfall_png(const std::filesystem::path& path, double pixel_m, double row_m,
                                 double nadir_gap_m) {
  // Without this check OpenCV would write a warning of its own to stderr.
  if (!std::filesystem::is_regular_file(path)) {
    throw InvalidInput(fmt::format("{} is no file that can be opened", path.string()));
  }
  const cv::Mat grey = cv::imread(path.string(), cv::IMREAD_GRAYSCALE);
  if (grey.empty() || grey.cols % 2 != 0) {
    throw InvalidInput(
        fmt::format("{} is no waterfall image that can be read; give an 8-bit PNG "
                    "with port and starboard of the same width",
                    path.string()));
  }
  SideScanImage image{grey.rows, grey.cols / 2, pixel_m, row_m, nadir_gap_m, {}, {}};
  const auto intensity = [](uchar v) { return static_cast<float>(std::pow(v / 255.0, 2.5)); };
  for (int r = 0; r < image.rows; ++r) {
    const int row = image.rows - 1 - r;
    for (int c = 0; c < image.columns; ++c) {
      image.port.push_back(intensity(grey.at<uchar>(row, image.columns - 1 - c)));
      image.starboard.push_back(intensity(grey.at<uchar>(row, image.columns + c)));
    }
  }
  return image;
}

}  // namespace swathplan
