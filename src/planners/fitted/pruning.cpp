#include "planners/fitted/pruning.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "planners/fitted/sounded_stretches.h"
#include "planners/rows/route_stretches.h"

namespace swathplan {
namespace {

/// An end is shortened by so many pieces of a line at once, at most.
constexpr std::size_t kMostPiecesOff = 10;
constexpr std::size_t kNoLine = std::numeric_limits<std::size_t>::max();
/// What turns may take of a line that is as short as it may be.
constexpr double kCutShare = 0.02;
/// A change that saves less than this is none, seconds.
constexpr double kLeastSaved = 0.5;

/// Drops a line, or shortens the ends on both sides of a join.
struct Change {
  std::size_t line = kNoLine;  ///< to drop; else
  std::size_t before = kNoLine, after = kNoLine;
  std::size_t off_before = 0, off_after = 0;  ///< pieces
  double lost = 0.0;                          ///< cells
  double saved_s = 0.0;
  [[nodiscard]] double price() const { return lost / saved_s; }
};

class Pruner {
 public:
  Pruner(const SoundedLines& lines, const LineWorkshop& shop, const PruneOptions& options)
      : shop_(shop), lines_(lines) {
    soundings_.assign(lines_.scored.grid.words().size(), 0);
    for (const SoundedLine& line : lines_.lines) {
      for (const SoundedPiece& piece : line.pieces) {
        for (const auto& [cell, count] : piece.cells) soundings_[cell] += count;
      }
    }
    detour_s_ = options.detour_s;
    wanted_ = static_cast<std::uint32_t>(std::ceil(shop.options().soundings));
    const auto covered = static_cast<double>(std::count_if(
        soundings_.begin(), soundings_.end(), [&](std::uint32_t n) { return n >= wanted_; }));
    const auto cells = static_cast<double>(lines_.counting);
    spare_ = covered - options.goal_pct / 100.0 * cells;
    seconds_of_cell_ = options.seconds_of_point * 100.0 / std::max(cells, 1.0);
    const std::size_t n = lines_.lines.size();
    for (std::size_t i = 0; i < n; ++i) {
      first_.push_back(0);
      last_.push_back(lines_.lines[i].pieces.size());
      previous_.push_back(i > 0 ? i - 1 : kNoLine);
      next_.push_back(i + 1 < n ? i + 1 : kNoLine);
    }
    gone_.assign(n, 0);
    fresh_.assign(n + 1, 0);
  }

  PrunedRoute run() {
    PrunedRoute result;
    if (spare_ > 0.0) {
      drop_short(result);
      for (std::size_t i = 0; i < lines_.lines.size(); ++i) {
        if (gone_[i] == 0) look_at(i);
      }
      change(result);
    }
    if (result.dropped + result.trimmed > 0) result.built = shop_.join(runs());
    return result;
  }

 private:
  [[nodiscard]] const SoundedLine& line(std::size_t i) const { return lines_.lines[i]; }

  // --- what a change costs

  [[nodiscard]] double uncover(const SoundedPiece& piece) {
    double lost = 0.0;
    for (const auto& [cell, count] : piece.cells) {
      std::uint32_t& n = soundings_[cell];
      lost += n >= wanted_ && n - count < wanted_ ? 1.0 : 0.0;
      n -= count;
    }
    return lost;
  }
  void cover(const SoundedPiece& piece) {
    for (const auto& [cell, count] : piece.cells) soundings_[cell] += count;
  }

  /// Seconds from line i to line j once so many pieces more are off their ends.
  [[nodiscard]] double join_s(std::size_t i, std::size_t off_i, std::size_t j,
                              std::size_t off_j) const {
    if (i == kNoLine || j == kNoLine) return 0.0;
    const auto& a = line(i).points;
    const auto& b = line(j).points;
    const std::size_t end = line(i).pieces[last_[i] - off_i - 1].end;
    const std::size_t begin = line(j).pieces[first_[j] + off_j].begin;
    return shop_.join_seconds(a[end].position, (a[end].position - a[end - 1].position).normalized(),
                              b[begin].position,
                              (b[begin + 1].position - b[begin].position).normalized());
  }

