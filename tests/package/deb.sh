#!/bin/sh
# Makes the Debian packages of a build, unpacks the program's and runs it from there.
# usage: deb.sh BUILD
set -eu
build=$1
cd "$build"
rm -rf packages unpacked
cpack --config CPackConfig.cmake >packages.log 2>&1 || { cat packages.log; exit 1; }
deb=$(ls packages/swathplan_*.deb)
size=$(stat -c %s "$deb")
echo "$deb: $size bytes"
[ "$size" -lt 15000000 ]
dpkg-deb -f "$deb" Depends | grep -q libembree
dpkg-deb -x "$deb" unpacked
program=unpacked/usr/bin/swathplan
cmp unpacked/usr/share/swathplan/harbour.asc share/swathplan/harbour.asc
for file in usr/share/man/man1/swathplan-plan.1.gz usr/share/doc/swathplan/copyright \
  usr/share/bash-completion/completions/swathplan; do
  [ -s "unpacked/$file" ]
done
# The sources must not be needed: the program knows no path into them.
if grep -q "$(dirname "$(dirname "$build")")/" "$program"; then
  echo "the program names a path of its source" >&2
  exit 1
fi
"$program" demo --planners back-and-forth --quiet -o unpacked/demo
grep -q '<script' unpacked/demo/report.html
