#!/usr/bin/env bash
# Measures the first tables of docs/results-lines.md and prints them as Markdown rows: the plan that
# fitted-lines picks, those that it offers, the picked one under calm noise, processor seconds. Run
# after ./dev build.
#   bench/lines.sh VEHICLE [harbour grid]   VEHICLE: wam-v or small-usv; the grid: sides capped at 70
#   degrees, without noise
set -euo pipefail
cd "$(dirname "$0")/.."
program=${SWATHPLAN:-build/release/bin/swathplan}
vehicle=${1:?VEHICLE: wam-v or small-usv}
grid=${2:-}
out=$(mktemp -d)
trap 'rm -rf "$out" "$out.cpu"' EXIT

row() {  # name, file, cell, noise, options...
  local name=$1 file=$2 cell=$3 noise=$4 calm=-
  shift 4
  local TIMEFORMAT='%U %S'
  { time "$program" plan "$file" --profile paper --vehicle "$vehicle" --resolution "$cell" -o "$out" \
      --quiet "$@" >/dev/null 2>&1; } 2>"$out.cpu"
  if [ "$noise" = calm ]; then
    "$program" score "$file" "$out/route.csv" --profile paper --vehicle "$vehicle" --resolution "$cell" \
      --noise calm -o "$out/calm" --quiet >/dev/null 2>&1
    calm=$(python3 -c 'import json, sys
print("{:.1f}".format(json.load(open(sys.argv[1]))["coverage_hit_pct"]))' "$out/calm/score.json")
  fi
  python3 - "$name" "$out" "$calm" <<'PY'
import json, sys
name, out, calm = sys.argv[1:]
s = json.load(open(out + "/score.json"))
p = json.load(open(out + "/plan.json"))
def text(hit, ratio, infeasible):
    return f"{hit:.2f} @ {ratio:.2f}" + (f" ({infeasible})" if infeasible else "")
others = [text(c["coverage_hit_pct"], c["length_ratio"], c["infeasible_legs"])
          for c in p["choices"] if not c["picked"]]
cpu = sum(map(float, open(out + ".cpu").read().split()))
print(f"| {name} | {text(s['coverage_hit_pct'], s['length_ratio'], s['infeasible_legs'])} "
      f"| {', '.join(others)} | {calm} | {cpu:.0f} s |", flush=True)
PY
}

echo "| case | picked | also offered | calm | planning, CPU |"
echo "|---|---|---|---|---|"
if [ -n "$grid" ]; then
  for cell in 0.10 0.25 0.50; do row "$(basename "$grid") $cell" "$grid" "$cell" none --max-opening 140; done
  exit
fi
for cell in 0.10 0.25; do row "saddle $cell" datasets/saddle.asc "$cell" calm --run-out-margin 10; done
for cell in 0.10 0.25; do row "shaft $cell" datasets/shaft.obj "$cell" calm --run-out-margin 10; done
for cell in 0.10 0.25; do row "harbour $cell" datasets/harbour.asc "$cell" calm; done
