#include "planners/job/sorties.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "mesh/base/error.h"

namespace swathplan {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
/// A sortie is for surveying: at least this share of it must be left for a line.
constexpr double kLeastShare = 0.02;
/// Of these shares of a sortie the pieces of lines may be no longer.
constexpr double kPieceShares[] = {1.0, 0.5, 0.25, 0.125};

/// The seconds of any run of an order of lines, from the berth and back.
class Runs {
 public:
  Runs(const std::vector<JobLine>& lines, const JobWays& ways, const Vec2& berth) {
    sums_.push_back(0.0);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const LineEnds ends = ends_of_line(lines[i]);
      out_.push_back(ways.free_s(berth, ends.from, ends.course_from));
      home_.push_back(ways.free_s(berth, ends.to, -ends.course_to));
      join_.push_back(i > 0 ? join_before_s(lines[i - 1], lines[i], ways) : 0.0);
      line_.push_back(sailing_s(lines[i].points));
      sums_.push_back(sums_.back() + join_.back() + line_.back());
    }
  }
  [[nodiscard]] std::size_t size() const { return line_.size(); }
  /// Lines first to last, both included.
  [[nodiscard]] double seconds(std::size_t first, std::size_t last) const {
    return out_[first] + sums_[last + 1] - sums_[first] - join_[first] + home_[last];
  }
  /// The way to a line and back alone.
  [[nodiscard]] double ways_s(std::size_t i) const { return out_[i] + home_[i]; }
  [[nodiscard]] double line_s(std::size_t i) const { return line_[i]; }

 private:
  std::vector<double> out_, home_, join_, line_, sums_;
};

struct Cut {
  std::vector<std::size_t> begins;  ///< of each run
  double seconds = kNever;          ///< of all runs, or of the longest one
};

Cut traced(const std::vector<std::size_t>& from, std::size_t n, double seconds) {
  Cut cut;
  cut.seconds = seconds;
  for (std::size_t end = n; end > 0; end = from[end]) cut.begins.push_back(from[end]);
  std::reverse(cut.begins.begin(), cut.begins.end());
  return cut;
}

/// The least time in all with no run longer than `longest_s`; infinite where a line does not fit.
Cut least_in_all(const Runs& runs, double longest_s) {
  const std::size_t n = runs.size();
  std::vector<double> best(n + 1, kNever);
  std::vector<std::size_t> from(n + 1, 0);
  best[0] = 0.0;
  for (std::size_t end = 1; end <= n; ++end) {
    for (std::size_t first = end; first-- > 0;) {
      const double run = runs.seconds(first, end - 1);
      if (run <= longest_s && best[first] + run < best[end]) {
        best[end] = best[first] + run;
        from[end] = first;
      }
    }
  }
  return best[n] < kNever ? traced(from, n, best[n]) : Cut{};
}

/// The shortest longest run of exactly `parts` runs.
Cut least_longest(const Runs& runs, std::size_t parts, const std::vector<double>& weights) {
  const std::size_t n = runs.size();
  std::vector<double> best(n + 1, kNever);
  best[0] = 0.0;
  std::vector<std::vector<std::size_t>> from(parts, std::vector<std::size_t>(n + 1, 0));
  for (std::size_t part = 0; part < parts; ++part) {
    const double weight = part < weights.size() ? weights[part] : 1.0;
    std::vector<double> next(n + 1, kNever);
    for (std::size_t end = part + 1; end <= n; ++end) {
      for (std::size_t first = end; first-- > part;) {
        const double longest = std::max(best[first], weight * runs.seconds(first, end - 1));
        if (longest < next[end]) {
          next[end] = longest;
          from[part][end] = first;
        }
      }
    }
    best = std::move(next);
  }
  Cut cut;
  cut.seconds = best[n];
  std::size_t end = n;
  for (std::size_t part = parts; part-- > 0;) {
    end = from[part][end];
    cut.begins.insert(cut.begins.begin(), end);
  }
  return cut;
}