  [[nodiscard]] std::optional<Change> dropping(std::size_t i) {
    Change change;
    change.line = i;
    const std::size_t before = previous_[i];
    const std::size_t after = next_[i];
    if (before == kNoLine && after == kNoLine) return std::nullopt;
    change.saved_s = join_s(before, 0, i, 0) + join_s(i, 0, after, 0) - join_s(before, 0, after, 0);
    if (unjoined(i)) change.saved_s += detour_s_;
    if (after != kNoLine && unjoined(after)) change.saved_s += detour_s_;
    for (std::size_t k = first_[i]; k < last_[i]; ++k) {
      change.saved_s += line(i).pieces[k].seconds;
      change.lost += uncover(line(i).pieces[k]);
    }
    for (std::size_t k = first_[i]; k < last_[i]; ++k) cover(line(i).pieces[k]);
    return change;
  }

  /// The best shortening of the ends beside the join from line i to line j.
  [[nodiscard]] std::optional<Change> shortening(std::size_t i, std::size_t j) {
    std::optional<Change> best;
    const std::size_t most_i = i == kNoLine ? 0 : most_off(i, true);
    const std::size_t most_j = j == kNoLine ? 0 : most_off(j, false);
    const double now_s = join_s(i, 0, j, 0);
    double lost_i = 0.0;
    double saved_i = 0.0;
    for (std::size_t a = 0; a <= most_i; ++a) {
      if (a > 0) {
        const SoundedPiece& piece = line(i).pieces[last_[i] - a];
        lost_i += uncover(piece);
        saved_i += piece.seconds;
      }
      double lost = lost_i;
      double saved = saved_i;
      for (std::size_t b = 0; b <= most_j; ++b) {
        if (b > 0) {
          const SoundedPiece& piece = line(j).pieces[first_[j] + b - 1];
          lost += uncover(piece);
          saved += piece.seconds;
        }
        if (a + b == 0) continue;
        Change change{kNoLine, i, j, a, b, lost, saved + now_s - join_s(i, a, j, b)};
        if (change.saved_s < kLeastSaved || change.lost > spare_) continue;
        if (!best || change.price() < best->price() ||
            (change.price() == best->price() && change.saved_s > best->saved_s)) {
          best = change;
        }
      }
      for (std::size_t b = 1; b <= most_j; ++b) cover(line(j).pieces[first_[j] + b - 1]);
    }
    for (std::size_t a = 1; a <= most_i; ++a) cover(line(i).pieces[last_[i] - a]);
    return best;
  }

  /// Whether no way was found that can be steered from the line before.
  [[nodiscard]] bool unjoined(std::size_t i) const {
    const auto& join = line(i).join;
    return fresh_[i] == 0 &&
           std::any_of(join.begin(), join.end(), [](const Waypoint& w) { return !w.feasible; });
  }

  [[nodiscard]] double metres_left(std::size_t i) const {
    double metres = 0.0;
    for (std::size_t k = first_[i]; k < last_[i]; ++k) metres += line(i).pieces[k].metres;
    return metres;
  }

  /// How many pieces may come off an end of line i: it stays long enough.
  [[nodiscard]] std::size_t most_off(std::size_t i, bool end) const {
    double metres = metres_left(i);
    std::size_t n = 0;
    while (n < kMostPiecesOff && n + 1 < last_[i] - first_[i]) {
      metres -= line(i).pieces[end ? last_[i] - n - 1 : first_[i] + n].metres;
      if (metres < shop_.options().least_line_m) break;
      ++n;
    }
    return n;
  }

  // --- changes, the cheapest first

  /// Drops what is shorter than a line may be, what covers least first.
  void drop_short(PrunedRoute& result) {
    std::vector<std::pair<double, std::size_t>> list;
    for (std::size_t i = 0; i < lines_.lines.size(); ++i) {
      if (metres_left(i) >= (1.0 - kCutShare) * shop_.options().least_line_m) continue;
      if (const auto change = dropping(i)) list.emplace_back(change->lost, i);
    }
    std::sort(list.begin(), list.end());
    for (const auto& [lost, i] : list) {
      const auto change = dropping(i);
      if (change && change->lost <= spare_) make(*change, result);
    }
    heap_.clear();
  }

  [[nodiscard]] bool pays(const Change& change) const {
    return change.saved_s >= kLeastSaved && change.lost <= spare_ &&
           change.saved_s > seconds_of_cell_ * change.lost;
  }

  void offer(const std::optional<Change>& change) {
    if (!change || !pays(*change)) return;
    heap_.push_back(*change);
    std::push_heap(heap_.begin(), heap_.end(), dearer);
  }
  /// Offers what can be done at line i and at the join before it.
  void look_at(std::size_t i) {
    if (i == kNoLine) return;
    offer(dropping(i));
    offer(shortening(previous_[i], i));
    if (next_[i] == kNoLine) offer(shortening(i, kNoLine));
  }

