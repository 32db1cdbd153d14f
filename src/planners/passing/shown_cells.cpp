#include "planners/passing/shown_cells.h"

#include <algorithm>
#include <cmath>

namespace swathplan {
namespace {

constexpr double kPingsOfCell = 2.0;
constexpr double kMostThinning = 8.0;
/// Density is looked at with thinned pings, so a little more than asked is wanted of it.
constexpr double kDensityReservePct = 0.3;
/// Ends of lines are looked at in steps of this, metres.
constexpr double kSpareStepM = 1.0;
constexpr double kFullCount = 65535.0;

double thinning_of(const SurveyJudge& judge, const PlanOptions& options) {
  const double depth = depth_range(*judge.ground().seafloor).mean;
  const double below = std::max(depth - options.vehicle.draft_m, 0.1);
  const double spacing = ping_spacing_m(options.sonar, options.pings, below,
                                        options.sonar.max_opening / 2.0, options.vehicle.speed_mps);
  return std::clamp(cell_m(judge.criterion(), depth) / kPingsOfCell / spacing, 1.0, kMostThinning);
}

std::uint16_t capped(double count) {
  return static_cast<std::uint16_t>(std::clamp(std::round(count), 0.0, kFullCount));
}

/// What one sailing of a line shows of a cell, while soundings come in.
struct Seen {
  std::uint32_t accepted = 0;
  std::uint16_t from_dm = 0, to_dm = 0;
  bool cube = false;
};

/// Of the cells that both sailings show, the less. Both are in the order of cells.
std::vector<ShownCell> less_of(const std::vector<ShownCell>& a, const std::vector<ShownCell>& b) {
  std::vector<ShownCell> both;
  auto other = b.begin();
  for (const ShownCell& cell : a) {
    while (other != b.end() && other->cell < cell.cell) ++other;
    if (other == b.end() || other->cell != cell.cell) continue;
    both.push_back({cell.cell, std::min(cell.accepted, other->accepted),
                    std::min(cell.from_dm, other->from_dm), std::max(cell.to_dm, other->to_dm),
                    cell.cube && other->cube});
  }
  return both;
}

bool comes_near(const Route& route, const Leg& leg, const std::vector<Vec2>& places,
                double near_m) {
  if (places.empty()) return true;
  for (std::size_t i = leg.first; i < leg.last; ++i) {
    const Vec2& from = route.waypoints[i].position;
    const Vec2 way = route.waypoints[i + 1].position - from;
    for (const Vec2& p : places) {
      const double share =
          std::clamp((p - from).dot(way) / std::max(way.squaredNorm(), 1e-12), 0.0, 1.0);
      if ((from + share * way - p).norm() <= near_m) return true;
    }
  }
  return false;
}

}  // namespace

ShownCells::ShownCells(const SurveyJudge& judge, const PlanOptions& options,
                       const Unsteadiness& unsteady)
    : judge_(judge),
      options_(options),
      unsteady_(unsteady),
      thinning_(thinning_of(judge, options)) {
  scoring_.resolution_m = options.resolution_m;
  scoring_.pings = options.pings;
  scoring_.pings.thinning *= thinning_;
  scoring_.threads = options.threads;
  std::uint32_t cells = 0;
  for (const JudgedGrid& grid : judge.grids()) {
    first_.push_back(cells);
    cells += static_cast<std::uint32_t>(grid.cells.size());
    for (const JudgedCell& cell : grid.cells) asked_.push_back(cell.asked ? 1 : 0);
  }
  states_.resize(cells);
}

void ShownCells::show(const Route& route, const std::vector<Vec2>& places, double near_m) {
  std::vector<std::pair<Key, std::vector<Waypoint>>> fresh;
  std::vector<Key> keys;
  lines_.clear();
  for (const Leg& leg : legs(route)) {
    const Waypoint& first = route.waypoints[leg.first];
    if (!first.log || !first.fan || !comes_near(route, leg, places, near_m)) continue;
    std::vector<Waypoint> points(
        route.waypoints.begin() + static_cast<std::ptrdiff_t>(leg.first),
        route.waypoints.begin() + static_cast<std::ptrdiff_t>(leg.last) + 1);
    Key key;
    Line line{leg, 0.0};
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Waypoint& w = points[i];
      key.insert(key.end(), {w.position.x(), w.position.y()});
      if (i + 1 == points.size()) break;
      line.length_m += (points[i + 1].position - w.position).norm();
      key.insert(key.end(), {w.fan ? w.fan->port.rad() : 0.0, w.fan ? w.fan->starboard.rad() : 0.0,
                             w.speed_mps});
    }
    lines_.push_back(line);
    const bool listed = std::any_of(fresh.begin(), fresh.end(),
                                    [&](const auto& other) { return other.first == key; });
    if (known_.count(key) == 0 && !listed) fresh.emplace_back(key, std::move(points));
    keys.push_back(std::move(key));
  }
  trace(fresh);
  std::fill(states_.begin(), states_.end(), State{});
  about_m2_ = dense_m2_ = 0.0;
  out_.assign(lines_.size(), 0);
  shown_.clear();
  kept_.clear();
  for (std::size_t k = 0; k < keys.size(); ++k) {
    shown_.push_back(&known_.at(keys[k]));
    kept_.emplace_back(0.0, lines_[k].length_m + kSpareStepM);
    for (const ShownCell& shown : *shown_.back()) add(shown);
  }
}