std::vector<SortieLines> parts_of(const std::vector<JobLine>& lines, const Cut& cut) {
  std::vector<SortieLines> parts;
  for (std::size_t k = 0; k < cut.begins.size(); ++k) {
    const std::size_t end = k + 1 < cut.begins.size() ? cut.begins[k + 1] : lines.size();
    parts.emplace_back(lines.begin() + static_cast<std::ptrdiff_t>(cut.begins[k]),
                       lines.begin() + static_cast<std::ptrdiff_t>(end));
  }
  return parts;
}

std::string title_of(const JobLine& line) {
  for (const Waypoint& w : line.points) {
    if (w.line) return fmt::format("line {}", *w.line);
  }
  return "a line";
}

/// Lines that do not fit into a sortie, in as few pieces as do.
std::vector<JobLine> fitting(const std::vector<JobLine>& lines, const JobWays& ways,
                             const Vec2& berth, double longest_s) {
  const Runs runs(lines, ways, berth);
  std::vector<JobLine> result;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const double left = longest_s - runs.ways_s(i);
    if (left < kLeastShare * longest_s) {
      throw UsageError(fmt::format(
          "sorties of {:.2f} h are too short: the way from the berth to {} and back takes {:.2f} h "
          "alone; make them longer (<sortie hours>), or choose a nearer <berth>",
          longest_s / 3600.0, title_of(lines[i]), runs.ways_s(i) / 3600.0));
    }
    for (JobLine& piece : in_pieces({lines[i]}, left)) result.push_back(std::move(piece));
  }
  return result;
}

}  // namespace

std::vector<JobLine> in_pieces(const std::vector<JobLine>& lines, double longest_s) {
  constexpr double kRounding = 1e-9;
  std::vector<JobLine> result;
  for (const JobLine& line : lines) {
    const double pieces = std::ceil(sailing_s(line.points) / longest_s - kRounding);
    for (JobLine& piece : divided(line, std::max(1, static_cast<int>(pieces)))) {
      result.push_back(std::move(piece));
    }
  }
  return result;
}

std::vector<SortieLines> cut_into_sorties(const std::vector<JobLine>& lines, const JobWays& ways,
                                          const Vec2& berth, double longest_s) {
  std::vector<SortieLines> best;
  double least = kNever;
  for (const double share : kPieceShares) {
    const std::vector<JobLine> pieces =
        in_pieces(fitting(lines, ways, berth, longest_s), share * longest_s);
    const Cut cut = least_in_all(Runs(pieces, ways, berth), longest_s);
    if (!(cut.seconds < (1.0 - kWorthDividing) * least)) continue;
    least = cut.seconds;
    best = parts_of(pieces, cut);
  }
  if (best.empty() && !lines.empty()) {
    throw UsageError(fmt::format(
        "sorties of {:.2f} h are too short to sail out, survey and come home; make them longer "
        "(<sortie hours>), or choose a nearer <berth>",
        longest_s / 3600.0));
  }
  return best;
}

std::vector<SortieLines> cut_for_boats(const std::vector<JobLine>& lines, const JobWays& ways,
                                       const Vec2& berth, int boats,
                                       const std::vector<double>& weights) {
  double whole = 0.0;
  for (const JobLine& line : lines) whole += sailing_s(line.points);
  std::vector<SortieLines> best;
  double least = kNever;
  for (const double share : kPieceShares) {
    const std::vector<JobLine> pieces = in_pieces(lines, share * whole / boats);
    const std::size_t parts = std::min(pieces.size(), static_cast<std::size_t>(boats));
    const Cut cut = least_longest(Runs(pieces, ways, berth), parts, weights);
    if (!(cut.seconds < (1.0 - kWorthDividing) * least)) continue;
    least = cut.seconds;
    best = parts_of(pieces, cut);
  }
  return best;
}

}  // namespace swathplan
