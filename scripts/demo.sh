#!/bin/sh
# The main job, once: a sample sheet through freecadcmd to demo/.
set -eu
cd "$(dirname "$0")/.."
. scripts/steps.sh

sheet=resources/samples/l-bracket.png
rm -rf demo
mkdir -p build/freecad-profile # FreeCAD's settings for this run, so that a user's own do not count

say "Demo: $sheet through freecadcmd, which takes a minute or two"
logged demo env LC_ALL=C.UTF-8 GAUSSIANCAD_PYTHON="$PWD/.venv/bin/python" \
    FREECAD_USER_HOME="$PWD/build/freecad-profile" .venv/bin/python \
    resources/scripts/gaussiancad_batch.py "$sheet" --output demo --flat
for file in l-bracket.FCStd l-bracket.step preview.png report.json; do
    [ -s "demo/$file" ] || fail "demo/$file was not written"
done
say "Demo: $(grep -o '1/1 l-bracket: .*' build/demo.log)"
say "Demo: open demo/l-bracket.FCStd in FreeCAD, or look at demo/preview.png and demo/report.json"
