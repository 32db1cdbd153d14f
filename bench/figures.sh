#!/usr/bin/env bash
# Measures the figures of docs/results.md and prints them as Markdown rows: one row a seafloor and
# cell size, "hit % [length ratio]" for each offline planner. Run after ./dev build.
#   bench/figures.sh [harbour grid ...]   further seafloors, sides capped at 70 degrees
set -euo pipefail
cd "$(dirname "$0")/.."
program=build/release/bin/swathplan
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
planners=back-and-forth,multi-depth,nuc,mdnuc

row() {  # name, file, options...
  local name=$1 file=$2
  shift 2
  "$program" compare "$file" --profile paper --planners "$planners" -o "$out" "$@" 2>/dev/null |
    awk -v name="$name" '/^(B&F|MDB&F|NUC|MDNUC) / { row = row sprintf(" | %.1f [%.2f]", $2, $6); outside += $10 }
      END { printf "| %s%s | %.1f |\n", name, row, outside }'
}

echo "| seafloor, cell | B&F | MDB&F | NUC | MDNUC | outside water, m |"
echo "|---|---|---|---|---|---|"
for cell in 0.10 0.25; do
  row "saddle $cell" datasets/saddle.asc --resolution $cell --depth-bands 4
done
for cell in 0.10 0.25; do
  row "shaft $cell" datasets/shaft.obj --resolution $cell --depth-bands 2
done
for cell in 0.10 0.25; do
  row "harbour $cell" datasets/harbour.asc --resolution $cell --depth-bands 2
done
row "saddle 0.10, pings each 0.03 m" datasets/saddle.asc --depth-bands 4 --ping-spacing 0.03
row "shaft 0.10, pings each 0.03 m" datasets/shaft.obj --depth-bands 2 --ping-spacing 0.03
row "saddle 0.10, pings each 0.03 m, faces 0.65 W" datasets/saddle.asc --depth-bands 4 --ping-spacing 0.03 --face-size 0.65
row "shaft 0.10, pings each 0.03 m, faces 0.65 W" datasets/shaft.obj --depth-bands 2 --ping-spacing 0.03 --face-size 0.65
row "shaft 0.10, turning on the spot" datasets/shaft.obj --depth-bands 2 --turn-radius 0.05
for file in "$@"; do
  for cell in 0.10 0.25; do
    row "$(basename "$file") $cell" "$file" --resolution $cell --max-opening 140
  done
done

planners=nuc,mdnuc
echo
echo "| seafloor, cell, on quads | NUC | MDNUC | outside water, m |"
echo "|---|---|---|---|"
for cell in 0.10 0.25; do
  row "saddle $cell" datasets/saddle.asc --faces quad --resolution $cell --depth-bands 4
  row "shaft $cell" datasets/shaft.obj --faces quad --resolution $cell
  row "harbour $cell" datasets/harbour.asc --faces quad --resolution $cell
done
for file in "$@"; do
  row "$(basename "$file") 0.25" "$file" --faces quad --resolution 0.25 --max-opening 140
done
