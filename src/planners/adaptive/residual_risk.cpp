#include "planners/adaptive/residual_risk.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <opencv2/ml.hpp>

#include "mesh/base/error.h"
#include "mesh/base/random.h"
#include "mesh/base/require.h"

namespace swathplan {
namespace {

void check(const RiskMapOptions& o) {
  require(o.cell_m > 0.0 && std::isfinite(o.cell_m), "risk cell", o.cell_m, "above 0");
  require(o.width_m >= o.cell_m, "width", o.width_m, "at least one cell of the risk map");
  require(o.length_m >= o.cell_m, "length", o.length_m, "at least one cell of the risk map");
  require(o.scatter >= 0.0 && o.scatter < 1.0, "scatter", o.scatter, "in [0, 1)");
}

// A fit to tens of thousands of values costs seconds. This many quantiles give the same result.
constexpr std::size_t kMostSamples = 500;

std::vector<double> quantiles(std::span<const double> values) {
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  if (sorted.size() <= kMostSamples) return sorted;
  std::vector<double> result;
  for (std::size_t i = 0; i < kMostSamples; ++i) {
    result.push_back(sorted[(2 * i + 1) * sorted.size() / (2 * kMostSamples)]);
  }
  return result;
}

// OpenCV's fit begins with clusters that it draws from the thread's own generator, whose state
// depends on all that the thread did before.
class OwnRandomState {
 public:
  explicit OwnRandomState(std::uint64_t seed) : before_(cv::theRNG().state) {
    cv::theRNG().state = mixed_seed(seed, 13);
  }
  ~OwnRandomState() { cv::theRNG().state = before_; }
  OwnRandomState(const OwnRandomState&) = delete;
  OwnRandomState& operator=(const OwnRandomState&) = delete;

 private:
  std::uint64_t before_;
};

}  // namespace

ResidualRiskMap residual_risk(std::span<const SurveyTrack> tracks, const DetectionCurve& truth,
                              const RiskMapOptions& o) {
  check(o);
  check(truth, "true P(y) curve");
  ResidualRiskMap map;
  map.columns = static_cast<int>(std::floor(o.width_m / o.cell_m + 1e-9));
  map.rows = static_cast<int>(std::floor(o.length_m / o.cell_m + 1e-9));
  map.cell_m = o.cell_m;
  map.risk.assign(static_cast<std::size_t>(map.columns) * static_cast<std::size_t>(map.rows), 1.0);
  SeededNumbers numbers(o.seed);
  for (const SurveyTrack& track : tracks) {
    for (int c = 0; c < map.columns; ++c) {
      const double p = detection(truth, std::abs((c + 0.5) * o.cell_m - track.across_m));
      if (p <= 0.0) continue;
      for (int r = 0; r < map.rows; ++r) {
        const double noisy = o.scatter > 0.0 ? p * (1.0 + o.scatter * numbers.normal()) : p;
        const auto cell = static_cast<std::size_t>(r) * static_cast<std::size_t>(map.columns) +
                          static_cast<std::size_t>(c);
        // A look never gives certainty. The risk 1 is kept for cells without data.
        map.risk[cell] *= 1.0 - std::clamp(noisy, 1e-6, 1.0 - 1e-6);
      }
    }
  }
  return map;
}

ResidualRiskMap without_border(const ResidualRiskMap& map, double margin_m) {
  const int skip = static_cast<int>(std::lround(margin_m / map.cell_m));
  ResidualRiskMap inner;
  inner.cell_m = map.cell_m;
  inner.columns = std::max(0, map.columns - 2 * skip);
  inner.rows = std::max(0, map.rows - 2 * skip);
  for (int r = 0; r < inner.rows; ++r) {
    const auto first =
        map.risk.begin() + static_cast<std::ptrdiff_t>(r + skip) * map.columns + skip;
    inner.risk.insert(inner.risk.end(), first, first + inner.columns);
  }
  return inner;
}

double uncovered_share(const ResidualRiskMap& map) {
  if (map.risk.empty()) return 0.0;
  const auto count = std::count(map.risk.begin(), map.risk.end(), 1.0);
  return static_cast<double>(count) / static_cast<double>(map.risk.size());
}

std::vector<double> looked_at(const ResidualRiskMap& map) {
  std::vector<double> values;
  for (const double r : map.risk) {
    if (r < 1.0) values.push_back(r);
  }
  return values;
}

std::vector<int> histogram(std::span<const double> values, int bins) {
  std::vector<int> counts(static_cast<std::size_t>(bins), 0);
  for (const double v : values) {
    const int bin = std::clamp(static_cast<int>(v * bins), 0, bins - 1);
    ++counts[static_cast<std::size_t>(bin)];
  }
  return counts;
}

std::vector<MixtureComponent> fitted_mixture(std::span<const double> values, int count,
                                             std::uint64_t start) {
  if (count < 1 || values.size() < 10 * static_cast<std::size_t>(count)) {
    throw InvalidInput(
        fmt::format("{} values for a mixture of {} components; at least ten per "
                    "component are needed",
                    values.size(), count));
  }
  std::vector<double> sorted = quantiles(values);
  cv::Mat samples(static_cast<int>(sorted.size()), 1, CV_64F, sorted.data());
  const auto em = cv::ml::EM::create();
  em->setClustersNumber(count);
  em->setCovarianceMatrixType(cv::ml::EM::COV_MAT_DIAGONAL);
  em->setTermCriteria({cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 200, 1e-6});
  {
    const OwnRandomState own(start);
    em->trainEM(samples);
  }
  std::vector<cv::Mat> covariances;
  em->getCovs(covariances);
  const cv::Mat fitted = em->getMeans();
  const cv::Mat weights = em->getWeights();
  std::vector<MixtureComponent> result;
  result.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) {
    result.push_back({fitted.at<double>(k),
                      std::sqrt(covariances[static_cast<std::size_t>(k)].at<double>(0)),
                      weights.at<double>(k)});
  }
  std::sort(result.begin(), result.end(),
            [](const auto& a, const auto& b) { return a.mean < b.mean; });
  return result;
}

WorstComponent worst_component(std::span<const double> values, int count, int starts,
                               bool neighbours) {
  const auto means = [&](int components) {
    std::vector<double> result;
    for (int i = 1; i <= std::max(1, starts); ++i) {
      const auto start = static_cast<std::uint64_t>(i);
      result.push_back(fitted_mixture(values, components, start).back().mean);
    }
    std::sort(result.begin(), result.end());
    return result;
  };
  const std::vector<double> asked = means(count);
  WorstComponent worst{asked[asked.size() / 2], asked.front(), asked.back()};
  for (const int other : {count - 1, count + 1}) {
    if (!neighbours || other < 2 || values.size() < 10 * static_cast<std::size_t>(other)) continue;
    const std::vector<double> list = means(other);
    worst.lowest = std::min(worst.lowest, list.front());
    worst.highest = std::max(worst.highest, list.back());
  }
  return worst;
}

}  // namespace swathplan
