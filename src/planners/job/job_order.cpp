#include "planners/job/job_order.h"

namespace swathplan {
namespace {

std::vector<LineEnds> ends_of_lines(const std::vector<JobLine>& lines) {
  std::vector<LineEnds> result;
  for (const JobLine& line : lines) result.push_back(ends_of_line(line));
  return result;
}

OrderEnds costs_of(const JobWays& ways, const JobEnds& ends) {
  OrderEnds costs;
  if (ends.after) {
    costs.out = [&ways, from = ends_of_line(*ends.after)](const Vec2& at, const Vec2& course) {
      return ways.join_s(from.to, from.course_to, at, course);
    };
  } else if (ends.out) {
    costs.out = [&ways, berth = *ends.out](const Vec2& at, const Vec2& course) {
      return ways.free_s(berth, at, course);
    };
  }
  if (ends.home) {
    costs.home = [&ways, berth = *ends.home](const Vec2& at, const Vec2& course) {
      return ways.free_s(berth, at, -course);
    };
  }
  return costs;
}

LineCost between(const JobWays& ways) {
  return [&ways](const Vec2& a, const Vec2& course_a, const Vec2& b, const Vec2& course_b) {
    return ways.join_s(a, course_a, b, course_b);
  };
}

}  // namespace

std::vector<JobLine> in_given_order(const std::vector<JobLine>& lines, const JobWays& ways,
                                    const JobEnds& ends) {
  const std::vector<LineEnds> at = ends_of_lines(lines);
  std::vector<OrderedLine> forwards, back;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    forwards.push_back({i, false});
    back.push_back({lines.size() - 1 - i, true});
  }
  const OrderEnds costs = costs_of(ways, ends);
  const bool turn =
      order_cost(at, back, between(ways), costs) < order_cost(at, forwards, between(ways), costs);
  return arranged(lines, turn ? back : forwards);
}

std::vector<JobLine> in_best_order(const std::vector<JobLine>& lines, const JobWays& ways,
                                   const JobEnds& ends) {
  if (lines.size() > kMostOrdered) return in_given_order(lines, ways, ends);
  return arranged(lines, line_order(ends_of_lines(lines), between(ways), costs_of(ways, ends)));
}

double estimated_s(const std::vector<JobLine>& lines, const JobWays& ways, const JobEnds& ends) {
  if (lines.empty()) return 0.0;
  const OrderEnds costs = costs_of(ways, ends);
  const LineEnds first = ends_of_line(lines.front());
  const LineEnds last = ends_of_line(lines.back());
  double sum = costs.out ? costs.out(first.from, first.course_from) : 0.0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    sum += sailing_s(lines[i].points);
    if (i > 0) sum += join_before_s(lines[i - 1], lines[i], ways);
  }
  return costs.home ? sum + costs.home(last.to, last.course_to) : sum;
}

double join_before_s(const JobLine& before, const JobLine& line, const JobWays& ways) {
  if (!line.join_before.empty()) {
    std::vector<Waypoint> join = line.join_before;
    join.push_back(line.points.front());
    return sailing_s(join);
  }
  const LineEnds a = ends_of_line(before);
  const LineEnds b = ends_of_line(line);
  return ways.join_s(a.to, a.course_to, b.from, b.course_from);
}

}  // namespace swathplan