void ShownCells::trace(const std::vector<std::pair<Key, std::vector<Waypoint>>>& lines) {
  if (lines.empty()) return;
  traced_ += lines.size();
  std::vector<std::vector<ShownCell>> shown = sailed(lines, 1.0);
  if (unsteady_.aside_m > 0.0 || unsteady_.heading.rad() > 0.0) {
    const std::vector<std::vector<ShownCell>> other = sailed(lines, -1.0);
    for (std::size_t k = 0; k < shown.size(); ++k) shown[k] = less_of(shown[k], other[k]);
  }
  for (std::size_t k = 0; k < lines.size(); ++k) known_[lines[k].first] = std::move(shown[k]);
}

std::vector<std::vector<ShownCell>> ShownCells::sailed(
    const std::vector<std::pair<Key, std::vector<Waypoint>>>& lines, double side) {
  // One route of all of them, with the sonar off between.
  Route route;
  std::vector<double> start;  // path to each line
  double path = 0.0;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    for (Waypoint w : lines[k].second) {
      if (!route.waypoints.empty()) path += (w.position - route.waypoints.back().position).norm();
      const bool first = route.waypoints.empty() || start.size() == k;
      if (first) start.push_back(path);
      w.kind = LegKind::line;
      w.line = static_cast<int>(k);
      w.log = true;
      w.feasible = true;
      w.region.reset();
      route.waypoints.push_back(w);
    }
    Waypoint& last = route.waypoints.back();
    last.kind = LegKind::transit;
    last.log = false;
    last.fan.reset();
    last.line.reset();
  }
  route.waypoints.back().kind = LegKind::end;
  ScoreOptions scoring = scoring_;
  scoring.noise.lateral_offset_m = side * unsteady_.aside_m;
  scoring.noise.heading_offset = unsteady_.heading * side;

  std::vector<std::vector<ShownCell>> result(lines.size());
  std::vector<Seen> seen(states_.size());
  std::vector<std::uint32_t> touched;
  std::size_t now = 0;
  const auto close = [&] {
    std::sort(touched.begin(), touched.end());
    for (const std::uint32_t cell : touched) {
      Seen& s = seen[cell];
      result[now].push_back({cell, capped(s.accepted * thinning_), s.from_dm, s.to_dm, s.cube});
      s = {};
    }
    touched.clear();
  };
  const std::vector<JudgedGrid>& grids = judge_.grids();
  const auto& features = judge_.criterion().features;
  const auto thin = static_cast<float>(thinning_);
  const auto pings = features ? static_cast<float>(features->pings) : 0.0F;
  const auto beams = features ? static_cast<float>(features->beams) : 0.0F;
  judge_.sound(route, options_.sonar, options_.vehicle, scoring, [&](const auto& soundings) {
    for (const JudgedSounding& s : soundings) {
      if (!s.accepted) continue;
      // Lines that are numbered count by twos (traced_pings.cpp).
      const std::size_t line = (s.line - 2) / 2;
      if (line != now) {
        close();
        now = line;
      }
      const auto dm = capped(10.0 * (static_cast<double>(s.path_m) - start[line]));
      const bool cube = features && s.feature_pings * thin >= pings && s.feature_beams >= beams;
      for (std::size_t g = 0; g < grids.size(); ++g) {
        const JudgedGrid& grid = grids[g];
        const Vec2 at = (s.position - grid.origin) / grid.cell_m;
        if (!(at.x() >= 0.0 && at.y() >= 0.0 && at.x() < grid.columns && at.y() < grid.rows)) {
          continue;
        }
        const auto cell =
            static_cast<std::uint32_t>(first_[g] + static_cast<std::size_t>(at.y()) * grid.columns +
                                       static_cast<std::size_t>(at.x()));
        if (asked_[cell] == 0) continue;
        Seen& c = seen[cell];
        if (c.accepted == 0) {
          touched.push_back(cell);
          c.from_dm = c.to_dm = dm;
        }
        ++c.accepted;
        c.from_dm = std::min(c.from_dm, dm);
        c.to_dm = std::max(c.to_dm, dm);
        c.cube = c.cube || cube;
      }
    }
  });
  close();
  return result;
}

