// Draws docs/images/hours.svg: the clock, the area rate of fans and the bound that follows.
//   hours_picture FILE.svg
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "coverage/route/ping_clock.h"
#include "coverage/standards/area_rate.h"
#include "io/files/atomic_file.h"

namespace swathplan {
namespace {

constexpr double kWidth = 1080.0, kHeight = 400.0;
constexpr double kTop = 62.0, kBottom = 330.0;
constexpr double kKm2PerHour = 3600.0 / 1e6;

/// A launch at 4 m/s over cells of 4 m, five soundings in each.
RateQuestion launch() {
  RateQuestion question;
  question.sonar = *sonar_preset("em2040");
  question.max_half_angle = Angle::degrees(70);
  question.cell_m = 4.0;
  question.soundings = 5.0;
  question.max_speed_mps = 4.0;
  return question;
}

/// A chart's frame: values to places of the picture.
struct Axes {
  double left, right, x0, x1, y1;
  [[nodiscard]] double x(double v) const { return left + (v - x0) / (x1 - x0) * (right - left); }
  [[nodiscard]] double y(double v) const { return kBottom - v / y1 * (kBottom - kTop); }
};

class Svg {
 public:
  void text(double x, double y, const std::string& words, const std::string& anchor = "middle",
            const std::string& more = "") {
    body_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y,
                         anchor, more, words);
  }
  void line(double x0, double y0, double x1, double y1, const std::string& style) {
    body_ += fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" {}/>\n", x0, y0, x1, y1, style);
  }
  void curve(const std::vector<std::array<double, 2>>& points, const std::string& style) {
    std::string d;
    for (const auto& p : points) {
      d += fmt::format("{}{:.1f} {:.1f}", d.empty() ? "M" : "L", p[0], p[1]);
    }
    body_ += fmt::format("<path d=\"{}\" {}/>\n", d, style);
  }
  void dot(double x, double y, const std::string& colour) {
    body_ +=
        fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4.5\" fill=\"{}\"/>\n", x, y, colour);
  }
  void raw(const std::string& element) { body_ += element + "\n"; }
  [[nodiscard]] std::string whole() const {
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
        "height=\"{1}\" font-family=\"sans-serif\" font-size=\"13\" fill=\"#1d2733\">\n"
        "<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n{2}</svg>\n",
        kWidth, kHeight, body_);
  }

 private:
  std::string body_;
};

const std::string kBold = " font-weight=\"bold\" font-size=\"15\"";
const std::string kThin = "fill=\"none\" stroke=\"#b9c4cf\"";
const std::string kInk = "fill=\"none\" stroke=\"#1d2733\" stroke-width=\"1.5\"";

void frame(Svg& svg, const Axes& axes, const std::string& title, const std::string& below,
           const std::string& beside, double x_step, double y_step) {
  svg.text(0.5 * (axes.left + axes.right), 30, title, "middle", kBold);
  for (double v = 0.0; v <= axes.y1 + 1e-9; v += y_step) {
    svg.line(axes.left, axes.y(v), axes.right, axes.y(v), kThin);
    svg.text(axes.left - 7, axes.y(v) + 4, fmt::format("{:g}", v), "end");
  }
  for (double v = axes.x0; v <= axes.x1 + 1e-9; v += x_step) {
    svg.line(axes.x(v), kBottom, axes.x(v), kBottom + 5, kInk);
    svg.text(axes.x(v), kBottom + 20, fmt::format("{:g}", v));
  }
  svg.line(axes.left, kBottom, axes.right, kBottom, kInk);
  svg.text(0.5 * (axes.left + axes.right), kBottom + 42, below);
  svg.text(axes.left - 30, kTop - 12, beside, "start");
}

