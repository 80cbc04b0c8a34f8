#!/bin/sh
# Brings the translations up to the texts in the sources, then compiles them.  In between, translate
# what is marked "unfinished" in GaussianCAD_*.ts.
# Needs Qt 6's lupdate and lrelease (Debian: qt6-l10n-tools): Qt 5's cannot read Python, and would
# remove what it did not find.  QT6_BIN names their folder where they are not found.
set -eu
cd "$(dirname "$0")/../.."

# The first folder whose lupdate is that of Qt 6 and has lrelease beside it.
tools=
for folder in ${QT6_BIN:+"$QT6_BIN"} /usr/lib/qt6/bin /usr/lib64/qt6/bin \
    "$(dirname "$(command -v lupdate || echo /)")"; do
    if [ -x "$folder/lrelease" ] && "$folder/lupdate" -version 2>/dev/null | grep -q 'version 6'; then
        tools=$folder
        break
    fi
done
if [ -z "$tools" ]; then
    echo "update.sh: no lupdate of Qt 6: install qt6-l10n-tools, or set QT6_BIN to its folder" >&2
    exit 1
fi

for file in resources/translations/GaussianCAD_*.ts; do
    # shellcheck disable=SC2046 # one argument a file
    "$tools/lupdate" $(find freecad -name '*.py' | sort) resources/ui/preferences.ui \
        -source-language en -locations none -no-obsolete -ts "$file"
    "$tools/lrelease" "$file" -qm "${file%.ts}.qm"
done