  static bool dearer(const Change& a, const Change& b) {
    if (a.price() != b.price()) return a.price() > b.price();
    if (a.saved_s != b.saved_s) return a.saved_s < b.saved_s;
    return a.line + a.after > b.line + b.after;
  }

  [[nodiscard]] bool stands(const Change& c) const {
    if (c.line != kNoLine) return gone_[c.line] == 0;
    if (c.before != kNoLine && (gone_[c.before] != 0 || next_[c.before] != c.after)) return false;
    return c.after == kNoLine || (gone_[c.after] == 0 && previous_[c.after] == c.before);
  }

  void change(PrunedRoute& result) {
    while (!heap_.empty()) {
      std::pop_heap(heap_.begin(), heap_.end(), dearer);
      const Change stored = heap_.back();
      heap_.pop_back();
      if (!stands(stored)) continue;
      // What others alone had covered may be covered by this one alone by now.
      const std::optional<Change> now =
          stored.line != kNoLine ? dropping(stored.line) : shortening(stored.before, stored.after);
      if (!now || !pays(*now)) continue;
      if (!heap_.empty() && dearer(*now, heap_.front())) {
        offer(now);
        continue;
      }
      make(*now, result);
    }
  }

  void make(const Change& c, PrunedRoute& result) {
    spare_ -= c.lost;
    if (c.line != kNoLine) {
      const std::size_t i = c.line;
      for (std::size_t k = first_[i]; k < last_[i]; ++k) {
        static_cast<void>(uncover(line(i).pieces[k]));
      }
      gone_[i] = 1;
      ++result.dropped;
      if (previous_[i] != kNoLine) next_[previous_[i]] = next_[i];
      if (next_[i] != kNoLine) previous_[next_[i]] = previous_[i];
      fresh_[next_[i] == kNoLine ? lines_.lines.size() : next_[i]] = 1;
      look_at(previous_[i]);
      look_at(next_[i]);
      return;
    }
    for (std::size_t k = 0; k < c.off_before; ++k) {
      static_cast<void>(uncover(line(c.before).pieces[--last_[c.before]]));
    }
    for (std::size_t k = 0; k < c.off_after; ++k) {
      static_cast<void>(uncover(line(c.after).pieces[first_[c.after]++]));
    }
    result.trimmed += (c.off_before > 0 ? 1U : 0U) + (c.off_after > 0 ? 1U : 0U);
    fresh_[c.after == kNoLine ? lines_.lines.size() : c.after] = 1;
    look_at(c.before);
    look_at(c.after);
  }

  // --- the route again

  /// Runs of lines between which the joins stay. Each is added as one line.
  [[nodiscard]] std::vector<std::vector<Waypoint>> runs() const {
    std::vector<std::vector<Waypoint>> result;
    for (std::size_t i = 0; i < lines_.lines.size(); ++i) {
      if (gone_[i] != 0) continue;
      const auto& points = line(i).points;
      const std::size_t begin = line(i).pieces[first_[i]].begin;
      const std::size_t end = line(i).pieces[last_[i] - 1].end;
      if (result.empty() || fresh_[i] != 0) {
        result.emplace_back();
      } else {
        result.back().pop_back();
        result.back().insert(result.back().end(), line(i).join.begin(), line(i).join.end());
      }
      result.back().insert(result.back().end(), points.begin() + static_cast<std::ptrdiff_t>(begin),
                           points.begin() + static_cast<std::ptrdiff_t>(end) + 1);
    }
    return result;
  }

  const LineWorkshop& shop_;
  const SoundedLines& lines_;
  std::vector<std::uint32_t> soundings_;  ///< of each cell
  std::uint32_t wanted_ = 1;
  double spare_ = 0.0;  ///< cells that may be lost
  double detour_s_ = 0.0;
  double seconds_of_cell_ = 0.0;           ///< a cell must save so much at least
  std::vector<std::size_t> first_, last_;  ///< pieces of each line that are left
  std::vector<std::size_t> previous_, next_;
  std::vector<char> gone_;   ///< lines
  std::vector<char> fresh_;  ///< the join before the line is made anew
  std::vector<Change> heap_;
};

}  // namespace

PrunedRoute pruned(const SoundedLines& lines, const LineWorkshop& shop,
                   const PruneOptions& options) {
  return Pruner(lines, shop, options).run();
}

}  // namespace swathplan
