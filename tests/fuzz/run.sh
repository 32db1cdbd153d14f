#!/usr/bin/env bash
# run.sh BINARIES SECONDS [READER...]: runs each fuzzer so long, from the corpus; new inputs and faults
# are kept beside the binaries, in corpus/ and faults/. Ends with 1 if any fault was found.
# For a night: tests/fuzz/run.sh build/fuzz/bin 3600
set -uo pipefail
tests=$(cd "$(dirname "$0")/.." && pwd)
binaries=$(cd "$1" && pwd)
seconds=$2
shift 2
readers=("$@")
((${#readers[@]})) || readers=(obj ply stl off soundings route area dxf live options)

seeds() {  # READER: its files of the corpus
  local names
  case $1 in
    obj | ply | stl | off | dxf) names="-name *.$1" ;;
    soundings) names="-name *.xyz -o -name *.csv -o -name *.txt -o -name *.emo -o -name *.pnt" ;;
    route) names="-name *.csv -o -name *.geojson -o -name *.plan -o -name *.waypoints -o -name *.lnw \
                  -o -name *.gpx -o -name *.kml -o -name *.rtz" ;;
    area) names="-name *.geojson -o -name *.kml" ;;
    live) names="-name *.live" ;;
    options) names="-name *.toml -o -name score.json" ;;
  esac
  set -f
  # shellcheck disable=SC2086
  find "$tests/corpus" "$tests/fuzz/seeds" -type f -size -64k \( $names \)
  set +f
}

export ASAN_OPTIONS=allocator_may_return_null=1:detect_leaks=0
failed=0
for reader in "${readers[@]}"; do
  mkdir -p "$binaries/corpus/$reader" "$binaries/faults" "$binaries/seeds/$reader"
  seeds "$reader" | while read -r file; do
    cp "$file" "$binaries/seeds/$reader/$(echo "${file#"$tests"/}" | tr / _)"
  done
  echo "== $reader: $seconds s"
  if ! "$binaries/${reader}_fuzz" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=4096 -malloc_limit_mb=100000 \
    -max_len=65536 -print_final_stats=1 -verbosity=0 -artifact_prefix="$binaries/faults/$reader-" \
    "$binaries/corpus/$reader" "$binaries/seeds/$reader" >"$binaries/$reader.log" 2>&1; then
    failed=1
    grep -E "ERROR|runtime error|SUMMARY|Test unit written" "$binaries/$reader.log" | head -5
  fi
  grep -E "number_of_executed_units" "$binaries/$reader.log"
done
exit $failed
