#include "coverage/cell_outline.h"

#include <algorithm>
#include <tuple>

namespace swathplan {

namespace {

// Directions against the clock, so that a turn to the right is one less.
enum Heading : std::uint8_t { kEast, kNorth, kWest, kSouth };

struct Corner {
  std::uint32_t column, row;
  bool operator==(const Corner&) const = default;
  bool operator<(const Corner& other) const {
    return column != other.column ? column < other.column : row < other.row;
  }
};

// A side of cells, with the cells at its left.
struct Side {
  Corner from;
  Heading heading;
  Corner to;
  bool used = false;
};

using Runs = std::vector<RowRun>;

// The parts of `runs` (one row) that no run of `others` (a neighbouring row) lies beside.
template <class Visit>
void bare_parts(const RowRun* begin, const RowRun* end, const RowRun* others,
                const RowRun* others_end, Visit visit) {
  for (const RowRun* run = begin; run != end; ++run) {
    std::uint32_t at = run->first;
    while (others != others_end && others->end <= run->first) ++others;
    for (const RowRun* o = others; o != others_end && o->first < run->end; ++o) {
      if (o->first > at) visit(at, o->first);
      at = std::max(at, o->end);
    }
    if (at < run->end) visit(at, run->end);
  }
}

std::vector<Side> sides_of(const Runs& runs) {
  std::vector<Side> sides;
  const RowRun* const end = runs.data() + runs.size();
  const RowRun* below = runs.data();
  const RowRun* below_end = below;
  for (const RowRun* row = runs.data(); row != end;) {
    const std::uint32_t r = row->row;
    const RowRun* const next = std::find_if(row, end, [r](const RowRun& o) { return o.row > r; });
    const RowRun* const next_end =
        std::find_if(next, end, [r](const RowRun& o) { return o.row > r + 1; });
    const bool beside = below != below_end && below->row + 1 == r;
    bare_parts(row, next, beside ? below : below_end, below_end,
               [&](std::uint32_t a, std::uint32_t b) {
                 sides.push_back({{a, r}, kEast, {b, r}});
               });
    bare_parts(row, next, next, next_end, [&](std::uint32_t a, std::uint32_t b) {
      sides.push_back({{b, r + 1}, kWest, {a, r + 1}});
    });
    for (const RowRun* run = row; run != next; ++run) {
      sides.push_back({{run->first, r + 1}, kSouth, {run->first, r}});
      sides.push_back({{run->end, r}, kNorth, {run->end, r + 1}});
    }
    below = row;
    below_end = next;
    row = next;
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.from, a.heading) < std::tie(b.from, b.heading);
  });
  return sides;
}

// The side that goes on from the end of `side`. Where two cells meet by a corner, two go on from
// there; the one to the right keeps apart what the corner alone joins.
Side& after(std::vector<Side>& sides, const Side& side) {
  auto found = std::lower_bound(sides.begin(), sides.end(), side.to,
                                [](const Side& s, const Corner& c) { return s.from < c; });
  const auto right = static_cast<Heading>((side.heading + 3) % 4);
  const auto other = found + 1;
  if (other != sides.end() && other->from == side.to && other->heading == right) return *other;
  return *found;
}

}  // namespace

std::size_t corner_count(const Polygon& polygon) {
  std::size_t count = polygon.outer.size();
  for (const Ring& hole : polygon.holes) count += hole.size();
  return count;
}

Polygon cell_outline(const std::vector<RowRun>& runs, const Vec2& origin, double cell_m) {
  std::vector<Side> sides = sides_of(runs);
  Polygon polygon;
  for (Side& first : sides) {
    if (first.used) continue;
    Ring ring;
    Side* side = &first;
    do {
      side->used = true;
      Side& next = after(sides, *side);
      if (next.heading != side->heading) {
        ring.push_back(origin + cell_m * Vec2(next.from.column, next.from.row));
      }
      side = &next;
    } while (side != &first);
    if (signed_area(ring) > 0.0) {
      polygon.outer = std::move(ring);
    } else {
      polygon.holes.push_back(std::move(ring));
    }
  }
  return polygon;
}

}  // namespace swathplan