std::vector<JudgedGrid> ShownCells::grids() const {
  std::vector<JudgedGrid> grids = judge_.grids();
  const auto& features = judge_.criterion().features;
  for (std::size_t g = 0; g < grids.size(); ++g) {
    for (std::size_t i = 0; i < grids[g].cells.size(); ++i) {
      const State& state = states_[first_[g] + i];
      JudgedCell& cell = grids[g].cells[i];
      cell.asked = asked_[first_[g] + i] != 0;
      cell.lines = static_cast<std::uint8_t>(std::min<int>(state.lines, 2));
      cell.soundings = cell.accepted = capped(state.accepted);
      if (features && state.cubes > 0) {
        cell.feature_pings = static_cast<float>(features->pings);
        cell.feature_beams = static_cast<float>(features->beams);
      }
    }
  }
  return grids;
}

void ShownCells::ask(const std::vector<CellMask>& asked) {
  for (std::size_t g = 0; g < asked.size(); ++g) {
    for (std::size_t i = 0; i < asked[g].size(); ++i) {
      const auto cell = static_cast<std::uint32_t>(first_[g] + i);
      tally(cell, -1.0);
      asked_[cell] = asked[g][i];
      tally(cell, 1.0);
    }
  }
}

bool ShownCells::spare(std::size_t line) {
  if (out_[line] != 0) return false;
  const auto in = [&](const ShownCell& c) {
    return c.from_dm >= 10.0 * kept_[line].first && c.to_dm <= 10.0 * kept_[line].second;
  };
  for (const ShownCell& c : *shown_[line]) {
    if (in(c)) remove(c);
  }
  const bool fails =
      !dense() || std::any_of(shown_[line]->begin(), shown_[line]->end(),
                              [&](const ShownCell& c) { return in(c) && fails_anew(c); });
  if (fails) {
    for (const ShownCell& c : *shown_[line]) {
      if (in(c)) add(c);
    }
    return false;
  }
  out_[line] = 1;
  return true;
}

double ShownCells::spare_end(std::size_t line, bool first, double most_m) {
  if (out_[line] != 0) return 0.0;
  auto& [from, to] = kept_[line];
  const double before = first ? from : to;
  double spared = 0.0;
  while (spared + kSpareStepM <= most_m) {
    const double next = spared + kSpareStepM;
    const double was_from = from, was_to = to;
    std::vector<const ShownCell*> taken;
    const auto in = [&](const ShownCell& c) {
      return c.from_dm >= 10.0 * was_from && c.to_dm <= 10.0 * was_to;
    };
    (first ? from : to) = first ? before + next : before - kSpareStepM - next;
    for (const ShownCell& c : *shown_[line]) {
      const bool stays = c.from_dm >= 10.0 * from && c.to_dm <= 10.0 * to;
      if (in(c) && !stays) taken.push_back(&c);
    }
    for (const ShownCell* c : taken) remove(*c);
    if (!dense() || std::any_of(taken.begin(), taken.end(),
                                [&](const ShownCell* c) { return fails_anew(*c); })) {
      for (const ShownCell* c : taken) add(*c);
      from = was_from;
      to = was_to;
      break;
    }
    spared = next;
  }
  return spared;
}

