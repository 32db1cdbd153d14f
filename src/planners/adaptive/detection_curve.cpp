#include "planners/adaptive/detection_curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/base/error.h"

namespace swathplan {
namespace {

struct Block {
  double value, weight;
  std::size_t count;
};

// Pool adjacent violators: the closest non-decreasing sequence, and its squared error.
std::vector<double> non_decreasing(const std::vector<double>& y, const std::vector<double>& w) {
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < y.size(); ++i) {
    blocks.push_back({y[i], w[i], 1});
    while (blocks.size() > 1 && blocks[blocks.size() - 2].value > blocks.back().value) {
      const Block last = blocks.back();
      blocks.pop_back();
      Block& b = blocks.back();
      b.value = (b.value * b.weight + last.value * last.weight) / (b.weight + last.weight);
      b.weight += last.weight;
      b.count += last.count;
    }
  }
  std::vector<double> result;
  for (const Block& b : blocks) result.insert(result.end(), b.count, b.value);
  return result;
}

std::vector<double> unimodal(const std::vector<double>& y, const std::vector<double>& w) {
  std::vector<double> best;
  double best_error = std::numeric_limits<double>::infinity();
  for (std::size_t peak = 0; peak < y.size(); ++peak) {
    const auto cut = static_cast<std::ptrdiff_t>(peak);
    auto curve = non_decreasing({y.begin(), y.begin() + cut}, {w.begin(), w.begin() + cut});
    auto tail = non_decreasing({y.rbegin(), y.rend() - cut}, {w.rbegin(), w.rend() - cut});
    curve.insert(curve.end(), tail.rbegin(), tail.rend());
    double error = 0.0;
    for (std::size_t i = 0; i < y.size(); ++i)
      error += w[i] * (curve[i] - y[i]) * (curve[i] - y[i]);
    if (error < best_error) {
      best_error = error;
      best = std::move(curve);
    }
  }
  return best;
}

void check_counts(const DetectionCounts& c) {
  if (c.trials.size() != c.detections.size()) {
    throw InvalidInput(fmt::format("{} trials but {} detections; give one of each per range bin",
                                   c.trials.size(), c.detections.size()));
  }
  if (!(c.step_m > 0.0) || !(c.first_m >= 0.0) || !std::isfinite(c.first_m + c.step_m)) {
    throw InvalidInput(
        fmt::format("range bins from {} m, {} m wide; the first must lie at 0 or "
                    "more and the width be above 0",
                    c.first_m, c.step_m));
  }
  for (std::size_t i = 0; i < c.trials.size(); ++i) {
    if (c.detections[i] < 0 || c.detections[i] > c.trials[i]) {
      throw InvalidInput(
          fmt::format("range bin {}: {} detections in {} trials; must lie in "
                      "[0, trials]",
                      i, c.detections[i], c.trials[i]));
    }
  }
}

}  // namespace

void check(const DetectionCurve& curve, const std::string& what) {
  if (curve.range_m.empty() || curve.range_m.size() != curve.p.size()) {
    throw InvalidInput(
        fmt::format("{}: {} ranges and {} probabilities; give as many of one as of "
                    "the other, at least one",
                    what, curve.range_m.size(), curve.p.size()));
  }
  for (std::size_t i = 0; i < curve.p.size(); ++i) {
    if (!(curve.range_m[i] >= 0.0) || !std::isfinite(curve.range_m[i])) {
      throw InvalidInput(fmt::format("{}: range {} is {} m; must be a finite number of at least 0",
                                     what, i, curve.range_m[i]));
    }
    if (i > 0 && !(curve.range_m[i] > curve.range_m[i - 1])) {
      throw InvalidInput(fmt::format("{}: range {} is {} m after {} m; sort the ranges, each once",
                                     what, i, curve.range_m[i], curve.range_m[i - 1]));
    }
    if (!(curve.p[i] >= 0.0 && curve.p[i] <= 1.0)) {
      throw InvalidInput(
          fmt::format("{}: probability {} is {}; must lie in [0, 1]", what, i, curve.p[i]));
    }
  }
}

double detection(const DetectionCurve& curve, double range_m) {
  const auto at = std::lower_bound(curve.range_m.begin(), curve.range_m.end(), range_m);
  if (at == curve.range_m.end()) return 0.0;
  const auto i = static_cast<std::size_t>(at - curve.range_m.begin());
  if (*at == range_m) return curve.p[i];
  if (i == 0) return 0.0;
  const double t = (range_m - curve.range_m[i - 1]) / (*at - curve.range_m[i - 1]);
  return curve.p[i - 1] + t * (curve.p[i] - curve.p[i - 1]);
}

std::optional<double> admissible_range_m(const DetectionCurve& curve, double threshold) {
  check(curve, "P(y) curve");
  if (!(threshold > 0.0 && threshold < 1.0)) {
    throw UsageError("threshold", fmt::format("{}", threshold), "must lie in (0, 1)");
  }
  const auto peak = std::max_element(curve.p.begin(), curve.p.end());
  if (*peak < threshold) return std::nullopt;
  auto i = static_cast<std::size_t>(peak - curve.p.begin());
  while (i + 1 < curve.p.size() && curve.p[i + 1] >= threshold) ++i;
  if (i + 1 == curve.p.size()) return curve.range_m[i];
  const double t = (curve.p[i] - threshold) / (curve.p[i] - curve.p[i + 1]);
  return curve.range_m[i] + t * (curve.range_m[i + 1] - curve.range_m[i]);
}

DetectionCurve estimated_curve(const DetectionCounts& c) {
  check_counts(c);
  std::vector<double> rate;
  std::vector<double> weight;
  DetectionCurve curve;
  for (std::size_t i = 0; i < c.trials.size(); ++i) {
    if (c.trials[i] == 0) continue;
    rate.push_back(static_cast<double>(c.detections[i]) / static_cast<double>(c.trials[i]));
    weight.push_back(static_cast<double>(c.trials[i]));
    curve.range_m.push_back(c.first_m + (static_cast<double>(i) + 0.5) * c.step_m);
  }
  if (rate.empty()) {
    throw InvalidInput("no range bin holds a trial; nothing can be estimated from this track");
  }
  curve.p = unimodal(rate, weight);
  // Without this, a sonar that reaches to a bin's edge would seem to reach only to its centre.
  const auto found = [](double p) { return p > 0.0; };
  const auto last = std::find_if(curve.p.rbegin(), curve.p.rend(), found);
  if (last == curve.p.rend()) return curve;
  const auto at = curve.p.rend() - last;  // one past the last bin with a detection
  const double edge = curve.range_m[static_cast<std::size_t>(at) - 1] + 0.5 * c.step_m;
  const double p = curve.p[static_cast<std::size_t>(at) - 1];
  curve.range_m.insert(curve.range_m.begin() + at, edge);
  curve.p.insert(curve.p.begin() + at, p);
  return curve;
}

DetectionCurve example_curve() {
  return {{40, 50, 60, 70, 80, 90, 100, 110, 120, 130},
          {0.28, 0.39, 0.45, 0.47, 0.455, 0.41, 0.34, 0.25, 0.15, 0.05}};
}

}  // namespace swathplan
