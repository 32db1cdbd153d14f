#!/usr/bin/env bash
# How much of a plan's coverage stays when the map was wrong or the boat drifts: plans fitted lines on
# a prior that differs from the true seafloor, scores the route on the true one, and prints Markdown
# rows "seafloor, reserve | planned | calm | each prior in turn". Run after ./dev build; a row takes
# 1 to 6 minutes of CPU. A reserve is a --line-margin, 'calm' (--noise calm), or both: 20+calm.
#   [SEAFLOORS="saddle shaft"] bench/robustness.sh [reserve ...]   default 0 20 calm
# The calm column is scored under another seed than plans are judged with.
set -euo pipefail
cd "$(dirname "$0")/.."
program=build/release/bin/swathplan
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
reserves=("$@")
((${#reserves[@]})) || reserves=(0 20 calm)

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

row() {  # name, true seafloor, the same as a grid, reserve, options...
  local name=$1 file=$2 grid=$3 reserve=$4
  shift 4
  local line="| $name, $reserve"
  local plan=("$program" plan --profile paper --hit-only --quiet -o "$out/plan" "$@")
  [[ $reserve == *calm ]] && plan+=(--noise calm)
  [[ $reserve == [0-9]* ]] && plan+=(--line-margin "${reserve%+calm}")
  scored() {  # on the true seafloor, further options
    "$program" score "$file" "$out/plan/route.csv" --profile paper --quiet -o "$out/score" "$@" >/dev/null
    line+=" | $(figures "$out/score/score.json")"
  }
  "${plan[@]}" "$file" >/dev/null
  scored "${score_options[@]}"
  scored "${score_options[@]}" --noise calm --seed 2
  for level in 0.5 -0.5; do
    "${plan[@]}" "$file" --water-level "$level" >/dev/null
    scored "${score_options[@]}"
  done
  coarser "$grid" "$out/prior.tif"
  "${plan[@]}" "$out/prior.tif" >/dev/null
  scored "${score_options[@]}"
  echo "$line |"
}

echo "| seafloor, reserve | planned | calm | prior 0.5 m too deep | 0.5 m too shoal | 4 times coarser |"
echo "|---|---|---|---|---|---|"
# The shaft's mesh stands on no even lattice: its plain and pit on a grid of 1 m.
python3 -c 'print("ncols 101\nnrows 101\nxllcorner -50.5\nyllcorner -50.5\ncellsize 1")
for y in range(-50, 51):
    print(*(-45 if max(abs(x), abs(y)) < 20 else -10 for x in range(-50, 51)))' >"$out/shaft.asc"
score_options=(--resolution 0.10 --hit-only)
for reserve in "${reserves[@]}"; do
  for seafloor in ${SEAFLOORS:-saddle shaft harbour}; do
    case $seafloor in
      saddle) row "saddle 0.10" datasets/saddle.asc datasets/saddle.asc "$reserve" --resolution 0.10 --run-out-margin 10 ;;
      shaft) row "shaft 0.10" datasets/shaft.obj "$out/shaft.asc" "$reserve" --resolution 0.10 --run-out-margin 10 ;;
      harbour) row "harbour 0.10" datasets/harbour.asc datasets/harbour.asc "$reserve" --resolution 0.10 ;;
    esac
  done
done
