#!/usr/bin/env bash
# Measures the tables of docs/results-steerable.md and prints them as Markdown rows. Run after
# ./dev build.
#   bench/steerable.sh steer|noise|usv|smooth|joins|rows [harbour grid]   the grid: with 'steer', at
#   0.25 m
set -euo pipefail
cd "$(dirname "$0")/.."
program=build/release/bin/swathplan
out=$(mktemp -d)
trap 'rm -rf "$out" "$out.cpu"' EXIT
planners="back-and-forth multi-depth nuc mdnuc fitted-lines"

# used PLANNER OPTIONS...: sets `options` to those that the planner uses; the program refuses others
used() {
  local planner=$1
  shift
  options=()
  while (($#)); do
    case $1:$planner in
      --depth-bands:multi-depth | --depth-bands:mdnuc | --face-size:nuc | --face-size:mdnuc | \
        --face-size:multi-depth) options+=("$1" "$2") ;;
      --depth-bands:* | --face-size:*) ;;
      *) options+=("$1" "$2") ;;
    esac
    shift 2
  done
}

# one PLANNER FILE FORMAT OPTIONS...: plans, and prints FORMAT with the score's figures in it
one() {
  local planner=$1 file=$2 format=$3
  shift 3
  local options
  used "$planner" "$@"
  local TIMEFORMAT=%U
  { time "$program" plan "$file" --planner "$planner" -o "$out" --profile paper --hit-only --quiet "${options[@]}" >/dev/null 2>&1; } 2>"$out.cpu"
  python3 -c 'import json, re, sys
s = json.load(open(sys.argv[1] + "/score.json"))
p = json.load(open(sys.argv[1] + "/plan.json"))
s["loops"] = next((n.split()[0] for n in p["notes"] if "by a loop" in n), "0")
s["hours"] = s["duration_s"] / 3600
s["cpu_s"] = float(open(sys.argv[1] + ".cpu").read())
note = next((n for n in p["notes"] if "joins smoothed" in n), "")
joins = re.search(r"(\d+) of (\d+) joins.* from (\S+) to (\S+) 1/m", note)
s["joins"] = "{} of {}, {} to {}".format(*joins.groups()) if joins else "arcs"
print(" | " + sys.argv[2].format(**s), end="")' "$out" "$format"
}

row() {  # name, planners, file, format, options...
  local name=$1 which=$2 file=$3 format=$4 planner
  shift 4
  printf '| %s' "$name"
  for planner in $which; do one "$planner" "$file" "$format" "$@"; done
  echo " |"
}

noise_row() {  # name, file, options...
  local name=$1 file=$2 planner noise
  shift 2
  printf '| %s' "$name"
  for planner in $planners; do
    one "$planner" "$file" '{coverage_hit_pct:.1f} [{length_ratio:.2f}]' "$@"
    for noise in calm rough; do
      "$program" score "$file" "$out/route.csv" --profile paper --hit-only --noise $noise --json 2>/dev/null |
        python3 -c 'import json, sys; print(", %.1f" % json.load(sys.stdin)["coverage_hit_pct"], end="")'
    done
  done
  echo " |"
}

saddle=datasets/saddle.asc
steer='{outside_water_m:.1f}, {min_turn_radius_m:.2f}, {infeasible_legs}, {tight_turn_m:.1f}, {hours:.2f}'
figures='{coverage_hit_pct:.1f} [{length_ratio:.2f}]'
case ${1:-steer} in
  steer)
    row saddle "$planners" $saddle "$steer" --depth-bands 4
    row shaft "$planners" datasets/shaft.obj "$steer"
    row harbour "$planners" datasets/harbour.asc "$steer"
    if (($# > 1)); then
      row "$(basename "$2") 0.25" "$planners" "$2" "$steer" --resolution 0.25 --max-opening 140
    fi
    ;;
  noise)  # the same route sailed without errors, calm and rough
    noise_row saddle $saddle --depth-bands 4
    noise_row shaft datasets/shaft.obj
    noise_row harbour datasets/harbour.asc
    ;;
  usv)
    for vehicle in wam-v small-usv; do
      usv="$figures, {infeasible_legs}, {loops}, {tight_turn_m:.1f}"
      row "saddle, $vehicle" "back-and-forth multi-depth nuc mdnuc" $saddle "$usv" --depth-bands 4 --vehicle $vehicle --face-size 1
      row "shaft, $vehicle" "back-and-forth multi-depth nuc mdnuc" datasets/shaft.obj "$usv" --vehicle $vehicle --face-size 1
    done
    ;;
  smooth)
    for smooth in none ipopt; do
      format="$figures, {self_crossings}, {min_turn_radius_m:.2f}, {tight_turn_m:.1f}, {infeasible_legs}"
      row "saddle, $smooth" "nuc mdnuc" $saddle "$format" --depth-bands 4 --smooth $smooth
      row "shaft, $smooth" "nuc mdnuc" datasets/shaft.obj "$format" --smooth $smooth
      row "harbour, $smooth" "nuc mdnuc" datasets/harbour.asc "$format" --smooth $smooth
    done
    ;;
  joins)  # bends of joins, with arcs and smoothed
    which="back-and-forth multi-depth fitted-lines"
    for smooth in none ipopt; do
      format='{coverage_hit_pct:.2f} ({coverage_hit_logged_pct:.1f}) [{length_ratio:.3f}], {joins}, {cpu_s:.1f} s'
      row "saddle, $smooth" "$which" $saddle "$format" --depth-bands 4 --smooth $smooth
      row "shaft, $smooth" "$which" datasets/shaft.obj "$format" --smooth $smooth
      row "harbour, $smooth" "$which" datasets/harbour.asc "$format" --smooth $smooth
    done
    ;;
  rows)  # turns wider than the rows are apart
    for vehicle in launch auv; do
      format='{coverage_hit_pct:.1f} ({coverage_hit_logged_pct:.1f}) [{length_ratio:.2f}], {infeasible_legs}, {infeasible_m:.0f}'
      row "harbour, $vehicle" "back-and-forth multi-depth" datasets/harbour.asc "$format" --vehicle $vehicle
      row "saddle, $vehicle" "back-and-forth multi-depth" $saddle "$format" --depth-bands 4 --vehicle $vehicle
    done
    ;;
esac