bool ShownCells::dense() const {
  if (!judge_.criterion().density) return true;
  const double share = judge_.criterion().density->share_pct + kDensityReservePct;
  return 100.0 * dense_m2_ >= std::min(share, 100.0) * about_m2_ * (1.0 - 1e-12);
}

void ShownCells::add(const ShownCell& shown) {
  tally(shown.cell, -1.0);
  State& state = states_[shown.cell];
  state.accepted += shown.accepted;
  ++state.lines;
  state.cubes = static_cast<std::uint16_t>(state.cubes + (shown.cube ? 1 : 0));
  tally(shown.cell, 1.0);
}

void ShownCells::remove(const ShownCell& shown) {
  tally(shown.cell, -1.0);
  State& state = states_[shown.cell];
  state.accepted -= shown.accepted;
  --state.lines;
  state.cubes = static_cast<std::uint16_t>(state.cubes - (shown.cube ? 1 : 0));
  tally(shown.cell, 1.0);
}

void ShownCells::tally(std::uint32_t cell, double sign) {
  const State& state = states_[cell];
  if (state.lines == 0 || asked_[cell] == 0 || !judge_.criterion().density) return;
  const double side = judge_.grids()[grid_of(cell)].cell_m;
  about_m2_ += sign * side * side;
  if (static_cast<int>(std::min<std::uint32_t>(state.accepted, 65535U)) >=
      judge_.criterion().density->soundings) {
    dense_m2_ += sign * side * side;
  }
}

std::size_t ShownCells::grid_of(std::uint32_t cell) const {
  std::size_t g = first_.size() - 1;
  while (g > 0 && first_[g] > cell) --g;
  return g;
}

bool ShownCells::lacking(std::size_t cell) const {
  return asked_[cell] != 0 && states_[cell].lines < lines_asked(judge_.criterion());
}

bool ShownCells::poor(std::size_t cell) const {
  return asked_[cell] != 0 && states_[cell].lines > 0 && states_[cell].cubes == 0;
}

bool ShownCells::fails_anew(const ShownCell& taken) const {
  const Criterion& criterion = judge_.criterion();
  if (criterion.gap == GapRule::spread || asked_[taken.cell] == 0) return false;
  const std::size_t g = grid_of(taken.cell);
  const JudgedGrid& grid = judge_.grids()[g];
  const auto columns = static_cast<std::ptrdiff_t>(grid.columns);
  const auto rows = static_cast<std::ptrdiff_t>(grid.rows);
  const auto at = static_cast<std::ptrdiff_t>(taken.cell - first_[g]);
  const std::ptrdiff_t row = at / columns;
  const std::ptrdiff_t column = at % columns;
  const auto n = static_cast<std::ptrdiff_t>(criterion.gap_cells);
  // Whether some rectangle of such cells holds this one.
  const auto any_full = [&](std::ptrdiff_t wide, std::ptrdiff_t high, const auto& test) {
    for (std::ptrdiff_t r = std::max<std::ptrdiff_t>(0, row - high + 1);
         r <= std::min(row, rows - high); ++r) {
      for (std::ptrdiff_t c = std::max<std::ptrdiff_t>(0, column - wide + 1);
           c <= std::min(column, columns - wide); ++c) {
        bool full = true;
        for (std::ptrdiff_t y = r; y < r + high && full; ++y) {
          for (std::ptrdiff_t x = c; x < c + wide && full; ++x) {
            full = test(first_[g] + static_cast<std::size_t>(y * columns + x));
          }
        }
        if (full) return true;
      }
    }
    return false;
  };
  const auto lacks = [&](std::size_t cell) { return lacking(cell); };
  const auto is_poor = [&](std::size_t cell) { return poor(cell); };
  const bool newly = states_[taken.cell].lines + 1 >= lines_asked(criterion);
  if (newly && lacking(taken.cell)) {
    const bool gap = criterion.gap == GapRule::row ? any_full(n, 1, lacks) || any_full(1, n, lacks)
                                                   : any_full(n, n, lacks);
    if (gap) return true;
  }
  return criterion.features && taken.cube && poor(taken.cell) && any_full(n, n, is_poor);
}

}  // namespace swathplan