/// A boat over level ground, its fan, and how long the farthest sounding takes.
void draw_clock(Svg& svg) {
  const RateQuestion q = launch();
  constexpr double kDepth = 80.0;
  const Angle half = Angle::degrees(60);
  const PingTiming timing{.spacing_m = std::nullopt};
  const double range = kDepth / cos(half);
  const double wait = ping_interval_s(q.sonar, timing, range);
  const double apart = ping_spacing_m(q.sonar, timing, kDepth, half, q.max_speed_mps);
  constexpr double kMiddle = 165.0, kWater = 92.0, kGround = 212.0;
  const double reach = (kGround - kWater) * tan(half) * 0.62;  // drawn narrower than it is
  svg.text(kMiddle, 30, "The clock", "middle", kBold);
  svg.raw(fmt::format("<path d=\"M{:.1f} {}L{:.1f} {}L{:.1f} {}Z\" fill=\"#dcecf7\"/>", kMiddle,
                      kWater, kMiddle - reach, kGround, kMiddle + reach, kGround));
  svg.line(30, kWater, 300, kWater, "stroke=\"#3a86c8\" stroke-width=\"1.5\"");
  svg.line(30, kGround, 300, kGround, "stroke=\"#8a6d3b\" stroke-width=\"3\"");
  svg.line(kMiddle, kWater, kMiddle + reach, kGround, "stroke=\"#0b5cad\" stroke-width=\"2\"");
  svg.line(kMiddle, kWater, kMiddle, kGround, "stroke=\"#5a6672\" stroke-dasharray=\"4 4\"");
  svg.raw(fmt::format("<path d=\"M{0} {1}h36l-7 12h-22z\" fill=\"#1d2733\"/>", kMiddle - 18,
                      kWater - 9));
  svg.text(kMiddle - 8, 168, fmt::format("d = {:g} m", kDepth), "end");
  svg.text(kMiddle + 10, 168, fmt::format("t = {:g}°", half.deg()), "start");
  svg.text(kMiddle + 66, 136, "R = d / cos t", "start");
  svg.text(kMiddle + 84, 154, fmt::format("= {:.0f} m", range), "start");
  svg.text(kMiddle, 252, fmt::format("T = 2 R / (0.9 c) = {:.2f} s from ping to ping", wait));
  svg.text(kMiddle, 276, fmt::format("at {:g} m/s one ping each {:.2f} m", q.max_speed_mps, apart));
  svg.text(kMiddle, 300, "deeper, wider or faster: farther apart");
}

void draw_rates(Svg& svg) {
  const Axes axes{400, 690, 0, 70, 8};
  frame(svg, axes, "Area rate of a fan", "half-angle t, degrees", "A = 2 d v tan t, km² an hour",
        10, 2);
  const RateQuestion q = launch();
  const std::array<std::pair<double, const char*>, 4> depths{
      {{25, "#0072b2"}, {60, "#d55e00"}, {120, "#009e73"}, {190, "#cc79a7"}}};
  for (const auto& [depth, colour] : depths) {
    std::vector<std::array<double, 2>> points;
    for (double t = 1.0; t <= 70.0; t += 0.25) {
      const auto rate = area_rate(q, depth, Angle::degrees(t));
      if (rate) points.push_back({axes.x(t), axes.y(rate->rate_m2ps * kKm2PerHour)});
    }
    svg.curve(points, fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"2\"", colour));
    const auto best = best_area_rate(q, depth);
    const double x = axes.x(best->half_angle.deg());
    const double y = axes.y(best->rate_m2ps * kKm2PerHour);
    svg.dot(x, y, colour);
    const bool right = depth == 120.0;  // clear of the curve beside it
    svg.text(right ? x + 8 : x - 9, y - 7, fmt::format("{:g} m", depth), right ? "start" : "end",
             fmt::format(" style=\"fill:{}\"", colour));
  }
}

void draw_bound(Svg& svg) {
  const Axes axes{780, 1060, 0, 250, 8};
  frame(svg, axes, "The bound", "depth below the sonar, m", "largest A, km² an hour", 50, 2);
  const RateQuestion q = launch();
  std::vector<std::array<double, 2>> points;
  for (double depth = 2.0; depth <= 250.0; depth += 1.0) {
    const auto best = best_area_rate(q, depth);
    if (best) points.push_back({axes.x(depth), axes.y(best->rate_m2ps * kKm2PerHour)});
  }
  svg.curve(points, "fill=\"none\" stroke=\"#0b5cad\" stroke-width=\"2.5\"");
  for (const double depth : {25.0, 60.0, 120.0, 190.0}) {
    const auto best = best_area_rate(q, depth);
    svg.dot(axes.x(depth), axes.y(best->rate_m2ps * kKm2PerHour), "#0b5cad");
    svg.text(axes.x(depth) + 7, axes.y(best->rate_m2ps * kKm2PerHour) + 17,
             fmt::format("{:.0f}°", 2.0 * best->half_angle.deg()), "start");
  }
}

}  // namespace
}  // namespace swathplan

int main(int count, char** words) try {
  if (count != 2) {
    fmt::print(stderr, "usage: hours_picture FILE.svg\n");
    return 2;
  }
  swathplan::Svg svg;
  swathplan::draw_clock(svg);
  swathplan::draw_rates(svg);
  swathplan::draw_bound(svg);
  svg.text(540, 392,
           "em2040, 400 beams, launch at 4 m/s, cells of 4 m, 5 soundings in each. Least hours of "
           "a site = "
           "sum of its cells' area / largest A",
           "middle", " font-size=\"12\"");
  swathplan::write_text_atomically(words[1], svg.whole());
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "error: {}\n", error.what());
  return 1;
}
