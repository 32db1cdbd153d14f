#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "coverage/judging/judged_survey.h"
#include "coverage/standards/judged_gaps.h"
#include "planners/plan.h"

namespace swathplan {

/// How far a boat may be off, to either side.
struct Unsteadiness {
  double aside_m = 0.0;
  Angle heading;
};

/// What one line shows of one cell, on whichever side the boat is off.
struct ShownCell {
  std::uint32_t cell = 0;                ///< its number among the cells of all grids
  std::uint16_t accepted = 0;            ///< soundings, the fewer of both sides; saturates
  std::uint16_t from_dm = 0, to_dm = 0;  ///< where on the line, tenths of a metre; saturates
  bool cube = false;                     ///< a cube would get the strikes that are asked for
};

/// The cells of a criterion as a boat leaves them that is not steady, line by line. Each line is
/// sailed twice: off to starboard and clockwise of its course, and off to the other side. What it
/// shows of a cell is the less of both, since the boat may be anywhere between; what several lines
/// show adds up. So what is covered here stays so while the boat wanders within these bounds.
/// Pings are thinned to about half a cell; soundings are counted as if all were there.
/// Lines are known by their points, fans and speeds, so that only those are traced that are new.
class ShownCells {
 public:
  ShownCells(const SurveyJudge& judge, const PlanOptions& options, const Unsteadiness& unsteady);

  /// Holds the logged legs of this route from now on, and no others.
  void show(const Route& route) { show(route, {}, 0.0); }
  /// The same of those legs alone that come so near to one of the places; all if there is none.
  void show(const Route& route, const std::vector<Vec2>& places, double near_m);

  /// A logged leg: waypoints of the route that was shown.
  struct Line {
    Leg leg;
    double length_m = 0.0;
  };
  [[nodiscard]] const std::vector<Line>& lines() const { return lines_; }

  /// The criterion's grids with what all lines show. Cells hold the strikes asked for or none.
  [[nodiscard]] std::vector<JudgedGrid> grids() const;
  /// Takes cells out of what is asked, or puts them back: one flag a cell of all grids.
  void ask(const std::vector<CellMask>& asked);

  /// Takes a line out if no cell fails then that did not before, and the density stays.
  bool spare(std::size_t line);
  /// The same with the first or last metres of a line, as many as can be spared, at most `most_m`.
  /// Returns the metres.
  double spare_end(std::size_t line, bool first, double most_m);

  /// Whether enough cells with soundings hold as many as the criterion asks for.
  [[nodiscard]] bool dense() const;
  [[nodiscard]] std::size_t traced() const { return traced_; }  ///< lines, so far

 private:
  using Key = std::vector<double>;
  struct State {
    std::uint32_t accepted = 0;
    std::uint16_t lines = 0, cubes = 0;
  };

  void trace(const std::vector<std::pair<Key, std::vector<Waypoint>>>& lines);
  [[nodiscard]] std::vector<std::vector<ShownCell>> sailed(
      const std::vector<std::pair<Key, std::vector<Waypoint>>>& lines, double side);
  void add(const ShownCell& shown);
  void remove(const ShownCell& shown);
  void tally(std::uint32_t cell, double sign);
  [[nodiscard]] bool lacking(std::size_t cell) const;
  [[nodiscard]] bool poor(std::size_t cell) const;
  /// Whether the cell, which was just taken something from, fails now by a rule that it kept.
  [[nodiscard]] bool fails_anew(const ShownCell& taken) const;
  [[nodiscard]] std::size_t grid_of(std::uint32_t cell) const;

  const SurveyJudge& judge_;
  const PlanOptions& options_;
  Unsteadiness unsteady_;
  ScoreOptions scoring_;
  double thinning_ = 1.0;
  std::vector<std::uint32_t> first_;  ///< cell of each grid
  std::vector<std::uint8_t> asked_;
  std::vector<State> states_;
  std::map<Key, std::vector<ShownCell>> known_;
  std::vector<Line> lines_;
  std::vector<const std::vector<ShownCell>*> shown_;  ///< of each line
  std::vector<std::uint8_t> out_;                     ///< lines that were spared
  std::vector<std::pair<double, double>> kept_;       ///< of each line, metres from its start
  double about_m2_ = 0.0, dense_m2_ = 0.0;
  std::size_t traced_ = 0;
};

}  // namespace swathplan
