#!/bin/sh
# Brings the translations up to the texts in the sources, then compiles them; needs Qt's lupdate and
# lrelease.  In between, translate what is marked "unfinished" in GaussianCAD_*.ts.
set -eu
cd "$(dirname "$0")/../.."
for file in resources/translations/GaussianCAD_*.ts; do
    # shellcheck disable=SC2046 # one argument a file
    lupdate $(find freecad -name '*.py') resources/ui/preferences.ui -source-language en \
        -locations none -no-obsolete -ts "$file"
    lrelease "$file" -qm "${file%.ts}.qm"
done
