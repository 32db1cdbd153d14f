#!/usr/bin/env bash
# How much of a plan's coverage stays when the map was wrong or the boat drifts: plans fitted lines on
# a prior that differs from the true seafloor, scores the route on the true one, and prints Markdown
# rows "seafloor, margin | planned | calm | each prior in turn". Run after ./dev build; a row takes
# 1 to 4 minutes of CPU.
#   bench/robustness.sh [margin per cent ...]   default 0 10 20
set -euo pipefail
cd "$(dirname "$0")/.."
program=build/release/bin/swathplan
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
margins=("$@")
((${#margins[@]})) || margins=(0 10 20)

figures() {  # score.json -> "hit [ratio]"
  python3 -c 'import json, sys
s = json.load(open(sys.argv[1]))
print("%.1f [%.2f]" % (s["coverage_hit_pct"], s["length_ratio"]))' "$1"
}

# A survey four times coarser, drawn again on the old grid as a chart would be.
coarser() {  # true seafloor, prior
  local cell extent
  cell=$(gdalinfo "$1" | awk -F'[(,]' '/Pixel Size/ { print $2 }')
  extent=$(gdalinfo -json "$1" | python3 -c 'import json, sys
c = json.load(sys.stdin)["cornerCoordinates"]
print(*c["lowerLeft"], *c["upperRight"])')
  gdalwarp -q -r average -tr "$(python3 -c "print(4 * $cell)")" "$(python3 -c "print(4 * $cell)")" "$1" "$out/coarse.tif"
  # shellcheck disable=SC2086
  gdalwarp -q -overwrite -r cubicspline -tr "$cell" "$cell" -te $extent "$out/coarse.tif" "$2"
  rm "$out/coarse.tif"
}

row() {  # name, true seafloor, the same as a grid, margin, options...
  local name=$1 file=$2 grid=$3 margin=$4
  shift 4
  local line="| $name, $margin %"
  local plan=("$program" plan --line-margin "$margin" --hit-only --quiet -o "$out/plan" "$@")
  scored() {  # on the true seafloor, further options
    "$program" score "$file" "$out/plan/route.csv" --quiet -o "$out/score" "$@" >/dev/null
    line+=" | $(figures "$out/score/score.json")"
  }
  "${plan[@]}" "$file" >/dev/null
  line+=" | $(figures "$out/plan/score.json")"
  scored "${score_options[@]}" --noise calm
  for level in 0.5 -0.5; do
    "${plan[@]}" "$file" --water-level "$level" >/dev/null
    scored "${score_options[@]}"
  done
  coarser "$grid" "$out/prior.tif"
  "${plan[@]}" "$out/prior.tif" >/dev/null
  scored "${score_options[@]}"
  echo "$line |"
}

echo "| seafloor, margin | planned | calm | prior 0.5 m too deep | 0.5 m too shoal | 4 times coarser |"
echo "|---|---|---|---|---|---|"
# The shaft's mesh stands on no even lattice: its plain and pit on a grid of 1 m.
python3 -c 'print("ncols 101\nnrows 101\nxllcorner -50.5\nyllcorner -50.5\ncellsize 1")
for y in range(-50, 51):
    print(*(-45 if max(abs(x), abs(y)) < 20 else -10 for x in range(-50, 51)))' >"$out/shaft.asc"
score_options=(--resolution 0.10 --hit-only)
for margin in "${margins[@]}"; do
  row "saddle 0.10" datasets/saddle.asc datasets/saddle.asc "$margin" --resolution 0.10 --run-out-margin 10
  row "shaft 0.10" datasets/shaft.obj "$out/shaft.asc" "$margin" --resolution 0.10 --run-out-margin 10
  row "harbour 0.10" datasets/harbour.asc datasets/harbour.asc "$margin" --resolution 0.10
done
